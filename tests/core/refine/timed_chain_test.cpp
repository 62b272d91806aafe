#include "core/refine/timed_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "core/base/infinity.h"
#include "core/zones/speed_zones.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

TurnCircle random_circle(test::RandomInputs& random) {
  const Side side = random.unit() < 0.5 ? Side::kLeft : Side::kRight;
  return {random.point(0.0, 30.0), random.uniform(1.3, 4.0), side, kNone};
}

CircleChain random_chain(test::RandomInputs& random, std::size_t size) {
  const auto pose = [&] { return Pose{random.uniform(0, 30), random.uniform(0, 30), random.uniform(-4.0, 4.0)}; };
  CircleChain chain{pose(), pose(), std::max(0.0, random.uniform(-3, 3)), std::max(0.0, random.uniform(-3, 3)), {}};
  for (std::size_t i = 0; i < size; ++i) chain.circles.push_back(random_circle(random));
  chain.place_ends();
  return chain;
}

ChainChange random_change(test::RandomInputs& random, const CircleChain& chain) {
  const auto size = static_cast<std::int64_t>(chain.circles.size());
  const auto first = random.integer(0, size), last = random.integer(first, std::min(size, first + 3));
  auto count = static_cast<std::size_t>(random.integer(0, 2));
  if (first == 0 || last == size) count = std::max<std::size_t>(count, 1);
  ChainChange change{
      static_cast<std::size_t>(first), static_cast<std::size_t>(last), count, {}, chain.lead_in, chain.lead_out};
  for (std::size_t i = 0; i < count; ++i) change.circles[i] = random_circle(random);
  const auto end = [&](std::size_t i) -> TurnCircle& { return change.circles[i]; };
  if (first == 0) {
    change.lead_in = std::max(0.0, random.uniform(-2, 4));
    end(0) = chain.first_circle(change.lead_in, end(0).radius, end(0).side);
  }
  if (last == size) {
    change.lead_out = std::max(0.0, random.uniform(-2, 4));
    end(count - 1) = chain.last_circle(change.lead_out, end(count - 1).radius, end(count - 1).side);
  }
  return change;
}

class TimedChainOf : public testing::TestWithParam<double> {};

TEST_P(TimedChainOf, TimesAChangeAsTheWholePathIsTimed) {
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = GetParam()});
  test::RandomInputs random(5);
  TimedChain timed;
  int compared = 0, not_told = 0;
  for (int i = 0; i < 20000; ++i) {
    if (i % 20 == 0)
      while (!timed.begin(random_chain(random, static_cast<std::size_t>(random.integer(2, 9))), vehicle)) {
      }
    const ChainChange change = random_change(random, timed.chain());
    if (change.size_after(timed.chain().circles.size()) < 2) continue;
    const bool has_lines = timed.lay_out(change);
    const double time = has_lines ? timed.cost_after(change, kInfinity) : 0.0;
    ASSERT_EQ(timed.make(change), has_lines) << "change " << i;
    if (!has_lines) continue;
    if (time == 0.0) {
      ++not_told;
      continue;
    }
    ASSERT_NEAR(time, timed.made_time(), 1e-12 * timed.made_time()) << "change " << i;
    ++compared;
    // What the path before has not: all of it is among the parts laid out.
    for (const PathSegment& segment : timed.made_path()) {
      const auto is_segment = [&segment](const PathSegment& other) {
        return other.start.x == segment.start.x && other.start.y == segment.start.y && other.length == segment.length &&
               other.curvature == segment.curvature;
      };
      const Path before = path_of(timed.chain(), timed.lines());
      EXPECT_TRUE(std::ranges::any_of(before, is_segment) ||
                  std::ranges::any_of(timed.laid_out(), [&](const auto& part) { return is_segment(part.segment()); }))
          << "change " << i;
    }
    if (random.unit() < 0.3) timed.take();
  }
  EXPECT_GT(compared, 1000);
  EXPECT_LT(not_told, compared / 10);
}

INSTANTIATE_TEST_SUITE_P(Accelerations, TimedChainOf, testing::Values(0.5, 2.0, 50.0));

TEST(TimedChain, CostsAChangeAsTheWholePathCosts) {
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0});
  const World world = random_world({.obstacles = 12, .vertices = 6, .fill = 0.1, .seed = 3});
  const ClearanceCost clearance(vehicle, std::make_shared<const Outlines>(world), {.distance = 0.5, .cost = 4.0});
  test::RandomInputs random(7);
  TimedChain timed;
  int compared = 0, not_told = 0, cut_short = 0;
  for (int i = 0; i < 3000; ++i) {
    if (i % 20 == 0)
      while (!timed.begin(random_chain(random, static_cast<std::size_t>(random.integer(2, 9))), vehicle, {}, nullptr,
                          &clearance)) {
      }
    const Path path = path_of(timed.chain(), timed.lines());
    EXPECT_NEAR(timed.end_of(timed.lines().size() - 1).clearance_cost, clearance.of(path), 1e-9);
    const ChainChange change = random_change(random, timed.chain());
    if (change.size_after(timed.chain().circles.size()) < 2) continue;
    if (!timed.lay_out(change)) continue;
    const double cost = timed.cost_after(change, kInfinity), enough = 0.7 * cost;
    const double short_cost = timed.cost_after(change, enough);
    ASSERT_TRUE(timed.make(change));
    EXPECT_NEAR(timed.made_cost(), timed.made_time() + clearance.of(timed.made_path()), 1e-9);
    ASSERT_LE(cost, timed.made_cost() * (1.0 + 1e-12)) << "change " << i;
    ASSERT_GE(short_cost, enough);
    ASSERT_LE(short_cost, cost);
    cut_short += short_cost < cost ? 1 : 0;
    ++(cost > timed.made_cost() * (1.0 - 1e-12) ? compared : not_told);
    if (random.unit() < 0.3) timed.take();
  }
  EXPECT_GT(compared, 500);
  EXPECT_LT(not_told, compared / 10);
  EXPECT_GT(cut_short, 20);
}

// A quarter of the area and more, some of it twice.
SpeedZones random_zones(test::RandomInputs& random) {
  std::vector<Zone> zones;
  for (int i = 0; i < 8; ++i)
    zones.push_back({.area = Polygon::rectangle(random.point(0.0, 30.0), random.uniform(2.0, 12.0), 6.0),
                     .rule = SpeedLimit{random.uniform(0.3, 2.0)}});
  return SpeedZones(zones);
}

TEST(TimedChain, TimesAChangeInZonesAsTheWholePathIsTimed) {
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0});
  test::RandomInputs random(11);
  const SpeedZones zones = random_zones(random);
  TimedChain timed;
  int compared = 0, not_told = 0, slowed = 0;
  for (int i = 0; i < 3000; ++i) {
    if (i % 20 == 0)
      while (!timed.begin(random_chain(random, static_cast<std::size_t>(random.integer(2, 9))), vehicle, {}, &zones)) {
      }
    const ChainChange change = random_change(random, timed.chain());
    if (change.size_after(timed.chain().circles.size()) < 2 || !timed.lay_out(change)) continue;
    const double time = timed.cost_after(change, kInfinity), bound = timed.cost_after(change, 0.0);
    ASSERT_TRUE(timed.make(change));
    ASSERT_LE(bound, time * (1.0 + 1e-12)) << "change " << i;
    slowed += bound < 0.99 * time ? 1 : 0;
    if (time == 0.0) {
      ++not_told;
    } else {
      ASSERT_NEAR(time, timed.made_time(), 1e-9 * timed.made_time()) << "change " << i;
      ++compared;
    }
    if (random.unit() < 0.3) timed.take();
  }
  EXPECT_GT(compared, 500);
  EXPECT_GT(slowed, 200);
  EXPECT_LT(not_told, compared / 10);
}

TEST(TimedChain, KnowsWhenAndHowFastItsLinesArePassed) {
  test::RandomInputs random(6);
  const Vehicle vehicle;
  TimedChain timed;
  for (int i = 0; i < 200; ++i) {
    if (!timed.begin(random_chain(random, 4), vehicle)) continue;
    const Path path = path_of(timed.chain(), timed.lines());
    const SpeedProfile profile = speed_profile(path, vehicle);
    EXPECT_EQ(timed.begin_of(0).time, 0.0);
    EXPECT_NEAR(timed.end_of(timed.lines().size() - 1).time, profile.total_time, 1e-12 * profile.total_time);
    double time = 0.0;
    std::size_t line = 0;
    for (std::size_t k = 0; k < path.size(); ++k) {
      if (path[k].is_line()) {
        while (timed.lines()[line].length != path[k].length) ++line;
        EXPECT_EQ(timed.begin_of(line).time, time);
        EXPECT_EQ(timed.begin_of(line).speed, profile.speeds[k]);
        EXPECT_EQ(timed.end_of(line).speed, profile.speeds[k + 1]);
      }
      time += profile.durations[k];
    }
  }
}

}  // namespace
}  // namespace arcway::internal

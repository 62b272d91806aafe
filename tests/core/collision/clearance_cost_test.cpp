#include "core/collision/clearance_cost.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "tests/support/boxes.h"
#include "tests/support/random_bodies.h"
#include "tests/support/sampled_cost.h"

namespace arcway::internal::clearance_cost_test {
namespace {

using test::box;

std::shared_ptr<const Outlines> outlines_of(const World& world) { return std::make_shared<const Outlines>(world); }

TEST(ClearanceCost, OfAPathIsThatOfItsParts) {
  const World world({{test::square(10.0, -1.0, 2.0), {}}});
  const Vehicle vehicle;
  const ClearanceCost cost(vehicle, outlines_of(world), {.distance = 0.5, .cost = 7.0});
  const double away = 1.0 + vehicle.footprint().left + 0.4;
  const PathSegment line{{0.0, away, 0.0}, 30.0, 0.0};
  const double length = CloseLengths(vehicle, outlines_of(world), 0.5).on(line);
  ASSERT_GT(length, 2.0);
  EXPECT_EQ(cost.of(line), 7.0 * length);
  const Path path{{line.start, 11.0, 0.0}, {line.at(11.0), 19.0, 0.0}};
  EXPECT_NEAR(cost.of(path), 7.0 * length, 1e-11);
  EXPECT_EQ(clearance_cost(nullptr, path), 0.0);
}

TEST(ClearanceCost, IsOfWhatIsPreferredAndOfNothingElse) {
  const World world({box(10, -1, 12, 1)});
  const Vehicle vehicle;
  const auto outlines = outlines_of(world);
  const std::vector<Zone> none{{box(0, 0, 1, 1), SpeedLimit{1.0}}, {box(0, 0, 1, 1), KeepOut{}}};
  EXPECT_EQ(ClearanceCost::of(vehicle, outlines, std::nullopt, none), nullptr);
  std::vector<Zone> zones = none;
  zones.push_back({box(0, 0, 1, 1), KeepClear{0.3, 0.0}});
  const auto measured = ClearanceCost::of(vehicle, outlines, std::nullopt, zones);
  ASSERT_NE(measured, nullptr);
  EXPECT_TRUE(measured->costs_nothing());
  ASSERT_EQ(measured->rules().size(), 1u);
  EXPECT_EQ(measured->rules()[0].zone, 2u);
  const auto both = ClearanceCost::of(vehicle, outlines, ClearancePreference{.distance = 0.5, .cost = 2.0}, zones);
  ASSERT_EQ(both->rules().size(), 2u);
  EXPECT_FALSE(both->costs_nothing());
  EXPECT_EQ(both->rules()[0].zone, kNone);
  EXPECT_EQ(both->rules()[1].close.distance(), 0.3);
}

// The body passes a square. Zones hold a part of where it is close.
TEST(ClearanceCost, OfZonesThatOverlapAddsUp) {
  const World world({box(10, -1, 12, 1)});
  const Vehicle vehicle;
  const double away = 1.0 + vehicle.footprint().left + 0.4;
  const PathSegment line{{0.0, away, 0.0}, 30.0, 0.0};
  const std::vector<Zone> zones{{box(10, 0, 11, 5), KeepClear{0.5, 3.0}},
                                {box(10.5, 0, 11.25, 5), KeepClear{0.5, 8.0}},
                                {box(10, 0, 11, 5), KeepClear{0.3, 50.0}}};  // closer than it gets
  const auto cost =
      ClearanceCost::of(vehicle, outlines_of(world), ClearancePreference{.distance = 0.5, .cost = 1.0}, zones);
  const double everywhere = CloseLengths(vehicle, outlines_of(world), 0.5).on(line);
  EXPECT_NEAR(cost->of(line), everywhere + 3.0 * 1.0 + 8.0 * 0.75, 1e-6);
  EXPECT_NEAR(cost->rules()[1].close_length(line), 1.0, 1e-7);
  EXPECT_NEAR(cost->of(line.reversed()), cost->of(line), 1e-9);
  EXPECT_EQ(cost->rules()[3].close_length(line), 0.0);
}

// A zone with a hole, that may be anywhere among obstacles.
Zone random_zone(test::RandomInputs& random, double side) {
  const double x = random.uniform(0.0, side), y = random.uniform(0.0, side), half = random.uniform(0.2, 0.5) * side;
  Polygon area = box(x - half, y - half, x + half, y + half);
  area.holes.push_back({{x - 1.0, y - 1.0}, {x, y + 1.0}, {x + 1.0, y - 1.0}});
  return {area, KeepClear{random.uniform(0.1, 1.0), random.uniform(0.5, 20.0)}};
}

PathSegment random_motion(test::RandomInputs& random, double side) {
  const Pose start{random.uniform(0, side), random.uniform(0, side), random.uniform(-4.0, 4.0)};
  const Gear gear = random.unit() < 0.5 ? Gear::kForward : Gear::kReverse;
  if (random.unit() < 0.5) return {start, random.uniform(0.0, 15.0), 0.0, gear};
  const double radius = random.uniform(1.3, 6.0), sign = random.unit() < 0.5 ? 1.0 : -1.0;
  return {start, random.uniform(0.0, 1.2 * kTwoPi * radius), sign / radius, gear};
}

TEST(ClearanceCost, InZonesIsThatOfDenseSamples) {
  test::RandomInputs random(3);
  int counted = 0, partly = 0;
  for (std::uint64_t i = 0; i < 80; ++i) {
    const World free = random_world({.obstacles = 6, .vertices = 6, .fill = 0.15, .seed = i});
    const double side = free.box().max.x();
    const World world = free.with_zones({random_zone(random, side), random_zone(random, side)});
    const Vehicle vehicle = i % 2 == 0 ? Vehicle() : test::random_body_vehicle(random);
    const auto outlines = outlines_of(world);
    const auto cost = ClearanceCost::of(vehicle, outlines, std::nullopt, world.zones());
    const PathSegment segment = random_motion(random, side);
    const test::SampledCost expected = test::sampled_cost({segment}, world, vehicle, 0.02);
    const double found = cost->of(segment);
    ASSERT_NEAR(found, expected.cost, expected.doubt) << "segment " << i;
    EXPECT_NEAR(cost->of(segment.reversed()), found, 1e-6);
    counted += found > 0.0 ? 1 : 0;
    double everywhere = 0.0;
    for (const ClearanceCost::Rule& rule : cost->rules()) everywhere += rule.cost * rule.close.on(segment);
    partly += found > 0.0 && found < 0.95 * everywhere ? 1 : 0;
  }
  EXPECT_GT(counted, 15);
  EXPECT_GT(partly, 10);
}

// Turns on circles, as searches ask for them, cost what their arcs do.
TEST(ClearanceCost, OfHeadingsOnACircleIsThatOfItsArcs) {
  test::RandomInputs random(5);
  int counted = 0;
  for (std::uint64_t i = 0; i < 80; ++i) {
    const World free = random_world({.obstacles = 6, .vertices = 6, .fill = 0.15, .seed = i});
    const double side = free.box().max.x();
    const World world = free.with_zones({random_zone(random, side), random_zone(random, side)});
    const auto cost = ClearanceCost::of(Vehicle(), outlines_of(world), std::nullopt, world.zones());
    const Vec2 center(random.uniform(0, side), random.uniform(0, side));
    const double radius = random.uniform(1.3, 6.0);
    for (const Side turn_side : {Side::kLeft, Side::kRight}) {
      const auto close = cost->close_headings(center, radius, turn_side);
      for (int k = 0; k < 10; ++k) {
        const double heading = random.uniform(-4.0, 4.0), turn = random.uniform(0.0, kTwoPi);
        const Vec2 start = center - sign_of(turn_side) * radius * perpendicular(direction_of(heading));
        double found = 0.0;
        for (const auto& of_rule : close)
          found += of_rule.cost * radius * angle_within(of_rule.headings, heading, turn_side, turn);
        const PathSegment arc{{start.x(), start.y(), heading}, turn * radius, sign_of(turn_side) / radius};
        EXPECT_NEAR(found, cost->of(arc), 1e-5) << "circle " << i;
        counted += found > 0.0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(counted, 60);
}

}  // namespace
}  // namespace arcway::internal::clearance_cost_test

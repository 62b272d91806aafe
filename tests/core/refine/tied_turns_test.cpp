#include "core/refine/tied_turns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "arcway/angle.h"
#include "arcway/query_set.h"
#include "arcway/validation.h"
#include "core/motion/dubins.h"
#include "core/motion/speed_profile.h"
#include "core/refine/refine_path.h"

namespace arcway::internal {
namespace {

CircleChain changed(const CircleChain& chain, const ChainChange& change) {
  CircleChain result = chain;
  auto& circles = result.circles;
  const auto at = [](auto place, std::size_t offset) { return place + static_cast<std::ptrdiff_t>(offset); };
  circles.erase(at(circles.begin(), change.first), at(circles.begin(), change.last));
  circles.insert(at(circles.begin(), change.first), change.circles.begin(), at(change.circles.begin(), change.count));
  result.lead_in = change.lead_in;
  result.lead_out = change.lead_out;
  return result;
}

void expect_touching(const TurnCircle& a, const TurnCircle& b) {
  EXPECT_NEAR((a.center - b.center).norm(), std::abs(a.radius - b.radius), 1e-12 * std::max(a.radius, b.radius));
}

// From the origin a turn to the left, and another one 40 m away.
CircleChain example() {
  CircleChain chain{{0, 0, 0}, {20, 40, 0}, 0.0, 0.0, {}};
  chain.circles = {turn_circle(chain.start, 2.0, Side::kLeft), turn_circle(chain.goal, 2.0, Side::kRight)};
  return chain;
}

TEST(TiedTurns, KeepTheirEndsAndTouch) {
  const CircleChain chain = example();
  const auto lines = lines_of(chain);
  ASSERT_TRUE(lines);
  for (const bool leaving : {true, false}) {
    const CircleChain wide = changed(chain, widened(chain, *lines, {leaving ? 0U : 1U, leaving, 0.5}, 3.0));
    ASSERT_EQ(wide.circles.size(), 3u);
    EXPECT_EQ(wide.circles[1].radius, 6.0);
    expect_touching(wide.circles[1], wide.circles[leaving ? 0 : 2]);
    const auto wide_lines = lines_of(wide);
    ASSERT_TRUE(wide_lines);
    EXPECT_TRUE(are_tied(wide, *wide_lines, leaving ? 0 : 1));
    EXPECT_FALSE(are_tied(wide, *wide_lines, leaving ? 1 : 0));
    EXPECT_TRUE(is_tied(wide, *wide_lines, 1));
    EXPECT_FALSE(is_tied(wide, *wide_lines, leaving ? 0 : 2));
    const Pose end = path_of(wide, *wide_lines).back().end();
    EXPECT_NEAR((end.position() - chain.goal.position()).norm(), 0.0, 1e-9);
  }
}

TEST(TiedTurns, GetWiderByMoreSteps) {
  for (const bool leaving : {true, false}) {
    CircleChain chain = example();
    chain = changed(chain, widened(chain, *lines_of(chain), {leaving ? 0U : 1U, leaving, 0.5}, 3.0));
    const auto lines = lines_of(chain);
    ASSERT_TRUE(lines);
    const std::size_t tight = leaving ? 0 : 2;
    const auto turn_on = [&](const CircleChain& c, std::size_t i) {
      const auto l = lines_of(c);
      return turn_between(l->at(i).start.heading, l->at(i + 1).start.heading, c.circles[i].side);
    };
    const CircleChain steps = changed(chain, stepped(chain, *lines, {tight, leaving, 0.75}, 3.5));
    ASSERT_EQ(steps.circles.size(), 4u);
    ASSERT_TRUE(lines_of(steps));
    const std::size_t still = leaving ? 0 : 3, middle = leaving ? 1 : 2, wide = leaving ? 2 : 1;
    EXPECT_EQ(steps.circles[still].center, chain.circles[tight].center);
    EXPECT_EQ(steps.circles[middle].radius, 3.5);
    EXPECT_EQ(steps.circles[wide].radius, 6.0);
    expect_touching(steps.circles[still], steps.circles[middle]);
    expect_touching(steps.circles[middle], steps.circles[wide]);
    const double before = turn_on(chain, tight);
    EXPECT_NEAR(turn_on(steps, still), 0.75 * before, 1e-5);  // where circles touch is known to the root of rounding
    EXPECT_NEAR(turn_on(steps, middle), 0.25 * before + std::min(0.25 * before, 0.5 * turn_on(chain, 1)), 1e-5);
    const Pose end = path_of(steps, *lines_of(steps)).back().end();
    EXPECT_NEAR((end.position() - chain.goal.position()).norm(), 0.0, 1e-6);
  }
}

TEST(TiedTurns, FollowATighterOneThatMoves) {
  CircleChain chain = example();
  auto lines = lines_of(chain);
  chain = changed(chain, widened(chain, *lines, {0, true, 0.4}, 2.0));
  lines = lines_of(chain);
  chain = changed(chain, widened(chain, *lines, {1, true, 0.4}, 2.0));
  lines = lines_of(chain);
  ASSERT_TRUE(lines);
  ASSERT_EQ(chain.circles.size(), 4u);
  const CircleChain moved = changed(chain, shifted(chain, *lines, 0, chain.first_circle(0.0, 3.0, Side::kLeft)));
  ASSERT_EQ(moved.circles.size(), 4u);
  expect_touching(moved.circles[0], moved.circles[1]);
  expect_touching(moved.circles[1], moved.circles[2]);
  EXPECT_EQ(moved.circles[2].radius, chain.circles[2].radius);
  const CircleChain turned = changed(chain, retied(chain, *lines, 1, 0.1, 5.0));
  EXPECT_EQ(turned.circles[1].radius, 5.0);
  expect_touching(turned.circles[0], turned.circles[1]);
  expect_touching(turned.circles[1], turned.circles[2]);
}

TEST(TiedTurns, PinchedEndsAreTight) {
  CircleChain chain = example();
  for (const std::size_t i : {0u, 1u}) {
    const CircleChain tight = changed(chain, pinched(chain, i, 0.5, 0.3, 4.0));
    ASSERT_EQ(tight.circles.size(), 3u);
    EXPECT_EQ(tight.circles[i == 0 ? 0 : 2].radius, 0.5);
    expect_touching(tight.circles[i == 0 ? 0 : 1], tight.circles[i == 0 ? 1 : 2]);
    const auto lines = lines_of(tight);
    ASSERT_TRUE(lines);
    EXPECT_NEAR(turn_between(lines->at(i == 0 ? 0 : 2).start.heading, lines->at(i == 0 ? 1 : 3).start.heading,
                             tight.circles[i == 0 ? 0 : 2].side),
                0.3, 1e-6);  // circles that touch tell where up to the root of rounding
  }
}

// A vehicle that starts at rest turns tightly first and ever wider as it gets faster: no word of one radius is as fast.
TEST(TiedTurns, AreFasterThanAnyWordOfOneRadius) {
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0});
  const Pose start{0, 0, 0}, goal{-10, 60, 2.0};
  double fastest = std::numeric_limits<double>::infinity();
  Path word_path;
  for (double radius = vehicle.min_turning_radius(); radius < 40.0; radius *= 1.05)
    for (const DubinsWord word : kDubinsWords)
      if (const auto path = dubins_path(word, start, goal, radius)) {
        const double time = speed_profile(*path, vehicle).total_time;
        if (time >= fastest) continue;
        fastest = time;
        word_path = *path;
      }
  const World world({});
  const RefinedPath refined = refine_path({word_path, start, goal, vehicle, *make_reference_queries(world).sweep});
  EXPECT_LT(refined.travel_time, 0.98 * fastest);
  const SpeedProfile profile = speed_profile(refined.path, vehicle);
  EXPECT_TRUE(validate(world, vehicle, start, goal,
                       {.segments = refined.path,
                        .speed_in = {profile.speeds.begin(), profile.speeds.end() - 1},
                        .speed_out = {profile.speeds.begin() + 1, profile.speeds.end()},
                        .durations = profile.durations})
                  .valid());
}

}  // namespace
}  // namespace arcway::internal

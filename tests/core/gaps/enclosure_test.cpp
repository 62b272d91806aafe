#include "core/gaps/enclosure.h"

#include <gtest/gtest.h>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/planner.h"
#include "tests/support/boxes.h"
#include "tests/support/counting_sweep.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

using test::box;

constexpr std::size_t kBoxes = 400000;

std::optional<Enclosure> enclosure(const World& world, const Vehicle& vehicle, const Pose& start, const Pose& goal) {
  return find_enclosure(start, goal, {vehicle.footprint(), *make_reference_queries(world).sweep}, kBoxes);
}

// A lane that ends at a wall, and a lane to the left from its end.
World bend(double lane) {
  return World({box(0, lane, 9, 10), box(9 + lane, -1, 10 + lane, 10), box(-1, -1, 9 + lane, 0), box(-2, -1, -1, 10)});
}

// Round a right angle between lanes of width w gets what is half as long and as wide as sqrt(2) w at most, however it
// is moved.
TEST(Enclosure, ABendThatTheBodyDoesNotGetRound) {
  const Vehicle vehicle;  // 1.5 x 0.8 m: 1.0960 m
  const Pose inside{2, 0.5, 0}, outside{9.5, 15, kPi / 2.0};
  for (const double lane : {0.9, 0.95, 1.0}) {
    SCOPED_TRACE(lane);
    const auto from = enclosure(bend(lane), vehicle, inside, outside);
    ASSERT_TRUE(from);
    EXPECT_TRUE(from->at_start);
    EXPECT_GT(from->reach, 4.0);
    EXPECT_LT(from->reach, 9.0);
    const auto to = enclosure(bend(lane), vehicle, outside, inside);
    ASSERT_TRUE(to);
    EXPECT_FALSE(to->at_start);
  }
  for (const double lane : {1.0961, 1.1, 1.2}) EXPECT_FALSE(enclosure(bend(lane), vehicle, inside, outside)) << lane;
}

// This one takes more boxes than are tried before trees in both gears and those of slim bodies grow, of 2,000 and 4,000
// poses.
TEST(Enclosure, IsKnownBeforeAWayOutOfNarrowPlacesIsLookedFor) {
  const Planner planner(bend(1.0), Vehicle{});
  const PlanResult plan = planner.plan({.start = {2, 0.5, 0}, .goal = {9.5, 15, kPi / 2.0}, .reverse = true});
  EXPECT_EQ(plan.status, PlanStatus::kNoPassage);
  EXPECT_NE(plan.reason.find("however the body is moved"), std::string::npos) << plan.reason;
  EXPECT_LT(plan.statistics.maneuver_poses, 6200u);
}

// No part of a body that is far shorter than wide stays covered while it moves and turns in a large box.
TEST(Enclosure, IsNotProvedOfAShortBodyThatTurnsInItsPlace) {
  const World world({}, box(-0.3, -1.3, 0.3, 1.3).outer);
  const Vehicle vehicle(
      {.length = 0.1, .width = 2.0, .wheelbase = 0.3, .steering = Steering::kSymmetric, .max_steering_angle = 1.3});
  const Pose start{0, 0, 0}, goal{0, 0.1, 0.1};
  EXPECT_FALSE(enclosure(world, vehicle, start, goal));
  const Planner planner(world, vehicle);
  const PlanResult plan = planner.plan({.start = start, .goal = goal, .reverse = true});
  ASSERT_TRUE(plan.solved()) << plan.reason;
  test::expect_valid(planner, plan, true);
}

// In the open, the way to the other end is a row of boxes: their neighbors are not tested.
TEST(Enclosure, TestsOnlyBoxesOnTheWay) {
  const World world({box(-30, -30, -29, 30)});
  const Vehicle vehicle;
  const test::CountingSweep sweep(world);
  EXPECT_FALSE(find_enclosure({0, 0, 0}, {10, 0, 0}, {vehicle.footprint(), sweep}, kBoxes));
  // Boxes are a quarter of the body's width long, and both ends are looked from with boxes of four sizes.
  const double smallest = vehicle.footprint().width() / 4.0 / 8.0;
  EXPECT_LT(static_cast<double>(sweep.asked()), 2.0 * 4.0 * 1.2 * 10.0 / smallest);
}

TEST(Enclosure, IsNotProvedWhereThereIsAPath) {
  int solved = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const World world = random_world({.obstacles = 30, .vertices = 6, .fill = 0.5, .seed = seed});
    const Vehicle vehicle({.length = 3.0, .width = 1.2, .wheelbase = 2.0});
    const QuerySet queries = make_reference_queries(world);
    const Planner planner(world, vehicle);
    for (const PlanRequest& request : random_queries(world, queries, vehicle, {.count = 4, .min_distance = 0.2})) {
      if (!planner.plan(request, {.tree_poses = 300}).solved()) continue;
      ++solved;
      EXPECT_FALSE(find_enclosure(request.start, request.goal, {vehicle.footprint(), *queries.sweep}, 10000)) << seed;
    }
  }
  EXPECT_GT(solved, 5);
}

}  // namespace
}  // namespace arcway::internal

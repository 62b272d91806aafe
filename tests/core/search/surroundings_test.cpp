#include "core/search/surroundings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "arcway/angle.h"
#include "arcway/planner.h"
#include "arcway/query_set.h"
#include "core/planner/strategy.h"
#include "tests/support/boxes.h"
#include "tests/support/lazy_maps.h"

namespace arcway::internal {
namespace {

using test::box;

ExploredSurroundings explored(const World& world, const Pose& root, Direction direction) {
  const Vehicle vehicle;
  const Roadmap map = test::lazy_map(world, vehicle);
  return explore_surroundings(map, root, direction, kSurroundingsEffort, {});
}

// What the tightest turn takes ahead of the reference point, with the safety margin.
double needed() {
  const Vehicle vehicle;
  return swept_annulus(vehicle.footprint(vehicle.safety_margin()), Side::kLeft, vehicle.min_turning_radius()).outer;
}

World wall_ahead(double ahead) { return World({box(ahead, -40, ahead + 1, 40)}); }

TEST(Surroundings, IsClosedBeforeAWallTooNearToTurn) {
  for (const double share : {0.8, 0.97, 0.999}) {
    const ExploredSurroundings found = explored(wall_ahead(share * needed()), {0, 0, 0}, Direction::kFromStart);
    EXPECT_EQ(found.surroundings, Surroundings::kClosed) << share;
    EXPECT_LT(found.poses, 600u) << share;
  }
}

TEST(Surroundings, IsOpenBeforeAWallThatTheTightestTurnClears) {
  for (const double share : {1.001, 1.02, 1.5}) {
    const ExploredSurroundings found = explored(wall_ahead(share * needed()), {0, 0, 0}, Direction::kFromStart);
    EXPECT_EQ(found.surroundings, Surroundings::kOpen) << share;
    EXPECT_LT(found.poses, 200u) << share;
  }
}

// Motions to a goal come from behind: a wall ahead of it does not matter.
TEST(Surroundings, LooksBehindAGoal) {
  const World world = wall_ahead(0.97 * needed());
  EXPECT_EQ(explored(world, {0, 0, 0}, Direction::kToGoal).surroundings, Surroundings::kOpen);
  EXPECT_EQ(explored(World({box(-1.9, -40, -0.9, 40)}), {0, 0, 0}, Direction::kToGoal).surroundings,
            Surroundings::kClosed);
}

TEST(Surroundings, IsTheSameWhereverItLies) {
  const ExploredSurroundings here = explored(wall_ahead(0.97 * needed()), {0, 0, 0}, Direction::kFromStart);
  for (const double turn : {0.3, 1.9}) {
    Ring wall = box(0.97 * needed(), -40, 0.97 * needed() + 1, 40).outer;
    const Vec2 shift(1e3, -2e3), ahead = direction_of(turn);
    for (Vec2& p : wall) p = p.x() * ahead + p.y() * perpendicular(ahead) + shift;
    const ExploredSurroundings there =
        explored(World({{wall, {}}}), {shift.x(), shift.y(), turn}, Direction::kFromStart);
    EXPECT_EQ(there.surroundings, here.surroundings);
    EXPECT_NEAR(static_cast<double>(there.poses), static_cast<double>(here.poses),
                0.1 * static_cast<double>(here.poses));
  }
}

// Neither estimates of routes nor trees of the other end are needed to say so.
TEST(Surroundings, SavesTreesOfBothEnds) {
  const Planner planner(wall_ahead(0.99 * needed()), Vehicle{});
  const PlanResult plan = planner.plan({.start = {0, 0, 0}, .goal = {-30, 5, 0}});
  EXPECT_EQ(plan.status, PlanStatus::kStartBlocked) << plan.reason;
  EXPECT_EQ(plan.certainty, Certainty::kGaveUp);
  EXPECT_GT(plan.statistics.tree_poses, 0u);
  EXPECT_LT(plan.statistics.tree_poses, 600u);
  EXPECT_NE(plan.reason.find("found no more from one end"), std::string::npos) << plan.reason;
}

}  // namespace
}  // namespace arcway::internal

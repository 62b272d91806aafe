// What a plan says when there is none.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/planner.h"
#include "core/gaps/bottleneck_finder.h"
#include "tests/support/boxes.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

using test::box;

// Two rooms and a door.
World rooms(double door) { return World({box(14, 0, 15, 10), box(14, 10 + door, 15, 30)}, box(0, 0, 30, 30).outer); }

TEST(PlannerNoPath, ADoorTooNarrowIsNamed) {
  const Vehicle vehicle;  // 0.8 m wide
  const PlanRequest request{.start = {5, 10, 0}, .goal = {25, 10, 0}};
  for (const bool reverse : {false, true}) {
    PlanRequest asked = request;
    asked.reverse = reverse;
    const PlanResult plan = Planner(rooms(0.75), vehicle).plan(asked);
    EXPECT_EQ(plan.status, PlanStatus::kNoPassage);
    ASSERT_TRUE(plan.bottleneck);
    EXPECT_EQ(plan.bottleneck->width, 0.75);
    EXPECT_EQ(plan.bottleneck->obstacle_a, 0u);
    EXPECT_EQ(plan.bottleneck->obstacle_b, 1u);
    EXPECT_EQ(plan.bottleneck->on_a.y(), 10.0);
    EXPECT_EQ(plan.bottleneck->on_b.y(), 10.75);
    EXPECT_NEAR(plan.bottleneck->needed, 0.8 + vehicle.safety_margin(), 1e-5);
    EXPECT_NE(plan.reason.find("narrows to 0.75 m between obstacle 0 at (1"), std::string::npos) << plan.reason;
    EXPECT_NE(plan.reason.find("takes more than 0.801 m"), std::string::npos) << plan.reason;
    EXPECT_EQ(plan.statistics.maneuver_poses, 0u);  // it did not take any to know
    EXPECT_STREQ(name_of(plan.status), "no passage");
  }
  const Planner wide(rooms(1.5), vehicle);
  const PlanResult plan = wide.plan(request);
  ASSERT_TRUE(plan.solved()) << plan.reason;
  test::expect_valid(wide, plan);
  EXPECT_FALSE(plan.bottleneck);
}

TEST(PlannerNoPath, AllRoundTheStart) {
  // Pillars less than a body's width apart.
  std::vector<Polygon> pillars;
  for (int i = 0; i < 16; ++i) {
    const Vec2 p = 4.0 * direction_of(kTwoPi * i / 16.0);
    pillars.push_back(box(p.x() - 0.5, p.y() - 0.5, p.x() + 0.5, p.y() + 0.5));
  }
  const Planner planner(World(pillars), Vehicle{});
  const Pose inside{-0.4, 0, 0}, outside{20, 0, 0};
  for (const auto& [start, goal] : {std::pair{inside, outside}, std::pair{outside, inside}}) {
    const PlanResult plan = planner.plan({.start = start, .goal = goal, .reverse = true});
    EXPECT_EQ(plan.status, PlanStatus::kNoPassage);
    ASSERT_TRUE(plan.bottleneck);
    EXPECT_LT(plan.bottleneck->width, 0.8);
    EXPECT_NE(plan.bottleneck->obstacle_a, plan.bottleneck->obstacle_b);
  }
  EXPECT_TRUE(planner.plan({.start = {-20, 10, 0}, .goal = outside}).solved());
}

TEST(PlannerNoPath, ObstaclesThatMeetLeaveNoWay) {
  const PlanResult wall = Planner(World({box(14, -1, 15, 16), box(14, 15, 15, 31)}, box(0, 0, 30, 30).outer), Vehicle{})
                              .plan({.start = {5, 10, 0}, .goal = {25, 10, 0}});
  EXPECT_EQ(wall.status, PlanStatus::kNoPassage);
  EXPECT_NE(wall.reason.find("leave no way"), std::string::npos) << wall.reason;
  const Polygon frame{box(0, 0, 20, 20).outer, {{{2, 2}, {2, 18}, {18, 18}, {18, 2}}}};
  const PlanResult hole = Planner(World({frame}), Vehicle{}).plan({.start = {10, 10, 0}, .goal = {40, 10, 0}});
  EXPECT_EQ(hole.status, PlanStatus::kNoPassage);
  EXPECT_NE(hole.reason.find("obstacle 0 lies all around"), std::string::npos) << hole.reason;
}

TEST(PlannerNoPath, APassageToDriveThroughButNotToTurnIn) {
  // A hairpin of a lane: wide enough to go straight, too narrow for any turn.
  const double lane = 1.0;
  const World world({box(0, lane, 9, 10), box(9 + lane, -lane, 10 + lane, 10), box(-1, -lane, 9 + lane, 0)});
  const PlanResult plan = Planner(world, Vehicle{}).plan({.start = {2, 0.5, 0}, .goal = {9.5, 15, kPi / 2.0}});
  if (!plan.solved()) {
    EXPECT_NE(plan.status, PlanStatus::kNoPassage);
    if (plan.bottleneck) {
      EXPECT_GE(plan.bottleneck->width, plan.bottleneck->needed);
      EXPECT_LT(plan.bottleneck->width, plan.bottleneck->needed_to_turn);
      EXPECT_NE(plan.reason.find("in its tightest turn"), std::string::npos) << plan.reason;
    }
  }
}

TEST(PlannerNoPath, NoPathThatExistsIsDisproved) {
  int solved = 0, disproved = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const World world = random_world({.obstacles = 40, .vertices = 6, .fill = 0.5, .seed = seed});
    const Vehicle vehicle({.length = 3.0, .width = 1.8, .wheelbase = 2.0});
    const Planner planner(world, vehicle, {.maneuver_poses = 100});
    const BottleneckFinder bottleneck(world, vehicle);
    for (const PlanRequest& request :
         random_queries(world, make_reference_queries(world), vehicle, {.count = 8, .min_distance = 0.2})) {
      const PlanResult plan = planner.plan(request, {.tree_poses = 50});
      const auto narrowest = bottleneck(request.start, request.goal);
      if (plan.solved()) {
        ++solved;
        EXPECT_FALSE(narrowest && narrowest->too_narrow());
      } else {
        EXPECT_EQ(plan.status == PlanStatus::kNoPassage, narrowest && narrowest->too_narrow());
        disproved += plan.status == PlanStatus::kNoPassage ? 1 : 0;
      }
    }
  }
  EXPECT_GT(solved, 5);
  EXPECT_GT(disproved, 5);
}

TEST(PlannerNoPath, AProofIsToldFromALimit) {
  const auto certainty = [](const World& world, const Pose& start, const Pose& goal) {
    const PlanResult plan =
        Planner(world, Vehicle{}, {.maneuver_poses = 20}).plan({.start = start, .goal = goal}, {.tree_poses = 300});
    EXPECT_FALSE(plan.solved());
    return plan.certainty;
  };
  EXPECT_EQ(certainty(rooms(0.75), {5, 10, 0}, {25, 10, 0}), Certainty::kProved);
  EXPECT_EQ(certainty(rooms(0.75), {14.5, 5, 0}, {25, 10, 0}), Certainty::kProved);  // in a wall
  // A hall too narrow to turn round in, and so long that this is not proved.
  const World hall({}, box(-60, -1, 60, 1).outer);
  EXPECT_EQ(certainty(hall, {0, 0, 0}, {5, 0, kPi}), Certainty::kGaveUp);
  const PlanResult late = Planner(hall, Vehicle{}).plan({.start = {0, 0, 0}, .goal = {5, 0, kPi}}, {.time = 0.0});
  EXPECT_EQ(late.certainty, Certainty::kGaveUp);
}

TEST(PlannerNoPath, ReasonsAreTheSameForLazyAndEagerGraphs) {
  const World hall({box(20, -0.3, 21, 0.3)}, box(-60, -1, 60, 1).outer);
  const auto reason = [&](GraphMode mode) {
    const Planner planner(hall, Vehicle{}, {.graph_mode = mode, .maneuver_poses = 20});
    return planner.plan({.start = {-10, 0, 0}, .goal = {-15, 0, 0}}, {.tree_poses = 300}).reason;
  };
  EXPECT_FALSE(reason(GraphMode::kEager).empty());
  EXPECT_EQ(reason(GraphMode::kEager), reason(GraphMode::kLazy));
}

TEST(PlannerNoPath, WhatWasInterruptedIsNotExplained) {
  const PlanResult plan =
      Planner(rooms(0.75), Vehicle{}).plan({.start = {5, 10, 0}, .goal = {25, 10, 0}}, {.time = 0.0});
  EXPECT_EQ(plan.status, PlanStatus::kTimeLimit);
  EXPECT_FALSE(plan.bottleneck);
}

}  // namespace
}  // namespace arcway::internal

#include "core/tasks/path_repair.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/replan.h"
#include "arcway/validation.h"
#include "tests/support/boxes.h"
#include "tests/support/free_plans.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal::path_repair_test {
namespace {

constexpr double kAmpleTime = 1e6;  // [s]; with a limit, as only then motions are repaired

Vehicle robot() {
  return Vehicle({.max_speed = 3.0, .turn_speed = LateralAccelerationLimit{1.5}, .max_acceleration = 1.0});
}

// A planner that is too slow for queries further than some distance.
ReplanQueries short_sighted(const Planner& planner, double farthest) {
  return {planner.vehicle(), [&planner](std::span<const PathSegment> path) { return planner.is_free(path); },
          [&planner, farthest](const PlanRequest& request, const PlanLimits& limits) {
            PlanResult result;
            const double distance = (request.goal.position() - request.start.position()).norm();
            if (distance <= farthest) planner.plan(request, limits, result);
            return result;
          }};
}

void expect_valid(const Planner& planner, const Replan& next, const TrajectoryState& now, const Pose& goal) {
  ASSERT_FALSE(next.segments.empty());
  const ValidationReport report = validate(planner.world(), planner.vehicle(), now.pose, goal,
                                           timed_path_of(next.segments), {.start_speed = now.signed_speed()});
  EXPECT_TRUE(report.valid()) << to_string(report);
  EXPECT_NEAR(report.travel_time, next.travel_time, 1e-9 * (1.0 + next.travel_time));
  EXPECT_NO_THROW(Trajectory(next.segments, planner.vehicle()));
}

// A small obstacle where a motion is at a moment.
Polygon obstacle_on(const Trajectory& motion, double time) {
  const Pose pose = motion.at(time).pose;
  return Polygon::rectangle({pose.x - 0.4, pose.y - 0.3}, {pose.x + 0.4, pose.y + 0.3});
}

World far_box() { return World(std::vector<Polygon>{test::box(60, 60, 61, 61)}); }
const Pose kStart{0.0, 0.0, 0.0}, kGoal{60.0, 0.0, 0.0};

TEST(PathRepair, GoesAroundCutsWhereAWholePlanIsNotFound) {
  int cut = 0, repaired = 0;
  for (const std::uint64_t seed : {3U, 4U, 5U}) {
    const World clutter(generate_clutter({.obstacles = 40, .vertices = 6, .fill = 0.1, .seed = seed}).obstacles);
    const Box box = clutter.box();
    const Polygon half = Polygon::rectangle(box.min, {0.5 * (box.min.x() + box.max.x()), box.max.y()});
    for (const World& world : {clutter, clutter.with_zones({{half, SpeedLimit{1.2}}})}) {
      const Planner before(world, robot(), {.refinement = {.max_trials = 50}});
      test::RandomInputs random(seed);
      for (int i = 0; i < 5; ++i) {
        const auto [request, path] = test::next_free_plan(before, random);
        const Trajectory driven = before.plan(request).trajectory();
        const TrajectoryState now = driven.at(0.2 * driven.duration());
        const Planner after = before.with_obstacles({}, {obstacle_on(driven, 0.7 * driven.duration())});
        const double distance = (request.goal.position() - now.pose.position()).norm();
        if (!after.is_free(request.goal) || distance < 20.0) continue;
        ++cut;
        const Replan next =
            replan_by(short_sighted(after, 0.9 * distance), driven, now.time, {.limits = {.time = kAmpleTime}});
        EXPECT_NE(next.motion, NextMotion::kPlanned);
        if (next.motion != NextMotion::kRepaired) continue;
        ++repaired;
        EXPECT_TRUE(next.given_up.empty());
        expect_valid(after, next, now, request.goal);
      }
    }
  }
  EXPECT_GE(cut, 15);
  EXPECT_GE(repaired, cut * 9 / 10);
}

TEST(PathRepair, IsNoSlowerThanAPlanWhereThereIsTime) {
  const Planner before(far_box(), robot());
  const Trajectory driven = before.plan(kStart, kGoal).trajectory();
  const Planner after = before.with_obstacles({}, {obstacle_on(driven, 10.0)});
  const Replan next = replan(after, driven, 2.0, {.limits = {.time = kAmpleTime}});
  const Replan without_limit = replan(after, driven, 2.0);
  ASSERT_EQ(without_limit.motion, NextMotion::kPlanned);
  EXPECT_LE(next.travel_time, without_limit.travel_time);
}

TEST(PathRepair, TakesNoTimeThatIsUnlimited) {
  const Planner before(far_box(), robot());
  const Trajectory driven = before.plan(kStart, kGoal).trajectory();
  const Planner after = before.with_obstacles({}, {obstacle_on(driven, 10.0)});
  ReplanQueries queries = short_sighted(after, 1e9);
  int plans = 0;
  const auto plan = std::move(queries.plan);
  queries.plan = [&](const PlanRequest& request, const PlanLimits& limits) {
    ++plans;
    return plan(request, limits);
  };
  (void)replan_by(queries, driven, 2.0, {});
  EXPECT_EQ(plans, 1);
  (void)replan_by(queries, driven, 2.0, {.limits = {.time = kAmpleTime}});
  EXPECT_EQ(plans, 3);
}

TEST(PathRepair, GoesOnAlongWhatWasGivenUp) {
  const Planner free(far_box(), robot());
  const Trajectory driven = free.plan(kStart, kGoal).trajectory();
  const Planner blocked = free.with_obstacles({}, {Polygon::rectangle({30.0, -30.0}, {31.0, 30.0})});
  const TrajectoryState begin = driven.at(4.0);
  const Replan braking =
      replan_by(short_sighted(blocked, 0.0), driven, 4.0, {.goal = kGoal, .limits = {.time = kAmpleTime}});
  ASSERT_EQ(braking.motion, NextMotion::kBraking);
  EXPECT_EQ(braking.given_up.front().segment.start, begin.pose);
  // It brakes for a while, and goes on braking while the way is blocked.
  const Trajectory first(braking.segments, robot());
  const Replan still = replan_by(short_sighted(blocked, 0.0), first, 1.0,
                                 {.goal = kGoal, .limits = {.time = kAmpleTime}, .given_up = braking.given_up});
  ASSERT_EQ(still.motion, NextMotion::kBraking);
  const Trajectory second(still.segments, robot());
  for (const double time : {0.0, 0.7, second.duration()}) {
    const TrajectoryState now = second.at(time);
    const Replan next = replan_by(short_sighted(free, 0.0), second, time,
                                  {.goal = kGoal, .limits = {.time = kAmpleTime}, .given_up = still.given_up});
    ASSERT_EQ(next.motion, NextMotion::kRepaired) << time;
    EXPECT_EQ(next.segments.front().speed_in, now.speed);
    expect_valid(free, next, now, kGoal);
    // Another goal is none of its.
    const Replan other =
        replan_by(short_sighted(free, 0.0), second, time, {.goal = Pose{5.0, 5.0, 0.0}, .given_up = still.given_up});
    EXPECT_EQ(other.motion, NextMotion::kBraking);
    EXPECT_TRUE(other.given_up.empty());
  }
}

TEST(PathRepair, ComesBackToAMotionFromAside) {
  const Planner planner(far_box(), robot());
  const PlanResult towards = planner.plan(kStart, kGoal);
  const Trajectory aside = planner.plan(Pose{5.0, 3.0, 0.2}, Pose{12.0, 4.0, 0.0}).trajectory();
  for (const double time : {0.0, 1.5}) {
    const TrajectoryState now = aside.at(time);
    const Replan next = replan_by(short_sighted(planner, 40.0), aside, time,
                                  {.goal = kGoal, .limits = {.time = kAmpleTime}, .given_up = towards.segments});
    ASSERT_EQ(next.motion, NextMotion::kRepaired) << next.reason;
    expect_valid(planner, next, now, kGoal);
    EXPECT_LT(next.travel_time, 60.0 / 3.0 + 5.0);
  }
}

// At its first place, but faster than it begins.
TEST(PathRepair, ComesBackToAFreeMotionThatBeginsSlower) {
  const Planner planner(far_box(), robot());
  const PlanResult towards = planner.plan(kStart, kGoal);
  const Trajectory aside =
      planner.plan(PlanRequest{.start = kStart, .goal = {20.0, 6.0, 0.5}, .start_speed = 1.5}).trajectory();
  const TrajectoryState now = aside.at(0.0);
  ASSERT_EQ(now.speed, 1.5);
  const Replan next = replan_by(short_sighted(planner, 40.0), aside, 0.0,
                                {.goal = kGoal, .limits = {.time = kAmpleTime}, .given_up = towards.segments});
  ASSERT_EQ(next.motion, NextMotion::kRepaired) << next.reason;
  EXPECT_EQ(next.segments.front().speed_in, now.speed);
  expect_valid(planner, next, now, kGoal);
}

TEST(PathRepair, DrivesBackwardsOnlyIfAsked) {
  const Planner before(far_box(), robot());
  const PlanRequest back{.start = kStart, .goal = {-60.0, 0.0, 0.0}, .reverse = true};
  const Trajectory driven = before.plan(back).trajectory();
  const Planner after = before.with_obstacles({}, {obstacle_on(driven, 0.6 * driven.duration())});
  const TrajectoryState now = driven.at(0.2 * driven.duration());
  for (const bool reverse : {false, true}) {
    const Replan next =
        replan_by(short_sighted(after, 40.0), driven, now.time, {.reverse = reverse, .limits = {.time = kAmpleTime}});
    if (!reverse && now.signed_speed() < 0.0) {
      EXPECT_NE(next.motion, NextMotion::kRepaired);
    } else {
      ASSERT_EQ(next.motion, NextMotion::kRepaired) << next.reason;
      expect_valid(after, next, now, back.goal);
    }
  }
}

}  // namespace
}  // namespace arcway::internal::path_repair_test

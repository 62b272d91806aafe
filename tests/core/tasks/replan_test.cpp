#include "arcway/replan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/validation.h"
#include "tests/support/boxes.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

Vehicle robot() {
  return Vehicle({.max_speed = 3.0, .turn_speed = LateralAccelerationLimit{1.5}, .max_acceleration = 1.0});
}

// A motion given is one of the vehicle on the planner's map, from the moment on.
void expect_valid(const Planner& planner, const Replan& next, const TrajectoryState& now) {
  const TimedPath path = timed_path_of(next.segments);
  const Pose end = next.segments.empty() ? now.pose : path.segments.back().end();
  const ValidationReport report =
      validate(planner.world(), planner.vehicle(), now.pose, end, path, {.start_speed = now.signed_speed()});
  EXPECT_TRUE(report.valid()) << to_string(report);
  EXPECT_NEAR(report.travel_time, next.travel_time, 1e-9 * (1.0 + next.travel_time));
}

TEST(Replan, IsNeverSlowerThanTheRestWhereThatIsFree) {
  const World world(generate_clutter({.obstacles = 30, .vertices = 6, .fill = 0.2, .seed = 3}).obstacles);
  const Planner planner(world, robot(), {.refinement = {.max_trials = 200}});
  test::RandomInputs random(1);
  const Box box = world.box();
  int moved = 0;
  for (int i = 0; i < 12; ++i) {
    const auto pose = [&] {
      return Pose{random.uniform(box.min.x(), box.max.x()), random.uniform(box.min.y(), box.max.y()),
                  random.uniform(-kPi, kPi)};
    };
    const PlanResult plan = planner.plan(pose(), pose());
    if (!plan.solved()) continue;
    const Trajectory driven = plan.trajectory();
    for (const double share : {0.0, 0.13, 0.4, 0.77, 0.95}) {
      const TrajectoryState now = driven.at(share * driven.duration());
      const Replan next = replan(planner, driven, now.time);
      ASSERT_TRUE(next.motion == NextMotion::kKept || next.motion == NextMotion::kPlanned) << next.reason;
      EXPECT_LE(next.travel_time, (driven.duration() - now.time) * (1.0 + 1e-9));
      expect_valid(planner, next, now);
      // Without time the rest is kept.
      const Replan kept = replan(planner, driven, now.time, {.limits = {.time = 0.0}});
      EXPECT_EQ(kept.motion, NextMotion::kKept);
      EXPECT_NEAR(kept.travel_time, driven.duration() - now.time, 1e-9);
      expect_valid(planner, kept, now);
      ++moved;
    }
  }
  EXPECT_GT(moved, 15);
}

TEST(Replan, GivesMotionsToDriveUpToTheLastMoment) {
  const World world(std::vector<Polygon>{Polygon::rectangle({60.0, 60.0}, {61.0, 61.0})});
  const Planner planner(world, robot(), {.refinement = {.max_trials = 200}});
  const Trajectory driven = planner.plan(Pose{0.0, 0.0, 0.0}, Pose{14.3, 5.7, 2.0}).trajectory();
  ASSERT_GT(driven.segments().size(), 2U);
  double ended = 0.0;
  for (const TimedSegment& timed : driven.segments()) {
    ended += timed.duration;
    for (const double before : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-12, 1e-15}) {
      const TrajectoryState now = driven.at(std::min(ended, driven.duration()) - before);
      const Replan next = replan(planner, driven, now.time, {.limits = {.time = 0.0}});
      ASSERT_EQ(next.motion, NextMotion::kKept);
      if (next.segments.empty()) continue;
      EXPECT_NO_THROW(Trajectory(next.segments, planner.vehicle())) << before << " s before " << ended << " s";
      expect_valid(planner, next, now);
    }
  }
}

TEST(Replan, GoesAroundWhatBlocksTheRest) {
  const World world(std::vector<Polygon>{Polygon::rectangle({60.0, 60.0}, {61.0, 61.0})});
  const Planner before(world, robot());
  const Trajectory driven = before.plan(Pose{0.0, 0.0, 0.0}, Pose{40.0, 0.0, 0.0}).trajectory();
  const Planner after = before.with_obstacles({}, {Polygon::rectangle({20.0, -2.0}, {22.0, 1.0})});
  const TrajectoryState now = driven.at(4.0);
  ASSERT_EQ(now.speed, 3.0);
  const Replan next = replan(after, driven, now.time);
  ASSERT_EQ(next.motion, NextMotion::kPlanned) << next.reason;
  EXPECT_EQ(next.segments.front().speed_in, 3.0);
  expect_valid(after, next, now);
}

TEST(Replan, BrakesWithoutTime) {
  const World world(std::vector<Polygon>{Polygon::rectangle({60.0, 60.0}, {61.0, 61.0})});
  const Planner before(world, robot());
  const Trajectory driven = before.plan(Pose{0.0, 0.0, 0.0}, Pose{40.0, 0.0, 0.0}).trajectory();
  const TrajectoryState now = driven.at(4.0);
  // Its front is at F + 1.4 m; it stops after 4.5 m.
  const double front = now.pose.x + 1.4 + 4.5;
  const auto with_wall = [&](double x) {
    return before.with_obstacles({}, {Polygon::rectangle({x, -20.0}, {x + 1.0, 20.0})});
  };
  const Planner room = with_wall(front + 0.01), none = with_wall(front - 0.01);
  const Replan braking = replan(room, driven, now.time, {.limits = {.time = 0.0}});
  EXPECT_EQ(braking.motion, NextMotion::kBraking);
  EXPECT_EQ(braking.reason, "the rest of the motion is blocked, and there was no time for a plan");
  expect_valid(room, braking, now);
  EXPECT_NEAR(braking.travel_time, 3.0, 1e-12);
  EXPECT_EQ(braking.segments.back().speed_out, 0.0);
  const Replan lost = replan(none, driven, now.time, {.limits = {.time = 0.0}});
  EXPECT_EQ(lost.motion, NextMotion::kNoMotion);
  EXPECT_TRUE(lost.segments.empty());
  EXPECT_NE(lost.reason.find("neither does any braking tried stay free"), std::string::npos);
}

// A wall has come up beside the vehicle, within half of its margin of 1 mm.
TEST(Replan, BrakesInsideTheMarginRatherThanNotAtAll) {
  const World world(std::vector<Polygon>{Polygon::rectangle({60.0, 60.0}, {61.0, 61.0})});
  const Planner before(world, robot());
  const Trajectory driven = before.plan(Pose{0.0, 0.0, 0.0}, Pose{40.0, 0.0, 0.0}).trajectory();
  const TrajectoryState now = driven.at(4.0);
  const double side = 0.5 * robot().footprint().width();
  const auto with_wall = [&](double beside) {
    return before.with_obstacles({}, {Polygon::rectangle({0.0, side + beside}, {30.0, side + beside + 1.0})});
  };
  for (const double beside : {1e-4, 1e-9}) {
    const Planner planner = with_wall(beside);
    const Replan next = replan(planner, driven, now.time);
    ASSERT_EQ(next.motion, NextMotion::kBraking) << next.reason;
    EXPECT_NE(next.reason.find("; braking comes into the safety margin"), std::string::npos);
    EXPECT_EQ(next.segments.back().speed_out, 0.0);
    expect_valid(planner, next, now);
  }
  const Replan touching = replan(with_wall(-1e-9), driven, now.time);
  EXPECT_EQ(touching.motion, NextMotion::kNoMotion);
  const Replan apart = replan(with_wall(0.6e-3), driven, now.time);
  EXPECT_TRUE(apart.motion == NextMotion::kKept || apart.motion == NextMotion::kPlanned) << apart.reason;
}

TEST(Replan, LeadsToAnotherGoalOrGoesOnBraking) {
  const World world(std::vector<Polygon>{Polygon::rectangle({60.0, 60.0}, {61.0, 61.0})});
  const Planner planner(world, robot());
  const Trajectory driven = planner.plan(Pose{0.0, 0.0, 0.0}, Pose{40.0, 0.0, 0.0}).trajectory();
  const TrajectoryState now = driven.at(4.0);
  const Pose goal{30.0, 10.0, 1.0};
  const Replan next = replan(planner, driven, now.time, {.goal = goal});
  ASSERT_EQ(next.motion, NextMotion::kPlanned) << next.reason;
  expect_valid(planner, next, now);
  EXPECT_NEAR((next.segments.back().segment.end().position() - goal.position()).norm(), 0.0, 1e-9);
  const Replan without_time = replan(planner, driven, now.time, {.goal = goal, .limits = {.time = 0.0}});
  EXPECT_EQ(without_time.motion, NextMotion::kBraking) << "it goes on to where it would stop";
  EXPECT_EQ(without_time.reason, "the motion before leads elsewhere, and there was no time for a plan");
  expect_valid(planner, without_time, now);
}

TEST(Replan, RefusesTheMotionOfAnotherVehicle) {
  const World world(std::vector<Polygon>{test::box(5, 5, 6, 6)});
  const Trajectory driven = Planner(world, robot()).plan(Pose{0, 0, 0}, Pose{4, 0, 0}).trajectory();
  EXPECT_THROW(replan(Planner(world, Vehicle()), driven, 0.0), std::invalid_argument);
  EXPECT_THROW(replan(Planner(world, robot()), driven, 1e3), std::out_of_range);
}

}  // namespace
}  // namespace arcway::internal

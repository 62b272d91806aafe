// Plans whose ends move.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/planner.h"
#include "core/motion/speed_profile.h"
#include "tests/support/boxes.h"
#include "tests/support/free_plans.h"
#include "tests/support/mirrored.h"
#include "tests/support/plans.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

using test::expect_valid;

// An automated mobile robot.
Vehicle robot() {
  return Vehicle({.max_speed = 2.0, .turn_speed = LateralAccelerationLimit{0.8}, .max_acceleration = 1.0});
}

TEST(PlannerMoving, ALineTakesTheTimeOfItsProfile) {
  const Vehicle vehicle = robot();
  const Planner planner(World({}), vehicle);
  for (const EndSpeeds& ends : {EndSpeeds{1.5, 0.0}, EndSpeeds{0.0, 2.0}, EndSpeeds{2.0, 1.0}, EndSpeeds{2.0, 2.0}}) {
    const PlanResult plan =
        planner.plan({.start = {0, 0, 0}, .goal = {9, 0, 0}, .start_speed = ends.start, .goal_speed = ends.goal});
    ASSERT_TRUE(plan.solved()) << plan.reason;
    EXPECT_NEAR(plan.travel_time, segment_time(9.0, ends.start, 2.0, ends.goal, 1.0), 1e-9);
    EXPECT_NEAR(plan.optimality_gap(), 0.0, 1e-6);
    expect_valid(planner, plan);
    EXPECT_EQ(plan.segments.front().speed_in, ends.start);
    EXPECT_EQ(plan.segments.back().speed_out, ends.goal);
  }
}

// Plans are cut at shares of their time, and planned on from there. Close to its goal a plan brakes as hard as it can
// on arcs that no attachment has: another one then takes a detour.
TEST(PlannerMoving, APlanGoesOnFromAnyPlaceOfAnotherOne) {
  for (const double lateral : {0.8, 1.5}) {
    const World world =
        random_world({.kind = ClutterKind::kStar, .obstacles = 40, .vertices = 8, .fill = 0.3, .seed = 3});
    const Planner planner(
        world, Vehicle({.max_speed = 2.0, .turn_speed = LateralAccelerationLimit{lateral}, .max_acceleration = 1.0}));
    test::RandomInputs random(4);
    std::vector<double> over;  // share of time that the new plan takes more than the rest of the old one
    for (int i = 0; i < 12; ++i) {
      const PlanRequest request = test::next_free_plan(planner, random).request;
      const PlanResult whole = planner.plan(request);
      const Trajectory trajectory = whole.trajectory();
      for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        const TrajectoryState at = trajectory.at(share * trajectory.duration());
        const PlanResult rest =
            planner.plan({.start = at.pose, .goal = request.goal, .start_speed = at.signed_speed()});
        ASSERT_TRUE(rest.solved()) << i << " at " << share << ": " << rest.reason;
        expect_valid(planner, rest);
        EXPECT_EQ(rest.segments.front().speed_in, at.speed);
        if (share < 0.6) over.push_back(rest.travel_time / (whole.travel_time - at.time) - 1.0);
      }
    }
    EXPECT_LT(std::ranges::count_if(over, [](double share) { return share > 0.1; }), 3);
    EXPECT_GT(std::ranges::count_if(over, [](double share) { return share < 0.01; }), 18);
  }
}

TEST(PlannerMoving, PlansBetweenMovingEndsAreValid) {
  const World world =
      random_world({.kind = ClutterKind::kStar, .obstacles = 40, .vertices = 8, .fill = 0.3, .seed = 5});
  test::RandomInputs random(9);
  for (const TurnSpeedLaw& law : {TurnSpeedLaw{LateralAccelerationLimit{0.8}}, TurnSpeedLaw{ConstantTurnSpeed{1.0}},
                                  TurnSpeedLaw{TurnSpeedTable{{{1.0, 0.8}, {4.0, 2.0}}}}}) {
    const Planner planner(world, Vehicle({.max_speed = 2.0, .turn_speed = law, .max_acceleration = 1.0}));
    int solved = 0;
    for (int i = 0; i < 30; ++i) {
      PlanRequest request = test::next_free_plan(planner, random).request;
      request.start_speed = i % 3 == 0 ? 0.0 : random.uniform(0.0, 2.0);
      request.goal_speed = i % 3 == 1 ? 0.0 : random.uniform(0.0, 2.0);
      const PlanResult plan = planner.plan(request);
      if (!plan.solved()) continue;
      ++solved;
      expect_valid(planner, plan);
      EXPECT_NEAR(plan.segments.front().speed_in, request.start_speed, 1e-6);
      EXPECT_NEAR(plan.segments.back().speed_out, request.goal_speed, 1e-6);
    }
    EXPECT_GT(solved, 15);
  }
}

TEST(PlannerMoving, AMirroredRequestHasThePlanInAMirror) {
  std::vector<Polygon> boxes{test::box(4, -1, 6, 3), test::box(9, -6, 11, 1)};
  // In how few arcs a path is driven depends on rounding, where a body touches a box: by 0.1 % of the time.
  const PlannerOptions options{.leave_out = {"refinement at length", "fewer arcs"}};
  const Planner planner(World(boxes), robot(), options), mirrored(World(test::mirrored(boxes)), robot(), options);
  const PlanRequest request{.start = {0, 0.3, 0.1}, .goal = {15, 1, -0.4}, .start_speed = 1.8, .goal_speed = 1.5};
  PlanRequest other = request;
  other.start = test::mirrored(request.start);
  other.goal = test::mirrored(request.goal);
  const PlanResult a = planner.plan(request), b = mirrored.plan(other);
  ASSERT_TRUE(a.solved());
  EXPECT_NEAR(a.travel_time, b.travel_time, 1e-4 * a.travel_time);
}

TEST(PlannerMoving, AStartThatCannotBrakeSaysWhatItTakes) {
  // From rest it could turn away from the wall.
  const World world({test::box(3.9, -20, 5, 20)});
  const Planner planner(world, robot());
  PlanRequest request{.start = {1, 0, 0}, .goal = {-8, 0, kPi}};
  EXPECT_TRUE(planner.plan(request).solved());
  request.start_speed = 2.0;
  const PlanResult plan = planner.plan(request);
  ASSERT_FALSE(plan.solved());
  EXPECT_NE(plan.reason.find("braking from the start speed of 2 m/s takes 2 m to a stop, 1.48 m to the speed"),
            std::string::npos)
      << plan.reason;
}

TEST(PlannerMoving, AStartThatStandsAtTheGoalButMovesGoesAround) {
  const Planner planner(World({}), robot());
  const Pose there{1, 2, 0.5};
  const PlanResult passing = planner.plan({.start = there, .goal = there, .start_speed = 1.0, .goal_speed = 1.0});
  ASSERT_TRUE(passing.solved());
  EXPECT_TRUE(passing.segments.empty());
  expect_valid(planner, passing);
  EXPECT_EQ(passing.trajectory().at(0.0).speed, 1.0);
  const PlanResult stopping = planner.plan({.start = there, .goal = there, .start_speed = 1.0});
  ASSERT_TRUE(stopping.solved()) << stopping.reason;
  EXPECT_FALSE(stopping.segments.empty());
  expect_valid(planner, stopping);
}

// In both gears: the start's gear is kept until the vehicle has stopped.
TEST(PlannerMoving, PlansInBothGearsBeginAndEndInTheGearsOfTheirSpeeds) {
  const World world({test::box(-2, 2, 12, 3), test::box(-2, -5, 4, -2), test::box(8, -5, 12, -2)});
  const Planner planner(world, robot());
  int backwards = 0, changing = 0;
  test::RandomInputs random(12);
  for (int i = 0; i < 40; ++i) {
    const Pose start{random.uniform(0.0, 9.0), random.uniform(-0.6, 0.9), random.uniform(-0.3, 0.3)};
    const Pose goal{random.uniform(0.0, 9.0), random.uniform(-0.6, 0.9), random.uniform(-0.3, 0.3)};
    const PlanRequest request{.start = start,
                              .goal = goal,
                              .reverse = true,
                              .start_speed = random.uniform(-1.5, 1.5),
                              .goal_speed = i % 2 == 0 ? 0.0 : random.uniform(-1.0, 1.0)};
    const PlanResult plan = planner.plan(request);
    if (!plan.solved()) continue;
    expect_valid(planner, plan, true);
    EXPECT_EQ(plan.segments.front().segment.gear, request.start_speed < 0.0 ? Gear::kReverse : Gear::kForward);
    backwards += request.start_speed < 0.0 ? 1 : 0;
    changing += cusps_of(plan.path()) > 0 ? 1 : 0;
  }
  EXPECT_GT(backwards, 10);
  EXPECT_GT(changing, 20);
}

TEST(PlannerMoving, ALineBackwardsTakesTheTimeOfItsProfile) {
  const Planner planner(World({}), Vehicle({.max_speed = 3.0,
                                            .turn_speed = LateralAccelerationLimit{0.8},
                                            .max_reverse_speed = 2.0,
                                            .max_acceleration = 1.0}));
  for (const EndSpeeds& ends : {EndSpeeds{-1.5, 0.0}, EndSpeeds{0.0, -2.0}, EndSpeeds{-2.0, -1.0}}) {
    const PlanResult plan = planner.plan(
        {.start = {9, 0, 0}, .goal = {0, 0, 0}, .reverse = true, .start_speed = ends.start, .goal_speed = ends.goal});
    ASSERT_TRUE(plan.solved()) << plan.reason;
    EXPECT_NEAR(plan.travel_time, segment_time(9.0, -ends.start, 2.0, -ends.goal, 1.0), 1e-6);
    expect_valid(planner, plan, true);
  }
}

TEST(PlannerMoving, RefusesSpeedsThatTheVehicleDoesNotHave) {
  const Planner planner(World({}), robot());
  const auto refused = [&](double start_speed, double goal_speed, bool reverse, const std::string& text) {
    try {
      static_cast<void>(planner.plan({.start = {0, 0, 0},
                                      .goal = {9, 0, 0},
                                      .reverse = reverse,
                                      .start_speed = start_speed,
                                      .goal_speed = goal_speed}));
      ADD_FAILURE() << start_speed << " " << goal_speed;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  };
  refused(2.1, 0.0, false, "start speed: 2.1 m/s, must be from 0 to 2");
  refused(0.0, std::nan(""), false, "goal speed");
  refused(0.0, -0.5, false, "driving backwards needs `reverse`");
  refused(-2.1, 0.0, true, "start speed: -2.1 m/s, must be from -2 to 2");
}

}  // namespace
}  // namespace arcway::internal

#include "arcway/trajectory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/planner.h"
#include "core/motion/speed_profile.h"
#include "tests/support/boxes.h"

namespace arcway::internal {
namespace {

Path example() {
  const PathSegment line{{0.1, 0.2, 0.0}, 7.0, 0.0};
  const PathSegment arc{line.end(), 2.0, -0.5};
  return {line, arc, {arc.end(), 1.0 / 3.0, 0.0}};
}

// Ahead, and back the same way for half of it.
Path example_with_a_cusp() {
  const PathSegment line{{0.0, 0.0, 0.0}, 4.0, 0.0};
  return {line, {line.end(), 2.0, 0.0, Gear::kReverse}};
}

// A car that is parked: slow, and slower yet on arcs.
Vehicle parking_vehicle() {
  VehicleParameters parameters;
  parameters.max_speed = 2.5;
  parameters.turn_speed = ConstantTurnSpeed{2.0};
  parameters.max_acceleration = 1.0;
  return Vehicle(parameters);
}

// Each from the end of the one before.
Path joined(Path path) {
  Pose at{-11.3, 1.1, 1.0};
  for (PathSegment& segment : path) {
    segment.start = at;
    at = segment.end();
  }
  return path;
}

// To and fro on arcs, ever less far.
Path shuffle() {
  Path path;
  for (double length = 0.2; length > 1e-7; length *= 0.6) {
    path.push_back({{}, length, -0.3});
    path.push_back({{}, 0.7 * length, 0.3, Gear::kReverse});
  }
  return joined(path);
}

// Too short to reach the top speed on, and to stop on.
Path pieces() {
  Path path;
  while (path.size() < 100) path.push_back({{}, 0.01, path.size() % 2 == 0 ? 0.0 : 0.2});
  return joined(path);
}

std::vector<Path> many_paths() {
  return {joined({{{}, 30.0, 0.0}}),
          joined({{{}, 30.0, 0.0}, {{}, 3.0, 0.4}, {{}, 0.4, 0.0}, {{}, 5.0, -0.4}, {{}, 1e-9, 0.0}}),
          example(),
          reversed(example()),
          example_with_a_cusp(),
          shuffle(),
          pieces()};
}

template <class Error, class Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Trajectory, HasTheStatesOfEachPhase) {
  // From rest to 12 m/s at 50 m/s^2: 0.24 s and 1.44 m. The other 27.12 m at 12 m/s take 2.26 s. Then it brakes.
  const Trajectory trajectory(Path{{{1.0, 2.0, 0.0}, 30.0, 0.0}}, Vehicle{});
  EXPECT_DOUBLE_EQ(trajectory.duration(), 2.74);
  EXPECT_EQ(trajectory.length(), 30.0);
  const TrajectoryState start = trajectory.at(0.0);
  EXPECT_EQ(start.pose.x, 1.0);
  EXPECT_EQ(start.speed, 0.0);
  EXPECT_DOUBLE_EQ(start.acceleration, 50.0);
  const TrajectoryState accelerating = trajectory.at(0.1);
  EXPECT_DOUBLE_EQ(accelerating.distance, 0.25);
  EXPECT_DOUBLE_EQ(accelerating.pose.x, 1.25);
  EXPECT_EQ(accelerating.pose.y, 2.0);
  EXPECT_DOUBLE_EQ(accelerating.speed, 5.0);
  EXPECT_EQ(accelerating.time, 0.1);
  const TrajectoryState holding = trajectory.at(1.24);
  EXPECT_DOUBLE_EQ(holding.distance, 1.44 + 12.0);
  EXPECT_EQ(holding.speed, 12.0);
  EXPECT_EQ(holding.acceleration, 0.0);
  const TrajectoryState braking = trajectory.at(2.64);
  EXPECT_NEAR(braking.distance, 29.75, 1e-13);
  EXPECT_NEAR(braking.speed, 5.0, 1e-12);
  EXPECT_DOUBLE_EQ(braking.acceleration, -50.0);
  const TrajectoryState end = trajectory.at(trajectory.duration());
  EXPECT_EQ(end.distance, 30.0);
  EXPECT_EQ(end.pose.x, 31.0);
  EXPECT_EQ(end.speed, 0.0);
  EXPECT_EQ(end.time, trajectory.duration());
}

TEST(Trajectory, TellsCurvatureSteeringAngleAndGear) {
  const Trajectory trajectory(example(), Vehicle{});
  const TrajectoryState turning = trajectory.at_distance(8.0);
  EXPECT_EQ(turning.segment, 1u);
  EXPECT_EQ(turning.curvature, -0.5);
  EXPECT_DOUBLE_EQ(turning.steering_angle, std::atan(-0.5 * 1.3));
  EXPECT_DOUBLE_EQ(turning.pose.heading, -0.5);
  const Trajectory back(example_with_a_cusp(), Vehicle{});
  EXPECT_EQ(back.at_distance(3.9).gear, Gear::kForward);
  const TrajectoryState cusp = back.at_distance(4.0);
  EXPECT_EQ(cusp.gear, Gear::kReverse);
  EXPECT_EQ(cusp.speed, 0.0);
  EXPECT_EQ(back.at_distance(5.0).pose.x, 3.0);
  EXPECT_EQ(back.at(cusp.time).gear, Gear::kReverse);
}

TEST(Trajectory, AgreesWithItselfByTimeAndByDistance) {
  for (const Path& path : many_paths()) {
    for (const Vehicle& vehicle : {Vehicle{}, parking_vehicle()}) {
      const Trajectory trajectory(path, vehicle);
      const double all = trajectory.duration(), step = all / 1023.0;
      for (double t = step; t < all - step; t += step) {
        const TrajectoryState state = trajectory.at(t);
        // By the speeds a hundredth of a step before and after, which the acceleration limits.
        const double h = 0.01 * step, a = vehicle.max_acceleration();
        const TrajectoryState before = trajectory.at(t - h), after = trajectory.at(t + h);
        const double rounding = 1e-14 * (1.0 + trajectory.length());
        ASSERT_NEAR(after.distance - before.distance, 2.0 * h * state.speed, a * h * h + 2.0 * rounding) << t;
        ASSERT_NEAR(state.speed, before.speed, a * h * (1.0 + 1e-9) + 1e-12) << t;
        ASSERT_LE(std::abs(state.acceleration), a * (1.0 + 1e-9)) << t;
        const TrajectoryState there = trajectory.at_distance(state.distance);
        ASSERT_NEAR(there.distance, state.distance, rounding);
        // Where it is slow a rounded distance is passed a while before or after.
        ASSERT_NEAR(there.time, t, rounding / std::max(state.speed, std::sqrt(a * rounding)) + 1e-14 * (1.0 + all))
            << t;
        const Pose pose = path.at(std::min(state.distance, path.length()));
        ASSERT_NEAR(pose.x, state.pose.x, 1e-12);
        ASSERT_NEAR(pose.y, state.pose.y, 1e-12);
        ASSERT_NEAR(std::remainder(pose.heading - state.pose.heading, kTwoPi), 0.0, 1e-12);
        ASSERT_LE(std::abs(state.pose.heading), kPi);
      }
    }
  }
}

TEST(Trajectory, SamplesTimesAtOneStepAndTheEnd) {
  const Trajectory trajectory(Path{{{1.0, 2.0, 0.0}, 30.0, 0.0}}, Vehicle{});
  const std::vector<TrajectoryState> states = trajectory.sample(0.5);
  ASSERT_EQ(states.size(), 7u);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_DOUBLE_EQ(states[i].time, 0.5 * static_cast<double>(i));
  EXPECT_EQ(states.back().time, trajectory.duration());
  EXPECT_EQ(states.back().pose.x, 31.0);
  EXPECT_EQ(trajectory.sample(trajectory.duration() / 3.0).size(), 4u);
  EXPECT_EQ(trajectory.sample(std::numeric_limits<double>::infinity()).size(), 2u);
  EXPECT_EQ(error_of<std::invalid_argument>([&] { static_cast<void>(trajectory.sample(0.0)); }),
            "Trajectory::sample: dt is 0, must be > 0");
  EXPECT_NE(error_of<std::invalid_argument>([&] { static_cast<void>(trajectory.sample(1e-9)); }).find("1e-09 s"),
            std::string::npos);
}

// A motion that takes longer than the fastest one holds a lower top speed.
TEST(Trajectory, TakesTheTimeThatIsGiven) {
  const Vehicle vehicle({.max_speed = 12.0, .max_acceleration = 2.0});
  for (const auto& [v1, v3] : {std::pair(0.0, 0.0), {3.0, 0.0}, {1.0, 4.0}, {4.0, 4.0}})
    for (const double slower : {1.0, 1.01, 1.2}) {
      const double fastest = segment_time(30.0, v1, 12.0, v3, 2.0);
      const Trajectory trajectory(std::vector{TimedSegment{{{}, 30.0, 0.0}, v1, v3, slower * fastest}}, vehicle);
      double distance = 0.0, top = 0.0;
      constexpr int kSteps = 20000;
      for (int i = 0; i < kSteps; ++i) {
        const TrajectoryState state = trajectory.at(slower * fastest * (i + 0.5) / kSteps);
        distance += state.speed * slower * fastest / kSteps;
        top = std::max(top, state.speed);
        EXPECT_LE(std::abs(state.acceleration), 2.0 * (1.0 + 1e-12));
      }
      EXPECT_NEAR(distance, 30.0, 1e-4);
      EXPECT_NEAR(trajectory.at(trajectory.duration()).distance, 30.0, 1e-12);
      EXPECT_NEAR(trajectory.at(slower * fastest * (1.0 - 1e-9)).distance, 30.0, 1e-6);
      EXPECT_GE(top, std::max(v1, v3) - 1e-3);
    }
}

TEST(Trajectory, WaitsOnSegmentsWithoutLength) {
  const PathSegment line{{}, 30.0, 0.0};
  const Trajectory trajectory(
      std::vector<TimedSegment>{{line, 0.0, 0.0, 2.74}, {{line.end(), 0.0, 0.0}, 0.0, 0.0, 5.0}}, Vehicle{});
  EXPECT_EQ(trajectory.duration(), 7.74);
  EXPECT_EQ(trajectory.at(5.0).distance, 30.0);
  EXPECT_EQ(trajectory.at(5.0).speed, 0.0);
  EXPECT_EQ(trajectory.at(5.0).segment, 1u);
  EXPECT_EQ(trajectory.sample(PathSampling{}).back().time, 7.74);
}

TEST(Trajectory, RefusesWhatIsOutside) {
  const Trajectory trajectory(Path{{{}, 30.0, 0.0}}, Vehicle{});
  EXPECT_EQ(error_of<std::out_of_range>([&] { static_cast<void>(trajectory.at(3.0)); }),
            "Trajectory::at: time 3 s is outside of 0 to 2.74 s");
  EXPECT_EQ(error_of<std::out_of_range>([&] { static_cast<void>(trajectory.at_distance(-1.0)); }),
            "Trajectory::at_distance: distance -1 m is outside of 0 to 30 m");
  EXPECT_THROW(static_cast<void>(trajectory.at(std::nan(""))), std::out_of_range);
  EXPECT_THROW(static_cast<void>(trajectory.at_distance(std::nan(""))), std::out_of_range);
  EXPECT_THROW(static_cast<void>(trajectory.clearance_at(0.0)), std::logic_error);
}

TEST(Trajectory, RefusesMotionsThatTheVehicleCannotDrive) {
  const auto error = [](const TimedSegment& segment) {
    return error_of<std::invalid_argument>([&] { Trajectory(std::vector{segment}, Vehicle{}); });
  };
  const PathSegment line{{}, 30.0, 0.0};
  EXPECT_EQ(error({line, 0.0, 0.0, 2.74}), "no error");
  EXPECT_EQ(error({line, 0.0, 0.0, 2.74 + 1e-7}), "no error");
  // Rounding of a femtosecond, in either direction.
  const PathSegment shortest{{}, 4e-16, 0.0};
  for (const double duration : {1e-16, 3e-16}) EXPECT_EQ(error({shortest, 2.4, 2.4, duration}), "no error");
  EXPECT_NE(error({shortest, 2.4, 2.4, 1e-8}), "no error");
  EXPECT_EQ(error({line, 0.0, 0.0, 2.5}),
            "Trajectory: segment 0: duration is 2.5 s, but the fastest motion takes 2.74 s");
  EXPECT_EQ(error({line, 6.0, 6.0, 6.0}),
            "Trajectory: segment 0: duration is 6 s, but without braking below 6 m/s it takes at most 5 s; give "
            "segments with lower speeds");
  EXPECT_NE(error({line, 0.0, 0.0, INFINITY}), "no error");
  EXPECT_EQ(error({line, 13.0, 0.0, 2.74}), "Trajectory: segment 0: a speed is 13 m/s, must be >= 0 and <= 12");
  EXPECT_EQ(error({{{}, 0.01, 0.0}, 0.0, 8.0, 0.1}),
            "Trajectory: segment 0: its speeds are 0 and 8 m/s, but 0.01 m are long enough for 1 m/s only");
  EXPECT_EQ(error({{{}, -1.0, 0.0}}), "Trajectory: segment 0: length is -1 m, must be >= 0");
  EXPECT_EQ(error({{{}, 1.0, std::nan("")}}), "Trajectory: segment 0: a number is nan, must be finite");
  EXPECT_EQ(error_of<std::invalid_argument>([] { Trajectory(Path{}, Vehicle{}); }),
            "Trajectory: the path has no segments");
  EXPECT_EQ(error_of<std::invalid_argument>([&] {
              Trajectory(TimedPath{{line}, {0.0}, {}, {}}, Vehicle{});
            }),
            "Trajectory: 1 segments have 1 and 0 speeds and 0 durations, must have one each or none");
  EXPECT_DOUBLE_EQ(Trajectory(TimedPath{{line}, {}, {}, {}}, Vehicle{}).duration(), 2.74);
}

TEST(Trajectory, OfAPlanKnowsItsVehicleAndWorld) {
  const World world({test::box(8.0, -4.0, 12.0, 4.0)});
  const Planner planner(world, parking_vehicle());
  const PlanResult plan = planner.plan({.start = {0, 0, 0}, .goal = {20, 0, 0}});
  ASSERT_TRUE(plan.solved());
  const Trajectory trajectory = plan.trajectory();
  EXPECT_DOUBLE_EQ(trajectory.duration(), plan.travel_time);
  EXPECT_DOUBLE_EQ(trajectory.length(), plan.length);
  double least = std::numeric_limits<double>::infinity();
  for (const TrajectoryState& state : trajectory.sample(0.01))
    least = std::min(least, trajectory.clearance_at(state.time));
  EXPECT_GE(least, plan.min_clearance);
  EXPECT_LT(least, plan.min_clearance + 0.05);
  // The rear is 0.1 m behind F, which is 8 m from the obstacle. The front is 1.4 m ahead.
  EXPECT_DOUBLE_EQ(trajectory.clearance_at(0.0), 6.6);
  EXPECT_DOUBLE_EQ(trajectory.clearance_at(0.0, World({test::box(4.0, -1.0, 5.0, 1.0)})), 2.6);
  EXPECT_TRUE(std::isinf(trajectory.clearance_at(0.0, World({}))));
}

TEST(Trajectory, OfAPlanWithoutAPathSaysWhy) {
  const World world({test::box(8.0, -4.0, 12.0, 4.0)});
  const PlanResult plan = Planner(world, Vehicle{}).plan({.start = {0, 0, 0}, .goal = {10, 0, 0}});
  EXPECT_EQ(error_of<std::invalid_argument>([&] {
              static_cast<void>(plan.trajectory());
            }).find("Trajectory: the plan has no path: goal in collision, the goal (10, 0, 0): the body"),
            0u);
  PlanResult unknown;
  unknown.status = PlanStatus::kSolved;
  EXPECT_NE(error_of<std::invalid_argument>([&] { static_cast<void>(unknown.trajectory()); }).find("no planner made"),
            std::string::npos);
}

TEST(Trajectory, StaysWhereStartAndGoalAreOne) {
  const Planner planner(World({}), Vehicle{});
  const Trajectory trajectory(planner.plan({.start = {3, 4, 1}, .goal = {3, 4, 1}}));
  EXPECT_EQ(trajectory.duration(), 0.0);
  EXPECT_EQ(trajectory.at(0.0).pose.x, 3.0);
  EXPECT_EQ(trajectory.at(0.0).speed, 0.0);
  EXPECT_EQ(trajectory.at_distance(0.0).pose.heading, 1.0);
}

TEST(Trajectory, DrivesAtConstantAccelerationBetweenSamples) {
  const std::vector<Path> paths = many_paths();
  for (std::size_t k = 0; k < paths.size(); ++k) {
    for (const Vehicle& vehicle : {Vehicle{}, parking_vehicle()}) {
      for (const PathSampling& sampling :
           {PathSampling{}, PathSampling{.max_length = 1e3, .max_angle = 1e3}, PathSampling{.max_length = 0.013}}) {
        SCOPED_TRACE(testing::Message() << "path " << k << ", top speed " << vehicle.max_speed() << ", step "
                                        << sampling.max_length);
        const Trajectory trajectory(paths[k], vehicle);
        const std::vector<TrajectoryState> samples = trajectory.sample(sampling);
        const double a = vehicle.max_acceleration();
        const double rounding = 1e-13 * (1.0 + trajectory.length()), moment = 1e-13 * (1.0 + trajectory.duration());
        double length = 0.0;
        for (std::size_t i = 1; i < samples.size(); ++i) {
          const TrajectoryState &before = samples[i - 1], &after = samples[i];
          const double ds = after.distance - before.distance, dt = after.time - before.time;
          ASSERT_GE(ds, 0.0) << i;
          ASSERT_GE(dt, 0.0) << i;
          ASSERT_LE(ds, sampling.max_length + rounding) << i;
          ASSERT_LE(ds * std::abs(after.curvature), sampling.max_angle + rounding) << i;
          ASSERT_NEAR(0.5 * (before.speed + after.speed) * dt, ds, rounding) << i;
          // It accelerates, holds its speed, or brakes.
          const double dv = std::abs(after.speed - before.speed);
          ASSERT_LE(std::min(dv, std::abs(a * dt - dv)), a * moment) << i;
          length += 0.5 * (before.speed + after.speed) * dt;
        }
        EXPECT_NEAR(length, trajectory.length(), rounding);
        EXPECT_EQ(samples.back().speed, 0.0);
        EXPECT_NEAR(samples.back().time, trajectory.duration(), moment);
      }
    }
  }
}

TEST(Trajectory, HasNoSampleForRounding) {
  // Braking all the way: the speeds that it takes are rounded, and no way is left to accelerate on.
  for (double length = 1e-9; length < 1.0; length *= 1.7) {
    const Path path{{{}, 20.0, 0.0}, {{20.0, 0.0, 0.0}, length, 0.0}};
    const std::vector<TrajectoryState> samples = Trajectory(path, Vehicle{}).sample({.max_length = 100.0});
    EXPECT_EQ(samples.size(), 5u) << length;
  }
}

TEST(Trajectory, HasTheCuspOnceInEachGear) {
  const std::vector<TrajectoryState> samples = Trajectory(example_with_a_cusp(), Vehicle{}).sample({.max_length = 1.0});
  // 1.44 m each to accelerate to 12 m/s and to brake, 1.12 m between; back 1 m each.
  ASSERT_EQ(samples.size(), 7u + 3u);
  EXPECT_EQ(samples[2].speed, 12.0);
  EXPECT_NEAR(samples[2].distance, 1.44, 1e-15);
  EXPECT_NEAR(samples[2].time, 12.0 / 50.0, 1e-15);
  EXPECT_EQ(samples[4].speed, 12.0);
  EXPECT_NEAR(samples[4].distance, 4.0 - 1.44, 1e-15);
  EXPECT_EQ(samples[6].gear, Gear::kForward);
  EXPECT_EQ(samples[7].gear, Gear::kReverse);
  EXPECT_EQ(samples[7].distance, samples[6].distance);
  EXPECT_EQ(samples[7].time, samples[6].time);
  EXPECT_EQ(samples[6].speed, 0.0);
  EXPECT_EQ(samples[7].speed, 0.0);
  EXPECT_DOUBLE_EQ(samples[8].speed, 10.0);
  EXPECT_EQ(samples[9].pose.x, 2.0);
  EXPECT_EQ(samples[9].distance, 6.0);
}

TEST(Trajectory, RefusesStepsThatAreNoneOrTooMany) {
  const Trajectory trajectory(example(), Vehicle{});
  const auto error = [&](const PathSampling& sampling) {
    return error_of<std::invalid_argument>([&] { static_cast<void>(trajectory.sample(sampling)); });
  };
  EXPECT_EQ(error({.max_length = 0.0}), "Trajectory::sample: max_length is 0, must be > 0");
  EXPECT_EQ(error({.max_angle = -1.0}), "Trajectory::sample: max_angle is -1, must be > 0");
  EXPECT_EQ(error({.max_length = std::nan("")}), "Trajectory::sample: max_length is nan, must be > 0");
  const std::string few = error({.max_length = 1e-300});
  EXPECT_NE(few.find("steps of at most 1e-300 m and 0.05 rad, must be at most 1e+07"), std::string::npos) << few;
  EXPECT_NE(error({.max_angle = 5e-324}).find("the path has inf steps"), std::string::npos);
  EXPECT_EQ(error({.max_length = 100.0 * trajectory.length() / kMostSamplingSteps}), "no error");
}

}  // namespace
}  // namespace arcway::internal

#include "core/motion/travel_time_lower_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/planner.h"
#include "core/motion/dubins.h"
#include "core/motion/reeds_shepp.h"
#include "core/motion/speed_profile.h"
#include "core/zones/speed_zones.h"
#include "tests/support/boxes.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

Vehicle vehicle_with(const TurnSpeedLaw& law, double acceleration) {
  VehicleParameters parameters;
  parameters.turn_speed = law;
  parameters.max_acceleration = acceleration;
  return Vehicle(parameters);
}

double straight_time(double length, const Vehicle& vehicle) {
  return segment_time(length, 0.0, vehicle.max_speed(), 0.0, vehicle.max_acceleration());
}

TEST(TravelTimeLowerBound, IsMetByAStraightLine) {
  const Vehicle vehicle;
  const double bound = travel_time_lower_bound({1, 2, 0.0}, {31, 2, 0.0}, 30.0, vehicle);
  EXPECT_NEAR(bound, straight_time(30.0, vehicle), 1e-10);
  EXPECT_LE(bound, straight_time(30.0, vehicle));
  EXPECT_EQ(travel_time_lower_bound({1, 2, 0.5}, {1, 2, 0.5}, 0.0, vehicle), 0.0);
}

// Along a line that leaves the discs about its ends where they end.
TEST(TravelTimeLowerBound, IsMetByALineThroughZonesAtItsEnds) {
  const Vehicle vehicle;
  const Pose start{0, 0, 0}, goal{40, 0, 0};
  const PathSegment line{start, 40.0, 0.0};
  for (const auto& [first, last] : std::vector<std::pair<double, double>>{{5, 3}, {0, 7}, {6, 0}, {25, 30}, {50, 50}})
    for (const EndSpeeds& ends : {EndSpeeds{}, EndSpeeds{0.5, 0.25}}) {
      std::vector<Zone> zones;
      if (first > 0) zones.push_back({test::box(-60, -60, first, 60), SpeedLimit{1.0}});
      if (last > 0) zones.push_back({test::box(40.0 - last, -60, 100, 60), SpeedLimit{2.0}});
      const SpeedZones limits(zones);
      SpeedProfile profile;
      const double time = travel_time(std::span(&line, 1), vehicle, ends, profile, &limits);
      const double bound = travel_time_lower_bound(start, goal, 40.0, vehicle, false, ends, &limits);
      EXPECT_LE(bound, time);
      EXPECT_NEAR(bound, time, 2e-6 * time) << first << ", " << last;
    }
}

TEST(TravelTimeLowerBound, IsInfiniteWithoutAWay) {
  EXPECT_EQ(travel_time_lower_bound({0, 0, 0}, {5, 0, 0}, std::numeric_limits<double>::infinity(), Vehicle{}),
            std::numeric_limits<double>::infinity());
}

TEST(TravelTimeLowerBound, CountsTheTimeLostOnArcs) {
  // Facing away at both ends: the headings turn by pi at least. 0.5 * 1.3 * pi meters of arc at each end, at 8 of 12
  // m/s.
  const Vehicle vehicle;
  const double half = 0.5 * vehicle.min_turning_radius() * kPi;
  const double a = vehicle.max_acceleration();
  const double slow = 8.0 * 8.0 / (2.0 * a), fast = 12.0 * 12.0 / (2.0 * a);
  const double lost = (fast - slow) / 8.0 - (12.0 - 8.0) / a + (half - fast) * (1.0 / 8.0 - 1.0 / 12.0);
  const Pose start{0, 0, kPi}, goal{100, 0, kPi};
  double word = std::numeric_limits<double>::infinity();
  for (const DubinsWord w : kDubinsWords)
    if (const auto path = dubins_path(w, start, goal, vehicle.min_turning_radius()))
      word = std::min(word, length_of(*path));
  EXPECT_NEAR(travel_time_lower_bound(start, goal, 100.0, vehicle), straight_time(word, vehicle) + 2.0 * lost, 1e-9);
  // Where arcs are as fast as lines nothing is lost.
  const Vehicle even = vehicle_with(ConstantTurnSpeed{12.0}, 50.0);
  EXPECT_NEAR(travel_time_lower_bound(start, goal, 100.0, even), straight_time(word, even), 1e-9);
  // Of a table the highest speed counts, wherever it is.
  for (const TurnSpeedTable& table :
       {TurnSpeedTable{{{1.0, 3.0}, {4.0, 8.0}, {9.0, 6.0}}}, TurnSpeedTable{{{1.0, 8.0}, {4.0, 3.0}}},
        TurnSpeedTable{{{1.0, 3.0}, {4.0, 8.0}}}})
    EXPECT_EQ(travel_time_lower_bound(start, goal, 100.0, vehicle_with(table, a)),
              travel_time_lower_bound(start, goal, 100.0, vehicle));
}

TEST(TravelTimeLowerBound, NoWordIsFaster) {
  test::RandomInputs random(4);
  const TurnSpeedTable table{{{1.0, 3.0}, {4.0, 9.0}, {9.0, 6.0}}};
  for (const TurnSpeedLaw& law : {TurnSpeedLaw{ConstantTurnSpeed{8.0}}, TurnSpeedLaw{ConstantTurnSpeed{1.0}},
                                  TurnSpeedLaw{LateralAccelerationLimit{2.0}}, TurnSpeedLaw{table}})
    for (const double acceleration : {0.5, 2.0, 50.0}) {
      const Vehicle vehicle = vehicle_with(law, acceleration);
      for (int i = 0; i < 400; ++i) {
        const double side = i % 2 == 0 ? 4.0 : 60.0;
        const auto pose = [&] {
          return Pose{random.uniform(0.0, side), random.uniform(0.0, side), random.uniform(-kPi, kPi)};
        };
        const Pose start = pose(), goal = pose();
        const double bound = travel_time_lower_bound(start, goal, (goal.position() - start.position()).norm(), vehicle);
        for (const DubinsWord word : kDubinsWords)
          for (const double factor : {1.0, 1.5, 4.0}) {
            const auto path = dubins_path(word, start, goal, factor * vehicle.min_turning_radius());
            if (!path) continue;
            ASSERT_GE(speed_profile(*path, vehicle).total_time, bound) << "poses " << i;
          }
      }
    }
}

TEST(TravelTimeLowerBound, NoWordBetweenMovingEndsIsFaster) {
  test::RandomInputs random(14);
  SpeedProfile profile;
  int possible = 0, moved = 0;
  for (const TurnSpeedLaw& law : {TurnSpeedLaw{ConstantTurnSpeed{8.0}}, TurnSpeedLaw{LateralAccelerationLimit{2.0}}})
    for (const double acceleration : {0.5, 2.0, 50.0}) {
      const Vehicle vehicle = vehicle_with(law, acceleration);
      for (int i = 0; i < 1000; ++i) {
        const double side = i % 2 == 0 ? 4.0 : 60.0;
        const auto pose = [&] {
          return Pose{random.uniform(0.0, side), random.uniform(0.0, side), random.uniform(-kPi, kPi)};
        };
        const Pose start = pose(), goal = i % 7 == 0 ? start : pose();
        const EndSpeeds ends{random.uniform(0.0, 6.0), random.uniform(0.0, 6.0)};
        const double distance = (goal.position() - start.position()).norm();
        const double bound = travel_time_lower_bound(start, goal, distance, vehicle, false, ends);
        const double at_rest = travel_time_lower_bound(start, goal, distance, vehicle);
        moved += bound < at_rest ? 1 : 0;
        for (const DubinsWord word : kDubinsWords)
          for (const double factor : {1.0, 4.0, 12.0}) {
            const auto path = dubins_path(word, start, goal, factor * vehicle.min_turning_radius());
            if (!path) continue;
            const double time = travel_time(*path, vehicle, ends, profile);
            possible += std::isinf(time) ? 0 : 1;
            ASSERT_GE(time, bound) << "poses " << i;
          }
      }
    }
  EXPECT_GT(possible, 10000);
  EXPECT_GT(moved, 4000);
}

TEST(TravelTimeLowerBound, IsMetByALineBetweenMovingEnds) {
  const Vehicle vehicle = vehicle_with(ConstantTurnSpeed{8.0}, 2.0);
  const Pose start{1, 2, 0.0}, goal{31, 2, 0.0};
  for (const EndSpeeds& ends : {EndSpeeds{5.0, 0.0}, EndSpeeds{0.0, 6.0}, EndSpeeds{8.0, 3.0}, EndSpeeds{10.0, 12.0}}) {
    const double bound = travel_time_lower_bound(start, goal, 30.0, vehicle, false, ends);
    EXPECT_NEAR(bound, segment_time(30.0, ends.start, 12.0, ends.goal, 2.0), 1e-5);
  }
  // Too short to brake on: the path is at least 36 m long.
  EXPECT_NEAR(travel_time_lower_bound(start, goal, 30.0, vehicle, false, {12.0, 0.0}), 6.0, 1e-5);
}

// Of all ways to part the arcs between both ends, the one that costs least, by sums.
TEST(TravelTimeLowerBound, CountsTheTimeLostOnArcsBetweenMovingEnds) {
  const Vehicle vehicle = vehicle_with(ConstantTurnSpeed{3.0}, 2.0);
  const Pose start{0, 0, kPi}, goal{100, 0, kPi};
  const double arcs = vehicle.min_turning_radius() * kPi;
  for (const EndSpeeds& ends : {EndSpeeds{2.5, 1.0}, EndSpeeds{0.0, 2.9}, EndSpeeds{4.0, 3.5}}) {
    constexpr int kPieces = 4000;
    const double piece = arcs / kPieces;
    std::vector<double> from_start{0.0}, from_goal{0.0};  // lost on the first pieces
    for (int i = 0; i < kPieces; ++i) {
      const auto lost = [&](double speed) {
        const double fastest = std::min(12.0, std::sqrt(speed * speed + 4.0 * (i + 0.5) * piece));
        return piece * std::max(0.0, 1.0 / 3.0 - 1.0 / fastest);
      };
      from_start.push_back(from_start.back() + lost(ends.start));
      from_goal.push_back(from_goal.back() + lost(ends.goal));
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i <= kPieces; ++i) least = std::min(least, from_start[i] + from_goal[kPieces - i]);
    EXPECT_GT(least, 0.0);
    const Vehicle even = vehicle_with(ConstantTurnSpeed{12.0}, 2.0);
    EXPECT_NEAR(travel_time_lower_bound(start, goal, 100.0, vehicle, false, ends),
                travel_time_lower_bound(start, goal, 100.0, even, false, ends) + least, 1e-4);
  }
}

TEST(TravelTimeLowerBound, NoPlanIsFasterAndTheStraightLineIsWeaker) {
  for (const bool real : {false, true}) {
    const Vehicle vehicle = real ? vehicle_with(LateralAccelerationLimit{2.0}, 2.0) : Vehicle{};
    const World world = random_world({.kind = ClutterKind::kStar, .obstacles = 40, .vertices = 8, .fill = 0.3});
    const Planner planner(world, vehicle, {.refinement = {.max_trials = 1000}});
    const Planner weaker(world, vehicle, {.point_robot_lower_bound = false, .refinement = {.max_trials = 0}});
    test::RandomInputs random(8);
    int solved = 0, sharper = 0;
    for (int i = 0; i < 60; ++i) {
      const auto pose = [&] {
        return Pose{random.uniform(0.0, world.box().max.x()), random.uniform(0.0, world.box().max.y()),
                    random.uniform(-kPi, kPi)};
      };
      const PlanRequest request{pose(), pose()};
      const PlanResult result = planner.plan(request);
      if (!result.solved()) continue;
      ++solved;
      const double line = straight_time((request.goal.position() - request.start.position()).norm(), vehicle);
      const PlanResult less = weaker.plan(request);
      EXPECT_GE(result.travel_time, result.lower_bound);
      EXPECT_GE(result.lower_bound, less.lower_bound);
      EXPECT_GE(less.lower_bound, line * (1.0 - 1e-11));
      EXPECT_NEAR(result.optimality_gap(), result.travel_time / result.lower_bound - 1.0, 1e-15);
      sharper += result.lower_bound > less.lower_bound ? 1 : 0;
    }
    EXPECT_GT(solved, 10);
    EXPECT_GT(sharper, 0);
  }
}

// Segments miss each other by the rounding of their coordinates.
TEST(TravelTimeLowerBound, NoPlanIsFasterFarFromTheOrigin) {
  const Planner planner(World({}), Vehicle{});
  test::RandomInputs random(5);
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    const Vec2 from = random.point(5e6, 5e6 + 30.0);
    const double heading = random.uniform(-kPi, kPi);
    const Vec2 to = from + random.uniform(1.0, 20.0) * direction_of(heading);
    const PlanResult plan =
        planner.plan({.start = {from.x(), from.y(), heading}, .goal = {to.x(), to.y(), heading}, .reverse = true});
    ASSERT_TRUE(plan.solved());
    EXPECT_GE(plan.travel_time, plan.lower_bound);
    EXPECT_LE(plan.optimality_gap(), 1e-6);
  }
}

TEST(TravelTimeLowerBound, HoldsInBothGearsIfBothAreAllowed) {
  const Vehicle vehicle;
  // Straight back: far less than what it takes forwards.
  const double back = travel_time_lower_bound({0, 0, 0}, {-10, 0, 0}, 10.0, vehicle, true);
  EXPECT_NEAR(back, straight_time(10.0, vehicle), 1e-10);
  EXPECT_GT(travel_time_lower_bound({0, 0, 0}, {-10, 0, 0}, 10.0, vehicle), back);
  test::RandomInputs random(3);
  for (int i = 0; i < 2000; ++i) {
    const auto pose = [&] {
      return Pose{random.uniform(0.0, 12.0), random.uniform(0.0, 12.0), random.uniform(-kPi, kPi)};
    };
    const Pose start = pose(), goal = pose();
    const double distance = (goal.position() - start.position()).norm();
    const double bound = travel_time_lower_bound(start, goal, distance, vehicle, true);
    EXPECT_LE(bound, travel_time_lower_bound(start, goal, distance, vehicle) * (1.0 + 1e-9));
    for (std::size_t word = 0; word < kReedsSheppWords; ++word) {
      const auto path = reeds_shepp_path(word, start, goal, vehicle.min_turning_radius());
      if (path) {
        EXPECT_LE(bound, speed_profile(*path, vehicle).total_time);
      }
    }
  }
}

// The rounding of the places turns the line between them.
TEST(TravelTimeLowerBound, NoPlanBetweenPlacesNextToEachOtherIsFaster) {
  const Vehicle vehicle({.length = 0.375, .width = 1.018, .wheelbase = 0.08956});
  const Planner planner(World({}), vehicle, {.radii = {0.0896, 6.9}});
  test::RandomInputs random(2);
  for (int i = 0; i < 500; ++i) {
    const double heading = random.uniform(-kPi, kPi), distance = std::exp(random.uniform(-30.0, -10.0));
    const Vec2 at = random.point(0.0, 10.0), there = at + distance * direction_of(heading);
    const PlanResult plan = planner.plan({{at.x(), at.y(), heading}, {there.x(), there.y(), heading}});
    ASSERT_TRUE(plan.solved());
    EXPECT_LE(plan.lower_bound, plan.travel_time * (1.0 + 1e-12)) << i;
  }
}

// An arc that leads there up to the rounding of places may have another heading there.
TEST(TravelTimeLowerBound, NoSingleArcIsFasterFarFromTheOrigin) {
  const Vehicle vehicle({.wheelbase = 0.2, .safety_margin = 0.1});
  const Planner planner(World({}), vehicle);
  test::RandomInputs random(4);
  for (int i = 0; i < 500; ++i) {
    const Vec2 at = random.point(-5e8, 5e8);
    const PathSegment arc{{at.x(), at.y(), random.uniform(-kPi, kPi)}, random.uniform(0.01, 0.5), 5.0};
    const PlanResult plan = planner.plan({arc.start, arc.end()});
    ASSERT_TRUE(plan.solved());
    EXPECT_LE(plan.lower_bound, plan.travel_time * (1.0 + 1e-12)) << i;
  }
}

// What is beside a pose by the rounding of its place alone is no way off in both gears.
TEST(TravelTimeLowerBound, IsThatOfALineToAPlaceAheadWhateverRoundingPutsItBeside) {
  const Vehicle vehicle({.wheelbase = 0.0017108857310877202, .max_steering_angle = 0.88284777485843047});
  const Pose start{964.42284843218351, -985.27088661988967, 1.8039582235336526};
  const Pose goal{964.42284843314758, -985.27088662394942, 1.8039582235336526};
  const double distance = (goal.position() - start.position()).norm();
  EXPECT_LE(travel_time_lower_bound(start, goal, distance, vehicle, true), straight_time(distance, vehicle));
}

}  // namespace
}  // namespace arcway::internal

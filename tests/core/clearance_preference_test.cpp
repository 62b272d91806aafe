#include "arcway/clearance_preference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/datasets/read_map.h"
#include "arcway/planner.h"
#include "arcway/tour.h"
#include "tests/support/boxes.h"
#include "tests/support/free_plans.h"
#include "tests/support/plans.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

using test::box;

// 1.5 m x 0.8 m, as fast on lines as in turns.
Vehicle robot() {
  return Vehicle({.max_speed = 1.0, .turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 1.0});
}

PlannerOptions preferring(double distance, double cost = ClearancePreference::kHighCost) {
  return {.clearance_preference = ClearancePreference{distance, cost}};
}

const Polygon kHall = box(-5, -20, 45, 20);

// A wall across the hall, with gaps from some heights to others.
World walled(const std::vector<std::pair<double, double>>& gaps) {
  std::vector<Polygon> walls;
  double from = -20.0;
  for (const auto& [low, high] : gaps) {
    walls.push_back(box(19.5, from, 20.5, low));
    from = high;
  }
  walls.push_back(box(19.5, from, 20.5, 20.0));
  return World(walls, kHall.outer);
}

PlanResult planned(const World& world, const PlannerOptions& options, const PlanRequest& request) {
  const Planner planner(world, robot(), options);
  PlanResult plan = planner.plan(request);
  if (plan.solved()) test::expect_valid(planner, plan, request.reverse);
  return plan;
}

TEST(ClearancePreference, IsKeptWhereThereIsRoom) {
  const World world({box(10, -8, 12, 3), box(25, -2, 28, 9)}, kHall.outer);
  const PlanRequest request{.start = {0, 0, 0}, .goal = {40, 0, 0}};
  const PlanResult close = planned(world, {}, request);
  ASSERT_TRUE(close.solved());
  EXPECT_FALSE(close.close_driving);
  EXPECT_LT(close.min_clearance, 0.1);
  for (const double distance : {0.3, 0.7, 1.5}) {
    const PlanResult plan = planned(world, preferring(distance), request);
    ASSERT_TRUE(plan.solved());
    ASSERT_TRUE(plan.close_driving);
    EXPECT_EQ(plan.close_driving->distance, distance);
    EXPECT_EQ(plan.close_driving->length, 0.0);
    EXPECT_EQ(plan.cost(), plan.travel_time);
    EXPECT_GE(plan.min_clearance, distance);
    EXPECT_GT(plan.travel_time, close.travel_time);
    // The detour is no more than going around corners in a wider turn.
    EXPECT_LT(plan.travel_time, close.travel_time + 4.0 * distance + 0.5);
  }
}

TEST(ClearancePreference, IsGivenUpWhereNeededAndNoLonger) {
  const PlanRequest request{.start = {0, 10, 0}, .goal = {40, 10, 0}};
  const World world = walled({{-1.0, 1.0}});  // 0.6 m beside the body
  const double distance = 1.0, length = robot().footprint().length();
  const PlanResult plan = planned(world, preferring(distance), request);
  ASSERT_TRUE(plan.solved());
  ASSERT_TRUE(plan.close_driving);
  // Straight through: from where the grown nose is level with the wall to where the grown tail has left it. At a slant
  // it is less.
  EXPECT_LT(plan.close_driving->length, 1.0 + length + 2.0 * distance);
  EXPECT_GT(plan.close_driving->length, length);
  const Planner measuring(world, robot(), preferring(distance, 0.0));
  EXPECT_GT(measuring.plan(request).close_driving->length, 1.2 * plan.close_driving->length);
  EXPECT_EQ(plan.close_driving->cost, ClearancePreference::kHighCost * plan.close_driving->length);
  EXPECT_EQ(plan.cost(), plan.travel_time + plan.close_driving->cost);
}

TEST(ClearancePreference, CostsDecideBetweenANarrowWayAndAWideOne) {
  const PlanRequest request{.start = {0, 10, 0}, .goal = {40, 10, 0}};
  const World world = walled({{-16.0, -8.0}, {9.0, 11.0}});
  const PlanResult cheap = planned(world, preferring(0.8, 0.01), request);
  const PlanResult dear = planned(world, preferring(0.8), request);
  ASSERT_TRUE(cheap.solved() && dear.solved());
  EXPECT_GT(cheap.close_driving->length, 1.0);
  EXPECT_LT(cheap.travel_time, 45.0);
  EXPECT_EQ(dear.close_driving->length, 0.0);
  EXPECT_GT(dear.travel_time, cheap.travel_time + 5.0);
}

TEST(ClearancePreference, HoldsInBothGears) {
  const World world({box(4, 1.2, 30, 2.2), box(4, -2.2, 12, -1.2)}, kHall.outer);
  const PlanRequest request{.start = {0, 0, kPi}, .goal = {40, 0, kPi}, .reverse = true};
  const PlanResult close = planned(world, {}, request), plan = planned(world, preferring(1.0), request);
  ASSERT_TRUE(close.solved() && plan.solved());
  const Planner measuring(world, robot(), preferring(1.0, 0.0));
  EXPECT_GT(measuring.close_driving(close.path())->length, 5.0);
  EXPECT_EQ(plan.close_driving->length, 0.0);
  EXPECT_EQ(plan.segments.front().segment.gear, Gear::kReverse);
}

TEST(ClearancePreference, OfNoCostIsMeasuredAndChangesNoBit) {
  const World world = random_world({.obstacles = 25, .vertices = 6, .fill = 0.2, .seed = 4});
  test::RandomInputs random(2);
  const double side = world.box().max.x();
  int solved = 0, close = 0;
  for (const GraphMode mode : {GraphMode::kEager, GraphMode::kLazy}) {
    PlannerOptions options = preferring(0.5, 0.0);
    options.graph_mode = mode;
    const Planner measuring(world, robot(), options), plain(world, robot(), {.graph_mode = mode});
    for (int i = 0; i < 15; ++i) {
      const Pose start{random.uniform(0, side), random.uniform(0, side), random.uniform(-3, 3)};
      const Pose goal{random.uniform(0, side), random.uniform(0, side), random.uniform(-3, 3)};
      const PlanResult plan = measuring.plan(start, goal);
      test::expect_same_plan(plan, plain.plan(start, goal));
      if (!plan.solved()) continue;
      ++solved;
      EXPECT_EQ(plan.cost(), plan.travel_time);
      close += plan.close_driving->length > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(solved, 4);
  EXPECT_GT(close, 2);
}

// A plan that keeps the cost down costs at most what the fastest one does.
TEST(ClearancePreference, NeverCostsMoreThanTheFastestPlanInClutter) {
  int solved = 0, closer = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const World world = random_world({.obstacles = 15, .vertices = 6, .fill = 0.15, .seed = seed});
    test::RandomInputs random(seed);
    const double side = world.box().max.x();
    const Planner planner(world, robot(), preferring(0.5, 5.0)), fastest(world, robot());
    for (int i = 0; i < 5; ++i) {
      const PlanRequest request = test::request_within(side, random);
      const PlanResult plan = planner.plan(request), other = fastest.plan(request);
      EXPECT_EQ(plan.solved(), other.solved());
      if (!plan.solved() || !other.solved()) continue;
      ++solved;
      test::expect_valid(planner, plan);
      const double other_cost = other.travel_time + planner.close_driving(other.path())->cost;
      EXPECT_LE(plan.cost(), other_cost * (1.0 + 1e-3)) << "seed " << seed << ", query " << i;
      closer += plan.cost() < 0.9 * other_cost ? 1 : 0;
    }
  }
  EXPECT_GT(solved, 8);
  EXPECT_GT(closer, 4);
}

TEST(ClearancePreference, IsOneOfChangedPlannersAndOfTours) {
  const World world({box(10, -8, 12, 3), box(25, -2, 28, 9)}, kHall.outer);
  for (const GraphMode mode : {GraphMode::kEager, GraphMode::kLazy}) {
    PlannerOptions options = preferring(0.7);
    options.graph_mode = mode;
    const Planner before(World({box(10, -8, 12, 3), box(18, -15, 20, 15)}, kHall.outer), robot(), options);
    (void)before.plan({0, 0, 0}, {40, 0, 0});
    const std::vector<ObstacleKey> gone{before.world().key_of(1)};
    const Planner changed = before.with_obstacles(gone, {box(25, -2, 28, 9)});
    const Planner anew(world, robot(), options);
    test::expect_same_plan(changed.plan({0, 0, 0}, {40, 0, 0}), anew.plan({0, 0, 0}, {40, 0, 0}));
    if (mode == GraphMode::kEager) {
      const Planner restored =
          Planner::restored(world, robot(), reference_backend(world), anew.prepared_graph(), preferring(0.7));
      test::expect_same_plan(restored.plan({0, 0, 0}, {40, 0, 0}), anew.plan({0, 0, 0}, {40, 0, 0}));
    }
    const Tour tour = plan_tour(anew, {.start = {0, 0, 0},
                                       .waypoints = {{.position = {18, 0}, .heading = 0.0}},
                                       .goals = {{.position = {40, 0}, .heading = 0.0}}});
    ASSERT_TRUE(tour.plan.solved() && tour.plan.close_driving);
    EXPECT_EQ(tour.plan.close_driving->length, 0.0);
    EXPECT_GE(tour.plan.min_clearance, 0.7);
  }
}

// Where a body that is grown by the distance finds a path, a plan of the robot keeps the distance all the way.
TEST(ClearancePreference, IsKeptOnARosMapWhereverThereIsRoom) {
  const char* folder = std::getenv("ARCWAY_SHARED_DATA");
  if (folder == nullptr) GTEST_SKIP() << "ARCWAY_SHARED_DATA names no folder of maps";
  const World world = to_world(read_map(std::filesystem::path(folder) / "ros/tb3_sandbox.yaml"), "tb3_sandbox");
  VehicleParameters parameters{.length = 0.3, .width = 0.2, .wheelbase = 0.2, .max_steering_angle = 0.75};
  parameters.max_speed = 0.5;
  parameters.turn_speed = ConstantTurnSpeed{0.3};
  parameters.max_acceleration = 1.0;
  const Vehicle narrow(parameters);
  constexpr double kDistance = 0.1;
  parameters.safety_margin = 2.0 * (kDistance + narrow.safety_margin());  // half of it is checked
  const Vehicle wide(parameters);
  const Planner planner(world, narrow, preferring(kDistance)), plain(world, narrow), of_wide(world, wide);
  int with_room = 0, closer = 0, without_room = 0;
  for (const PlanRequest& request : random_queries(world, planner.queries(), narrow,
                                                   {.count = 12, .min_distance = 0.1, .seed = 3, .passable = true})) {
    const PlanResult plan = planner.plan(request), fastest = plain.plan(request);
    EXPECT_EQ(plan.solved(), fastest.solved());
    if (!plan.solved()) continue;
    test::expect_valid(planner, plan);
    if (!of_wide.plan(request).solved()) {
      without_room += plan.close_driving->length > 0.0 ? 1 : 0;
      continue;
    }
    ++with_room;
    EXPECT_EQ(plan.close_driving->length, 0.0) << to_string(request);
    EXPECT_GE(plan.min_clearance, kDistance) << to_string(request);
    closer += planner.close_driving(fastest.path())->length > 0.0 ? 1 : 0;
  }
  EXPECT_GT(with_room, 3);
  EXPECT_GT(closer, 3);
  EXPECT_GT(without_room, 3);
}

TEST(ClearancePreference, WithSenselessNumbersIsRefused) {
  const World world({box(10, -8, 12, 3)}, kHall.outer);
  const auto message_of = [&](double distance, double cost) -> std::string {
    try {
      const Planner planner(world, robot(), preferring(distance, cost));
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message_of(0.0, 1.0), "clearance preference: distance 0 m, must be above 0 and at most 1e+06");
  EXPECT_EQ(message_of(NAN, 1.0), "clearance preference: distance nan m, must be above 0 and at most 1e+06");
  EXPECT_EQ(message_of(1.0, -1.0), "clearance preference: cost -1 s/m, must be from 0 to 1e+06");
  EXPECT_EQ(message_of(1.0, INFINITY), "clearance preference: cost inf s/m, must be from 0 to 1e+06");
}

}  // namespace
}  // namespace arcway::internal

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/planner.h"
#include "arcway/replan.h"
#include "arcway/tour.h"
#include "arcway/zone_stay.h"
#include "tests/support/boxes.h"
#include "tests/support/free_plans.h"
#include "tests/support/plans.h"
#include "tests/support/random_inputs.h"
#include "tests/support/sampled_cost.h"

namespace arcway::internal::clearance_zone_test {
namespace {

using test::box;

// 1.5 m x 0.8 m, as fast on lines as in turns.
Vehicle robot() {
  return Vehicle({.max_speed = 1.0, .turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 1.0});
}

const Polygon kHall = box(-5, -20, 45, 20);
const PlanRequest kAcross{.start = {0, 0, 0}, .goal = {40, 0, 0}};

// Two obstacles beside the straight line across the hall, of which paths pass corners.
World two_obstacles() { return World({box(10, -8, 12, 3), box(25, -2, 28, 9)}, kHall.outer); }

// The cost of close driving in zones is that of samples of each millimeter.
void expect_sampled_cost(const Planner& planner, const PlanResult& plan) {
  const test::SampledCost expected = test::sampled_cost(plan.path(), planner.world(), planner.vehicle(), 1e-3);
  EXPECT_NEAR(plan.cost() - plan.travel_time, expected.cost, expected.doubt);
}

PlanResult planned(const World& world, const PlanRequest& request, const PlannerOptions& options = {}) {
  const Planner planner(world, robot(), options);
  PlanResult plan = planner.plan(request);
  if (plan.solved()) test::expect_valid(planner, plan, request.reverse);
  return plan;
}

double clearance_on(const World& world, const PlanResult& plan, double from_x, double to_x) {
  double least = INFINITY;
  const Vehicle vehicle = robot();
  const std::vector<Ring> parts = test::parts_of(vehicle.body());
  const Trajectory motion = plan.trajectory();
  for (double s = 0.0; s < motion.length(); s += 0.01) {
    const Pose pose = motion.at_distance(s).pose;
    if (pose.x < from_x || pose.x > to_x) continue;
    least = std::min(least, static_cast<double>(test::PlacedBody(parts, pose).distance_to(world)));
  }
  return least;
}

TEST(ClearanceZone, AsksForRoomInsideAlone) {
  for (const double distance : {0.3, 0.7, 1.5}) {
    const World world = two_obstacles().with_zones({{box(5, -20, 18, 20), KeepClear{distance, 100.0}, "yard"}});
    const PlanResult plan = planned(world, kAcross);
    ASSERT_TRUE(plan.solved());
    EXPECT_FALSE(plan.close_driving);
    EXPECT_TRUE(plan.close_in_zones.empty());
    EXPECT_EQ(plan.cost(), plan.travel_time);
    EXPECT_GE(clearance_on(world, plan, 5, 18), distance - 1e-3);
    EXPECT_LT(clearance_on(world, plan, 20, 40), 0.1);
  }
}

TEST(ClearanceZone, SaysWhatIsDrivenCloseWhereItMustBe) {
  // A wall with one gap, 0.6 m wider than the body on either side.
  const World walled({box(19.5, -20, 20.5, -1), box(19.5, 1, 20.5, 20)}, kHall.outer);
  const World world = walled.with_zones({{box(0, 0, 1, 1), SpeedLimit{0.9}},
                                         {box(10, -10, 20, 10), KeepClear{1.0, 3.0}, "left"},
                                         {box(15, -10, 30, 10), KeepClear{0.8, 2.0}, "right"}});
  const PlanResult plan = planned(world, {.start = {0, 10, 0}, .goal = {40, 10, 0}});
  ASSERT_TRUE(plan.solved());
  expect_sampled_cost(Planner(world, robot()), plan);
  ASSERT_EQ(plan.close_in_zones.size(), 2u);
  double cost = plan.travel_time;
  for (const ZoneCloseDriving& in_zone : plan.close_in_zones) {
    EXPECT_GT(in_zone.close.length, 0.5);
    EXPECT_EQ(in_zone.close.cost, (in_zone.zone == 1 ? 3.0 : 2.0) * in_zone.close.length);
    EXPECT_EQ(in_zone.close.distance, in_zone.zone == 1 ? 1.0 : 0.8);
    cost += in_zone.close.cost;
  }
  EXPECT_EQ(plan.close_in_zones[0].zone, 1u);
  EXPECT_EQ(plan.close_in_zones[1].zone, 2u);
  EXPECT_EQ(plan.cost(), cost);
  const std::vector<ZoneStay> stays = zone_stays(plan);
  ASSERT_EQ(stays.size(), 2u);
  EXPECT_GE(stays[0].length, plan.close_in_zones[0].close.length);
}

TEST(ClearanceZone, DecidesBetweenANarrowWayAndAWideOne) {
  const World walled({box(19.5, -20, 20.5, -16), box(19.5, -8, 20.5, 9), box(19.5, 11, 20.5, 20)}, kHall.outer);
  const PlanRequest request{.start = {0, 10, 0}, .goal = {40, 10, 0}};
  const auto with_cost = [&](double cost, const Polygon& area) {
    return planned(walled.with_zones({{area, KeepClear{0.8, cost}}}), request);
  };
  const PlanResult cheap = with_cost(0.01, kHall), dear = with_cost(100.0, kHall),
                   elsewhere = with_cost(100.0, box(21, -20, 45, -5));
  ASSERT_TRUE(cheap.solved() && dear.solved() && elsewhere.solved());
  EXPECT_EQ(cheap.close_in_zones.size(), 1u);
  EXPECT_LT(cheap.travel_time, 45.0);
  EXPECT_TRUE(dear.close_in_zones.empty());
  EXPECT_GT(dear.travel_time, cheap.travel_time + 5.0);
  EXPECT_TRUE(elsewhere.close_in_zones.empty());
  EXPECT_LT(elsewhere.travel_time, 45.0);
}

TEST(ClearanceZone, CountsBesideThePreferenceOfAPlanner) {
  const World world = two_obstacles().with_zones({{box(5, -20, 18, 20), KeepClear{1.5, 100.0}}});
  const PlanResult plan =
      planned(world, kAcross, {.clearance_preference = ClearancePreference{.distance = 0.5, .cost = 100.0}});
  ASSERT_TRUE(plan.solved() && plan.close_driving);
  EXPECT_EQ(plan.close_driving->length, 0.0);
  EXPECT_TRUE(plan.close_in_zones.empty());
  EXPECT_GE(clearance_on(world, plan, 5, 18), 1.5 - 1e-3);
  const double elsewhere = clearance_on(world, plan, 20, 40);
  EXPECT_GE(elsewhere, 0.5 - 1e-3);
  EXPECT_LT(elsewhere, 0.7);
}

TEST(ClearanceZone, HoldsInBothGears) {
  const World free({box(4, 1.2, 30, 2.2), box(4, -2.2, 12, -1.2)}, kHall.outer);
  const PlanRequest request{.start = {0, 0, kPi}, .goal = {40, 0, kPi}, .reverse = true};
  const World world = free.with_zones({{box(2, -20, 35, 20), KeepClear{1.0, 100.0}}});
  const PlanResult close = planned(free, request), plan = planned(world, request);
  ASSERT_TRUE(close.solved() && plan.solved());
  const Planner planner(world, robot());
  ASSERT_EQ(planner.close_in_zones(close.path()).size(), 1u);
  EXPECT_GT(planner.close_in_zones(close.path())[0].close.length, 5.0);
  EXPECT_TRUE(plan.close_in_zones.empty());
  EXPECT_EQ(plan.segments.front().segment.gear, Gear::kReverse);
}

TEST(ClearanceZone, OfNoCostIsMeasuredAndChangesNoBit) {
  const World free = random_world({.obstacles = 25, .vertices = 6, .fill = 0.2, .seed = 4});
  const double side = free.box().max.x();
  const World world = free.with_zones({{box(0, 0, side, side), KeepClear{0.5, 0.0}}});
  test::RandomInputs random(2);
  const Planner measuring(world, robot()), plain(free, robot());
  int close = 0;
  for (int i = 0; i < 12; ++i) {
    const Pose start{random.uniform(0, side), random.uniform(0, side), random.uniform(-3, 3)};
    const Pose goal{random.uniform(0, side), random.uniform(0, side), random.uniform(-3, 3)};
    const PlanResult plan = measuring.plan(start, goal);
    test::expect_same_plan(plan, plain.plan(start, goal));
    EXPECT_EQ(plan.cost(), plan.travel_time);
    close += plan.close_in_zones.empty() ? 0 : 1;
  }
  EXPECT_GT(close, 1);
}

// A plan that keeps the cost down costs at most what the fastest one does.
TEST(ClearanceZone, NeverCostsMoreThanTheFastestPlanInClutter) {
  int solved = 0, cheaper = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const World free = random_world({.obstacles = 15, .vertices = 6, .fill = 0.15, .seed = seed});
    const double side = free.box().max.x();
    const World world = free.with_zones({{box(0, 0, 0.6 * side, 0.7 * side), KeepClear{0.5, 5.0}},
                                         {box(0.4 * side, 0.2 * side, side, side), KeepClear{0.3, 8.0}}});
    test::RandomInputs random(seed);
    const Planner planner(world, robot()), fastest(free, robot());
    for (int i = 0; i < 4; ++i) {
      const PlanRequest request = test::request_within(side, random);
      const PlanResult plan = planner.plan(request), other = fastest.plan(request);
      EXPECT_EQ(plan.solved(), other.solved());
      if (!plan.solved() || !other.solved()) continue;
      ++solved;
      test::expect_valid(planner, plan);
      if (i == 0) expect_sampled_cost(planner, plan);
      double other_cost = other.travel_time;
      for (const ZoneCloseDriving& in_zone : planner.close_in_zones(other.path())) other_cost += in_zone.close.cost;
      EXPECT_LE(plan.cost(), other_cost * (1.0 + 1e-3)) << "seed " << seed << ", query " << i;
      cheaper += plan.cost() < 0.9 * other_cost ? 1 : 0;
    }
  }
  EXPECT_GT(solved, 5);
  EXPECT_GT(cheaper, 2);
}

TEST(ClearanceZone, IsOneOfChangedAndRestoredPlanners) {
  const std::vector<Zone> zones{{box(5, -20, 18, 20), KeepClear{0.7, 100.0}}};
  const World world = two_obstacles().with_zones(zones);
  for (const GraphMode mode : {GraphMode::kEager, GraphMode::kLazy}) {
    const PlannerOptions options{.graph_mode = mode};
    const Planner before(World({box(10, -8, 12, 3), box(18, -15, 20, 15)}, kHall.outer).with_zones(zones), robot(),
                         options);
    static_cast<void>(before.plan(kAcross));
    const std::vector<ObstacleKey> gone{before.world().key_of(1)};
    const Planner changed = before.with_obstacles(gone, {box(25, -2, 28, 9)}), anew(world, robot(), options);
    test::expect_same_plan(changed.plan(kAcross), anew.plan(kAcross));
    if (mode == GraphMode::kLazy) continue;
    const Planner restored = Planner::restored(world, robot(), reference_backend(world), anew.prepared_graph());
    test::expect_same_plan(restored.plan(kAcross), anew.plan(kAcross));
  }
}

TEST(ClearanceZone, CountsInToursAndReplans) {
  const World world = two_obstacles().with_zones({{box(5, -20, 18, 20), KeepClear{0.7, 100.0}}});
  const Planner planner(world, robot());
  const Tour tour = plan_tour(planner, {.start = kAcross.start,
                                        .waypoints = {{.position = {18, 0}, .heading = 0.0}},
                                        .goals = {{.position = {40, 0}, .heading = 0.0}}});
  ASSERT_TRUE(tour.plan.solved());
  EXPECT_TRUE(tour.plan.close_in_zones.empty());
  EXPECT_GE(clearance_on(world, tour.plan, 5, 18), 0.7 - 1e-3);
  // A motion that was planned without zones is given up for one that keeps the distance.
  const PlanResult close = Planner(two_obstacles(), robot()).plan(kAcross);
  const Replan next = replan(planner, close.trajectory(), 0.5);
  EXPECT_EQ(next.motion, NextMotion::kPlanned);
  EXPECT_TRUE(planner.close_in_zones(path_of(next.segments)).empty());
  EXPECT_FALSE(planner.close_in_zones(close.path()).empty());
}

}  // namespace
}  // namespace arcway::internal::clearance_zone_test

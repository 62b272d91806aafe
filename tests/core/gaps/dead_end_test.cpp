#include "core/gaps/dead_end.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/planner.h"
#include "core/collision/motion_free.h"
#include "datasets/io/random.h"
#include "tests/support/boxes.h"
#include "tests/support/counting_sweep.h"
#include "tests/support/stopping_queries.h"

namespace arcway::internal {
namespace {

using test::box;
using test::CountingSweep;

constexpr DeadEndEffort kEffort{.halvings = 1, .max_checks = 10'000};
const Pose kFarGoal{-30, 5, 0};

std::optional<DeadEnd> dead_end(const World& world, const Vehicle& vehicle, const Pose& start, const Pose& goal) {
  return find_dead_end(
      start, goal,
      {vehicle.footprint(), vehicle.min_turning_radius(), *make_reference_queries(world).sweep, Outlines(world)},
      kEffort);
}

// Whoever faces a wall gets away by the tightest turn if at all, in which the outer front corner gets furthest.
TEST(DeadEnd, AWallAhead) {
  const Vehicle vehicle;
  const double needed = swept_annulus(vehicle.footprint(), Side::kLeft, vehicle.min_turning_radius()).outer;  // 2.2 m
  for (const double ahead : {1.45, 1.6, 1.8, 0.9 * needed}) {
    const auto proof = dead_end(World({box(ahead, -40, ahead + 1, 40)}), vehicle, {0, 0, 0}, kFarGoal);
    ASSERT_TRUE(proof) << ahead;
    EXPECT_TRUE(proof->at_start);
    EXPECT_LT(proof->reach, 2.0);
  }
  for (const double ahead : {1.001 * needed, 1.2 * needed})
    EXPECT_FALSE(dead_end(World({box(ahead, -40, ahead + 1, 40)}), vehicle, {0, 0, 0}, kFarGoal)) << ahead;
}

// Boxes that are halved once more prove what larger ones leave open. A planner asks so before it grows trees, and where
// the boxes of its first question prove nothing.
TEST(DeadEnd, SmallerBoxesProveMore) {
  const Vehicle vehicle;
  const double ahead = 0.93 * swept_annulus(vehicle.footprint(), Side::kLeft, vehicle.min_turning_radius()).outer;
  const World world({box(ahead, -40, ahead + 1, 40)});
  const auto sweep = make_reference_queries(world).sweep;
  const auto proved = [&](const DeadEndEffort& effort) {
    return find_dead_end({0, 0, 0}, kFarGoal,
                         {vehicle.footprint(), vehicle.min_turning_radius(), *sweep, Outlines(world)}, effort)
        .has_value();
  };
  EXPECT_FALSE(proved({.halvings = 1, .max_checks = 100'000}));
  EXPECT_TRUE(proved({.halvings = 2, .max_checks = 100'000}));
  const PlanResult plan = Planner(world, vehicle).plan({.start = {0, 0, 0}, .goal = kFarGoal});
  EXPECT_EQ(plan.certainty, Certainty::kProved) << plan.reason;
  EXPECT_EQ(plan.statistics.tree_poses, 0u);
}

// The clock is asked before each expansion of a free box. The wall has so many edges that each box is a question.
TEST(DeadEnd, IsLookedForUntilTheClockIsOver) {
  const Vehicle vehicle;
  std::vector<Polygon> wall;
  for (int i = 0; i < 200; ++i) wall.push_back(box(2.0, 0.1 * i - 10.0, 2.05, 0.1 * i - 9.95));
  const World world(wall);
  const Outlines outlines(world);
  for (const std::size_t question : {10u, 100u, 300u}) {
    test::StoppingQueries stopping(world);
    const StopClock clock(std::numeric_limits<double>::infinity(), stopping.stop_at(question));
    const auto sweep = stopping.queries().sweep;
    EXPECT_FALSE(find_dead_end({0, 0, 0}, kFarGoal,
                               {vehicle.footprint(), vehicle.min_turning_radius(), *sweep, outlines},
                               {.halvings = 2, .max_checks = 100'000}, clock));
    EXPECT_GE(stopping.asked(), question);
    EXPECT_LT(stopping.asked_after_stop(), 10u);
  }
}

// A step of the proof would leave all that is near: no proof, at once.
TEST(DeadEnd, IsNotLookedForByVehiclesThatTurnVeryWide) {
  const World blocked_lane({box(-5, 1, 5, 2), box(-5, -2, 5, -1), box(2, -2, 3, 2)});
  for (const double radius : {30.0, 650.0, 2e4, 1e6}) {
    VehicleParameters parameters;
    parameters.max_steering_angle = std::atan(parameters.wheelbase / radius);
    EXPECT_FALSE(dead_end(blocked_lane, Vehicle(parameters), {0, 0, 0.25 * kPi}, kFarGoal)) << radius;
  }
}

// Nor by those that turn on the spot: a step of the proof is as long as a box at least, and would be many turns.
TEST(DeadEnd, IsNotLookedForByVehiclesThatTurnOnTheSpot) {
  const World blocked_lane({box(-5, 1, 5, 2), box(-5, -2, 5, -1), box(2, -2, 3, 2)});
  for (const double radius : {1e-3, 1e-6, 1e-9}) {
    VehicleParameters parameters;
    parameters.max_steering_angle = std::atan(parameters.wheelbase / radius);
    EXPECT_FALSE(dead_end(blocked_lane, Vehicle(parameters), {0, 0, 0.25 * kPi}, kFarGoal)) << radius;
  }
}

// The other way round for the goal: its tail sweeps less.
TEST(DeadEnd, AWallBehindTheGoal) {
  const Vehicle vehicle;
  const Footprint body = vehicle.footprint();
  const double needed = std::hypot(body.rear, vehicle.min_turning_radius() + body.right);  // 1.7 m
  for (const double behind : {0.2, 0.8, 1.2}) {
    const auto proof = dead_end(World({box(-behind - 1, -40, -behind, 40)}), vehicle, {30, 5, 0}, {0, 0, 0});
    ASSERT_TRUE(proof) << behind;
    EXPECT_FALSE(proof->at_start);
  }
  EXPECT_FALSE(dead_end(World({box(-1.01 * needed - 1, -40, -1.01 * needed, 40)}), vehicle, {30, 5, 0}, {0, 0, 0}));
}

// A third of a turn between walls that leave the body as much room as it sweeps, and then the open.
TEST(DeadEnd, IsNoneInABendAsNarrowAsTheSweptArea) {
  const Vehicle vehicle;
  Random random(1);
  for (int i = 0; i < 60; ++i) {
    const Pose start{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-kPi, kPi)};
    const double radius = vehicle.min_turning_radius() * (i % 3 == 0 ? 1.0 : random.uniform(1.0, 3.0));
    const SweptAnnulus swept = swept_annulus(vehicle.footprint(), Side::kLeft, radius);
    const Vec2 center = start.position() + radius * perpendicular(direction_of(start.heading));
    const double first = start.heading - 0.5 * kPi - 0.2;  // seen from the center
    const auto at = [&](double distance, double turned) -> Vec2 {
      return center + distance * direction_of(first + turned);
    };
    constexpr int kParts = 200;
    constexpr double kRoom = 1e-6, kPart = kTwoPi / 3.0 / kParts;
    Ring inner, outer;
    for (int k = 0; k <= kParts; ++k) {
      inner.push_back(at(swept.inner - kRoom, k * kPart));
      outer.push_back(at((swept.outer + kRoom) / std::cos(0.5 * kPart), (kParts - k) * kPart));
    }
    inner.push_back(center);
    for (int k = 0; k <= kParts; ++k) outer.push_back(at(swept.outer + 1.0, k * kPart));
    const World world({{inner, {}}, {outer, {}}});
    const PathSegment way{start, (kParts * kPart) * radius, 1.0 / radius};
    ASSERT_TRUE(motion_free(*make_reference_queries(world).sweep, vehicle.footprint(), {&way, 1})) << i;
    EXPECT_FALSE(dead_end(world, vehicle, start, {60, 60, 0})) << i;
    const Pose back{way.end().x, way.end().y, way.end().heading};
    EXPECT_FALSE(dead_end(world, vehicle, {60, 60, 0}, back)) << i;
  }
}

TEST(DeadEnd, IsNoneTowardsAGoalThatIsNear) {
  EXPECT_FALSE(dead_end(World({box(2, -40, 3, 40)}), Vehicle{}, {0, 0, 0}, {0.4, 0, 0}));
}

// Questions are for what is on the way out, not for all beside it.
TEST(DeadEnd, AsksLittleWhereThereIsAWayOut) {
  const Vehicle vehicle;
  const World world({box(6, -40, 7, 40)});
  const CountingSweep sweep(world);
  EXPECT_FALSE(find_dead_end({0, 0, 0}, kFarGoal,
                             {vehicle.footprint(), vehicle.min_turning_radius(), sweep, Outlines(world)}, kEffort));
  EXPECT_LT(sweep.asked(), 300u);
}

TEST(DeadEnd, IsTheReasonThatAPlanGives) {
  const World world({box(1.8, -40, 3, 40)});
  const Planner planner(world, Vehicle{});
  const PlanResult plan = planner.plan({.start = {0, 0, 0}, .goal = kFarGoal});
  EXPECT_EQ(plan.status, PlanStatus::kStartBlocked);
  EXPECT_NE(plan.reason.find("is a dead end: every forward motion from it"), std::string::npos) << plan.reason;
  EXPECT_EQ(plan.statistics.maneuver_poses, 0u);
  EXPECT_TRUE(planner.plan({.start = {0, 0, 0}, .goal = kFarGoal, .reverse = true}).solved());
  const PlanResult back = planner.plan({.start = {-30, 0, kPi}, .goal = {1.0, 0, kPi}});
  EXPECT_EQ(back.status, PlanStatus::kGoalBlocked) << back.reason;
  EXPECT_NE(back.reason.find("is a dead end: every forward motion to it"), std::string::npos) << back.reason;
}

// Drives on at random, by free arcs and lines, until it gets no further; how far away it comes.
double random_drive(const SweepQuery& sweep, const Vehicle& vehicle, const Pose& start, Random& random) {
  const Footprint body = vehicle.footprint();
  const double least = vehicle.min_turning_radius();
  Pose at = start;
  double furthest = 0.0;
  for (int failures = 0; failures < 6;) {
    const double curvature = random.below(2) == 0 ? random.uniform(-1.0, 1.0) / least
                             : random.below(2)    ? 1.0 / least
                                                  : -1.0 / least;
    const PathSegment motion{at, random.uniform(0.02, 0.4) * least, curvature};
    if (!motion_free(sweep, body, {&motion, 1})) {
      ++failures;
      continue;
    }
    at = motion.end();
    furthest = std::max(furthest, (at.position() - start.position()).norm());
    if (furthest > 20.0) break;
  }
  return furthest;
}

TEST(DeadEnd, NoDriveGetsFurtherThanItSays) {
  const Vehicle vehicle;
  int proved = 0, open = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const World world = random_world({.obstacles = 40, .vertices = 6, .fill = 0.6, .seed = seed});
    const QuerySet queries = make_reference_queries(world);
    const Outlines outlines(world);
    Random random(seed);
    for (const PlanRequest& request : random_queries(world, queries, vehicle, {.count = 25, .min_distance = 0.3})) {
      const auto proof =
          find_dead_end(request.start, request.goal,
                        {vehicle.footprint(), vehicle.min_turning_radius(), *queries.sweep, outlines}, kEffort);
      if (!proof || !proof->at_start) {
        ++open;
        continue;
      }
      ++proved;
      for (int drive = 0; drive < 50; ++drive)
        EXPECT_LE(random_drive(*queries.sweep, vehicle, request.start, random), proof->reach) << seed;
    }
  }
  EXPECT_GT(proved, 3);
  EXPECT_GT(open, 3);
}

TEST(DeadEnd, IsNotProvedWhereThereIsAPath) {
  int solved = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const World world = random_world({.obstacles = 30, .vertices = 6, .fill = 0.45, .seed = seed});
    const Vehicle vehicle;
    const QuerySet queries = make_reference_queries(world);
    const Outlines outlines(world);
    const Planner planner(world, vehicle);
    for (const PlanRequest& request : random_queries(world, queries, vehicle, {.count = 8, .min_distance = 0.2})) {
      if (!planner.plan(request).solved()) continue;
      ++solved;
      EXPECT_FALSE(find_dead_end(request.start, request.goal,
                                 {vehicle.footprint(), vehicle.min_turning_radius(), *queries.sweep, outlines},
                                 kEffort))
          << seed;
    }
  }
  EXPECT_GT(solved, 15);
}

}  // namespace
}  // namespace arcway::internal

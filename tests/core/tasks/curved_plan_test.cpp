#include "arcway/curved_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/curved_world.h"
#include "core/motion/clearance.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

PlanRequest across(const CurvedWorld& world) {
  const Vec2& corner = (*world.bounds)[2];
  return {.start = {7.0, 7.0, 0.0}, .goal = {corner.x() - 7.0, corner.y() - 7.0, 0.0}};
}

std::vector<CubicBezier> pieces_of(const ClosedSpline& spline) {
  return {spline.pieces().begin(), spline.pieces().end()};
}

// One pond, whose finest rings have slower plans than coarser ones.
CurvedWorld pond() {
  CurvedWorld world;
  world.polygons = {Polygon{}};
  world.bounds = Ring{{0, 0}, {0, 40}, {60, 40}, {60, 0}};
  world.curves = {{0, 0, pieces_of(ClosedSpline({{20, 10}, {35, 12}, {38, 25}, {25, 30}, {15, 20}}))}};
  return world;
}
const PlanRequest kAroundThePond{.start = {5, 5, 0}, .goal = {55, 35, 0}};

double fastest_of(const std::vector<CurvedPlanIteration>& iterations) {
  double fastest = std::numeric_limits<double>::infinity();
  for (const CurvedPlanIteration& iteration : iterations) fastest = std::min(fastest, iteration.travel_time);
  return fastest;
}

// With one speed on lines and arcs, time is length: it falls towards its limit in proportion to the tolerance.
TEST(CurvedPlan, TravelTimeConvergesAsTheToleranceFalls) {
  const Vehicle robot({.turn_speed = ConstantTurnSpeed{12.0}});
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const CurvedWorld world = generate_curved_world({.curves = 6, .seed = seed});
    const auto time = [&](double tolerance) {
      const CurvedPlan plan = plan_among_curves(world, robot, across(world), {.first = tolerance, .last = tolerance});
      EXPECT_TRUE(plan.result.solved()) << seed << ' ' << plan.result.reason;
      return plan.result.travel_time;
    };
    const double limit = time(0.003);
    for (const double tolerance : {1.0, 0.3, 0.1, 0.03, 0.01})
      EXPECT_NEAR(time(tolerance), limit, 0.05 * tolerance) << seed << ' ' << tolerance;
  }
}

TEST(CurvedPlan, RefinesWhereItMattersAlone) {
  const Vehicle robot;
  const CurvedWorld world = generate_curved_world({.curves = 12, .seed = 4});
  const CurvedPlan adaptive = plan_among_curves(world, robot, across(world), {.first = 0.5, .last = 0.005});
  const CurvedPlan uniform = plan_among_curves(world, robot, across(world), {.first = 0.005, .last = 0.005});
  ASSERT_TRUE(adaptive.result.solved() && uniform.result.solved());
  EXPECT_EQ(uniform.iterations.size(), 1u);
  EXPECT_GE(adaptive.iterations.size(), 4u);
  EXPECT_EQ(adaptive.iterations.back().tolerance, 0.005);
  EXPECT_LT(adaptive.iterations.back().vertices, uniform.iterations.back().vertices * 3 / 4);
  EXPECT_NEAR(adaptive.result.travel_time, uniform.result.travel_time, 0.01 * uniform.result.travel_time);
  test::expect_valid(adaptive.planner, adaptive.result);
}

// The curve itself, not its ring, against the body along the path.
TEST(CurvedPlan, KeepsTheBodyOffTheCurves) {
  const Vehicle robot;
  const Footprint body = robot.footprint();
  const CurvedWorld world = generate_curved_world({.curves = 8, .seed = 2});
  const CurvedPlan plan = plan_among_curves(world, robot, across(world), {.first = 0.1, .last = 0.005});
  ASSERT_TRUE(plan.result.solved());
  for (const TimedSegment& timed_segment : plan.result.segments) {
    for (int i = 0; i <= 40; ++i) {
      const Pose pose = timed_segment.segment.at(timed_segment.segment.length * i / 40.0);
      const Vec2 u = direction_of(pose.heading);
      for (const CurvedRing& curve : world.curves)
        for (const CubicBezier& piece : curve.pieces)
          for (int k = 0; k < 20; ++k) {
            const Vec2 p = piece.at(k / 20.0) - pose.position();
            const double along = p.dot(u), aside = std::abs(cross(u, p));
            EXPECT_FALSE(along < body.front && along > -body.rear && aside < body.left);
          }
    }
  }
}

// A pool in an annulus: the outline, its hole and the bounds are curves.
TEST(CurvedPlan, ReplacesHolesAndBounds) {
  const auto circle = [](double radius, bool clockwise) {
    std::vector<Vec2> points;
    for (int i = 0; i < 16; ++i) points.push_back(radius * direction_of((clockwise ? -1.0 : 1.0) * i * kTwoPi / 16.0));
    return pieces_of(ClosedSpline(points));
  };
  CurvedWorld world;
  world.polygons = {Polygon{{}, {{}}}};
  world.bounds = Ring{};
  world.curves = {{0, 0, circle(10.0, false)}, {0, 1, circle(8.0, true)}, {CurvedRing::kBounds, 0, circle(30.0, true)}};
  const Vehicle robot;
  const CurvedPlan plan = plan_among_curves(world, robot, {{-20, 0, 0}, {20, 0, 0}}, {.first = 0.5, .last = 0.01});
  ASSERT_TRUE(plan.result.solved()) << plan.result.reason;
  const World& rings = plan.planner.world();
  EXPECT_TRUE(rings.has_bounds());
  EXPECT_EQ(rings.locate({0, 0}, 0), PointLocation::kOutside);  // of the obstacle: in its hole
  EXPECT_EQ(rings.locate({9, 0}, 0), PointLocation::kInside);
  test::expect_valid(plan.planner, plan.result);
  EXPECT_FALSE(plan_among_curves(world, robot, {{-4, 0, 0}, {20, 0, 0}}, {.last = 0.1}).result.solved());
  world.curves[1].ring = 2;
  EXPECT_THROW(plan_among_curves(world, robot, {{-20, 0, 0}, {20, 0, 0}}), std::invalid_argument);
}

// From its second iteration on, planners do not refine paths, which makes those iterations slower.
TEST(CurvedPlan, KeepsTheFastestPlanOfAllIterations) {
  int iteration = 0;
  const auto make_planner = [&](const World& rings) {
    PlannerOptions options;
    if (++iteration > 1) options.refinement.max_trials = 0;
    return Planner(rings, Vehicle(), options);
  };
  const CurvedPlan plan = plan_among_curves(pond(), kAroundThePond, {.last = 0.01}, make_planner);
  ASSERT_TRUE(plan.result.solved()) << plan.result.reason;
  EXPECT_FALSE(plan.result.interrupted);
  EXPECT_EQ(plan.iterations.size(), 4u);
  EXPECT_EQ(plan.result.travel_time, plan.iterations.front().travel_time);
  EXPECT_LT(plan.result.travel_time, plan.iterations.back().travel_time);
  EXPECT_EQ(plan.planner.world().vertices().size(), plan.iterations.back().vertices);
  test::expect_valid(plan.planner, plan.result);
  // What it says of the path is so among the last rings.
  double clearance = std::numeric_limits<double>::infinity();
  for (const PathSegment& segment : plan.result.path())
    clearance = std::min(clearance, clearance_along(segment, Vehicle().footprint(), plan.planner.world()).distance);
  EXPECT_EQ(plan.result.min_clearance, clearance);
  EXPECT_LE(plan.result.lower_bound, plan.planner.plan(kAroundThePond).lower_bound);
}

TEST(CurvedPlan, IsNeverSlowerWithAFinerTolerance) {
  const Vehicle robot;
  const auto time = [&](const CurvedWorld& world, const PlanRequest& request, double last) {
    const CurvedPlan plan = plan_among_curves(world, robot, request, {.last = last});
    EXPECT_TRUE(plan.result.solved()) << plan.result.reason;
    EXPECT_EQ(plan.result.travel_time, fastest_of(plan.iterations)) << last;
    test::expect_valid(plan.planner, plan.result);
    return plan.result.travel_time;
  };
  const CurvedWorld ponds = generate_curved_world({.curves = 4, .seed = 2});
  for (const auto& [world, request] : {std::pair(pond(), kAroundThePond), std::pair(ponds, across(ponds))}) {
    double slowest = std::numeric_limits<double>::infinity();
    for (const double tolerance : {0.5, 0.125, 0.03125, 0.0078125}) {
      const double now = time(world, request, tolerance);
      EXPECT_LE(now, slowest) << tolerance;
      slowest = now;
    }
    for (const double tolerance : {0.005, 0.002}) EXPECT_LE(time(world, request, tolerance), slowest) << tolerance;
  }
}

TEST(CurvedPlan, EndsWhereFinerRingsCannotMatter) {
  const Vehicle robot({.safety_margin = 0.01});
  const double finest = robot.safety_margin() / 16.0;
  const CurvedPlan plan = plan_among_curves(pond(), robot, kAroundThePond, {.last = 1e-12});
  ASSERT_TRUE(plan.result.solved()) << plan.result.reason;
  EXPECT_EQ(plan.iterations.back().tolerance, finest);
  EXPECT_LE(plan.iterations.size(), 7u);
  EXPECT_LT(plan.iterations.back().vertices, 1000u);
  test::expect_valid(plan.planner, plan.result);
  // Nor without a path: here the start is inside the pond.
  const CurvedPlan blocked = plan_among_curves(pond(), robot, {{25, 20, 0}, {55, 35, 0}}, {.last = 1e-12});
  EXPECT_EQ(blocked.result.status, PlanStatus::kStartInCollision);
  EXPECT_EQ(blocked.iterations.back().tolerance, finest);
}

// Lines are what they are at any tolerance.
TEST(CurvedPlan, DoesNotPlanOnTheSameRingsAgain) {
  CurvedWorld world = pond();
  std::vector<CubicBezier>& pieces = world.curves[0].pieces;
  for (CubicBezier& piece : pieces) piece = {{piece.p[0], piece.p[0], piece.p[3], piece.p[3]}};
  const CurvedPlan plan = plan_among_curves(world, Vehicle(), kAroundThePond, {.last = 0.002});
  ASSERT_TRUE(plan.result.solved()) << plan.result.reason;
  ASSERT_EQ(plan.iterations.size(), 1u);
  EXPECT_EQ(plan.iterations[0].vertices, 4 + pieces.size());
  EXPECT_EQ(plan.iterations[0].tolerance, 0.002);
}

TEST(CurvedPlan, GivesTheBestPlanFoundByThenWhenItIsCanceled) {
  std::stop_source stop;
  int iteration = 0;
  const auto make_planner = [&](const World& rings) {
    if (++iteration == 3) stop.request_stop();
    return Planner(rings, Vehicle());
  };
  const CurvedPlan plan =
      plan_among_curves(pond(), kAroundThePond, {.last = 1e-4}, make_planner, {.stop = stop.get_token()});
  ASSERT_TRUE(plan.result.solved()) << plan.result.reason;
  EXPECT_TRUE(plan.result.interrupted);
  ASSERT_EQ(plan.iterations.size(), 3u);
  EXPECT_EQ(plan.iterations[2].status, PlanStatus::kCanceled);
  EXPECT_EQ(plan.result.travel_time, fastest_of(plan.iterations));
  test::expect_valid(plan.planner, plan.result);
  // Without a plan, and before an iteration: a start that collides ends the first one before it looks at the token.
  const CurvedPlan none =
      plan_among_curves(pond(), {{25, 20, 0}, {55, 35, 0}}, {.last = 1e-4}, make_planner, {.stop = stop.get_token()});
  EXPECT_EQ(none.result.status, PlanStatus::kCanceled);
  EXPECT_TRUE(none.result.interrupted);
  ASSERT_EQ(none.iterations.size(), 1u);
  EXPECT_EQ(none.iterations[0].status, PlanStatus::kStartInCollision);
}

TEST(CurvedPlan, CountsTheTimeLimitOverAllIterations) {
  constexpr double kLimit = 2.0;
  int iteration = 0;
  const auto make_planner = [&](const World& rings) {
    if (++iteration == 2) std::this_thread::sleep_for(std::chrono::duration<double>(kLimit));
    return Planner(rings, Vehicle());
  };
  const CurvedPlan plan = plan_among_curves(pond(), kAroundThePond, {.last = 1e-4}, make_planner, {.time = kLimit});
  ASSERT_TRUE(plan.result.solved()) << plan.result.reason;
  EXPECT_TRUE(plan.result.interrupted);
  ASSERT_EQ(plan.iterations.size(), 2u);
  EXPECT_EQ(plan.iterations[1].status, PlanStatus::kTimeLimit);
  EXPECT_EQ(plan.result.travel_time, plan.iterations[0].travel_time);
  test::expect_valid(plan.planner, plan.result);
  // The reason names the limit that was given, not what an iteration had of it.
  const CurvedPlan none = plan_among_curves(pond(), kAroundThePond, {}, make_planner, {.time = 0.0});
  EXPECT_EQ(none.result.status, PlanStatus::kTimeLimit);
  EXPECT_TRUE(none.result.interrupted);
  EXPECT_EQ(none.iterations.size(), 1u);
  EXPECT_NE(none.result.reason.find("time limit of 0 s"), std::string::npos) << none.result.reason;
}

TEST(CurvedPlan, RefusesTolerancesOutOfRange) {
  const CurvedWorld world = generate_curved_world({.curves = 1});
  EXPECT_THROW(plan_among_curves(world, Vehicle(), across(world), {.first = 0.1, .last = 0.2}), std::invalid_argument);
  EXPECT_THROW(plan_among_curves(world, Vehicle(), across(world), {.last = 0.0}), std::invalid_argument);
  EXPECT_THROW(plan_among_curves(world, Vehicle(), across(world), {.factor = 1.0}), std::invalid_argument);
  EXPECT_THROW(generate_curved_world({.curves = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace arcway::internal

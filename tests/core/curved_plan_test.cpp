#include "core/curved_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/angle.h"
#include "datasets/generators/curved_world.h"
#include "tests/support/plans.h"

namespace arcway {
namespace {

PlanRequest across(const CurvedWorld& world) {
  const Vec2& corner = (*world.bounds)[2];
  return {.start = {7.0, 7.0, 0.0}, .goal = {corner.x() - 7.0, corner.y() - 7.0, 0.0}};
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
  EXPECT_EQ(uniform.rounds.size(), 1u);
  EXPECT_GE(adaptive.rounds.size(), 4u);
  EXPECT_EQ(adaptive.rounds.back().tolerance, 0.005);
  EXPECT_LT(adaptive.rounds.back().vertices, uniform.rounds.back().vertices * 3 / 4);
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
            EXPECT_FALSE(along < body.front && along > -body.rear && aside < body.half_width);
          }
    }
  }
}

// A pool in an annulus: the outline, its hole and the bounds are curves.
TEST(CurvedPlan, ReplacesHolesAndBounds) {
  const auto circle = [](double radius, bool clockwise) {
    std::vector<Vec2> points;
    for (int i = 0; i < 16; ++i) points.push_back(radius * direction_of((clockwise ? -1.0 : 1.0) * i * kTwoPi / 16.0));
    const ClosedSpline spline(points);
    return std::vector<CubicBezier>(spline.pieces().begin(), spline.pieces().end());
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

TEST(CurvedPlan, RefusesTolerancesOutOfRange) {
  const CurvedWorld world = generate_curved_world({.curves = 1});
  EXPECT_THROW(plan_among_curves(world, Vehicle(), across(world), {.first = 0.1, .last = 0.2}), std::invalid_argument);
  EXPECT_THROW(plan_among_curves(world, Vehicle(), across(world), {.last = 0.0}), std::invalid_argument);
  EXPECT_THROW(plan_among_curves(world, Vehicle(), across(world), {.factor = 1.0}), std::invalid_argument);
  EXPECT_THROW(generate_curved_world({.curves = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace arcway

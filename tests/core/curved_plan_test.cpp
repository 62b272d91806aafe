#include "core/curved_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/path/validation.h"
#include "datasets/generators/curved_world.h"

namespace arcway {
namespace {

PlanRequest across(const CurvedWorld& world) {
  const Vec2& corner = (*world.bounds)[2];
  return {.start = {7.0, 7.0, 0.0}, .goal = {corner.x() - 7.0, corner.y() - 7.0, 0.0}};
}

TimedPath timed(const PlanResult& result) {
  TimedPath path;
  for (const TimedSegment& s : result.segments) {
    path.segments.push_back(s.segment);
    path.speed_in.push_back(s.speed_in);
    path.speed_out.push_back(s.speed_out);
    path.durations.push_back(s.duration);
  }
  return path;
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
  const ValidationReport report =
      validate(adaptive.world, robot, adaptive.result.start, adaptive.result.goal, timed(adaptive.result));
  EXPECT_TRUE(report.valid());
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
      for (const auto& curve : world.curves)
        for (const CubicBezier& piece : curve)
          for (int k = 0; k < 20; ++k) {
            const Vec2 p = piece.at(k / 20.0) - pose.position();
            const double along = p.dot(u), aside = std::abs(cross(u, p));
            EXPECT_FALSE(along < body.front && along > -body.rear && aside < body.half_width);
          }
    }
  }
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

#pragma once

#include <gtest/gtest.h>

#include "arcway/planner.h"
#include "arcway/validation.h"

namespace arcway::internal::test {

/// A solved plan passes the validator and respects its own bounds.
/// @param reverse  it may drive backwards.
inline void expect_valid(const Planner& planner, const PlanResult& result, bool reverse = false) {
  const ValidationReport report =
      validate(planner.world(), planner.vehicle(), result.start, result.goal, result.timed_path(),
               {.reverse = reverse, .start_speed = result.start_speed, .goal_speed = result.goal_speed});
  for (const ValidationIssue& issue : report.issues) ADD_FAILURE() << name_of(issue.violation) << ": " << issue.message;
  EXPECT_GE(result.travel_time, result.lower_bound * (1.0 - 1e-12));
  EXPECT_GT(result.min_clearance, 0.0);
}

/// The validator accepts a path, in both gears, whatever its speeds.
inline void expect_valid(const World& world, const Vehicle& vehicle, const Pose& start, const Pose& goal,
                         const Path& path) {
  const ValidationReport report = validate(world, vehicle, start, goal, {path, {}, {}, {}});
  for (const ValidationIssue& issue : report.issues) ADD_FAILURE() << name_of(issue.violation) << ": " << issue.message;
}

/// Two plans are the same, bit for bit.
inline void expect_same_plan(const PlanResult& a, const PlanResult& b) {
  ASSERT_EQ(a.status, b.status);
  EXPECT_EQ(a.travel_time, b.travel_time);
  EXPECT_EQ(a.lower_bound, b.lower_bound);
  EXPECT_EQ(a.min_clearance, b.min_clearance);
  EXPECT_EQ(a.statistics.nodes_expanded, b.statistics.nodes_expanded);
  ASSERT_EQ(a.segments.size(), b.segments.size());
  for (std::size_t i = 0; i < a.segments.size(); ++i) {
    EXPECT_EQ(a.segments[i].segment.start.position(), b.segments[i].segment.start.position());
    EXPECT_EQ(a.segments[i].segment.start.heading, b.segments[i].segment.start.heading);
    EXPECT_EQ(a.segments[i].segment.length, b.segments[i].segment.length);
    EXPECT_EQ(a.segments[i].segment.curvature, b.segments[i].segment.curvature);
  }
}

}  // namespace arcway::internal::test

#pragma once

#include <gtest/gtest.h>

#include "core/path/validation.h"
#include "core/planner.h"

namespace arcway::test {

/// A solved plan passes the validator and respects its own bounds.
/// @param reverse  it may drive backwards.
inline void expect_valid(const Planner& planner, const PlanResult& result, bool reverse = false) {
  const ValidationReport report = validate(planner.world(), planner.vehicle(), result.start, result.goal,
                                           result.timed_path(), {.reverse = reverse});
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

}  // namespace arcway::test

#pragma once

#include <gtest/gtest.h>

#include "core/path/validation.h"
#include "core/planner.h"

namespace arcway::test {

/// A solved plan passes the validator and respects its own bounds.
/// @param reverse  it may drive backwards.
inline void expect_valid(const Planner& planner, const PlanResult& result, bool reverse = false) {
  TimedPath path;
  for (const TimedSegment& s : result.segments) {
    path.segments.push_back(s.segment);
    path.speed_in.push_back(s.speed_in);
    path.speed_out.push_back(s.speed_out);
    path.durations.push_back(s.duration);
  }
  const ValidationReport report =
      validate(planner.world(), planner.vehicle(), result.start, result.goal, path, {.reverse = reverse});
  for (const ValidationIssue& issue : report.issues) ADD_FAILURE() << name_of(issue.violation) << ": " << issue.message;
  EXPECT_GE(result.travel_time, result.lower_bound * (1.0 - 1e-12));
  EXPECT_GT(result.min_clearance, 0.0);
}

}  // namespace arcway::test

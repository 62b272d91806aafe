#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "arcway/moving_obstacle.h"
#include "arcway/planner.h"
#include "arcway/validation.h"
#include "bench/cli/evasion_rows.h"

namespace arcway::internal::cli {

/// A plan and the validator's report; no report unless solved.
struct CheckedPlan {
  PlanResult result;
  std::optional<ValidationReport> report;
  std::size_t goal = 0;                        ///< goal reached by a tour, see Tour
  std::vector<std::size_t> passed = {};        ///< waypoints passed by a tour, see Tour
  std::optional<EvasionSummary> evasion = {};  ///< with moving obstacles only
  std::string defect = {};                     ///< contradiction between planner and validator; else empty
  [[nodiscard]] bool good() const { return report && report->valid() && defect.empty(); }
};
CheckedPlan checked(const Validator& validator, const Vehicle& vehicle, PlanResult result, bool reverse,
                    std::span<const MovingObstacle> moving = {});

/// Whether all rows of the reduced graph were found, rather than only those that a search asked for.
bool has_all_rows(const Planner& planner);

/// Rows of the text that the tool prints: what was built and how long it took, a plan, its search, its check.
std::string prepare_rows(const Planner& planner, double build_seconds);
std::string result_rows(const PlanResult& result);
std::string search_rows(const PlanStatistics& statistics);
/// Row of the searches' limits; none if the graph's fastest path was asked for.
std::string suboptimality_row(double suboptimality);
/// Row of the validator's report, and of a planner's defect if there is one. Precondition: the plan is solved.
std::string validity_row(const CheckedPlan& plan);

}  // namespace arcway::internal::cli

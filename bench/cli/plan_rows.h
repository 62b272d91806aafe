#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "arcway/planner.h"
#include "arcway/validation.h"

namespace arcway::internal::cli {

/// A plan and what the validator says of it; no report unless solved.
struct CheckedPlan {
  PlanResult result;
  std::optional<ValidationReport> report;
  std::size_t goal = 0;                  ///< of a tour, see Tour
  std::vector<std::size_t> passed = {};  ///< likewise
  std::string defect = {};               ///< of the planner: what both of them cannot be right about; else empty
  [[nodiscard]] bool good() const { return report && report->valid() && defect.empty(); }
};
CheckedPlan checked(const Validator& validator, const Vehicle& vehicle, PlanResult result, bool reverse);

/// Whether all rows of the reduced graph were found, rather than those that a search asked for.
bool has_all_rows(const Planner& planner);

/// Rows of the text that the tool prints: what was built and how long it took, a plan, its search, its check.
std::string prepare_rows(const Planner& planner, double build_seconds);
std::string result_rows(const PlanResult& result);
std::string search_rows(const PlanStatistics& statistics);
/// What searches were allowed; nothing if the fastest path of the graph was asked for.
std::string suboptimality_row(double suboptimality);
/// What the validator says, and a defect of the planner if there is one. Precondition: the plan is solved.
std::string validity_row(const CheckedPlan& plan);

}  // namespace arcway::internal::cli

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "arcway/planner.h"
#include "arcway/tour.h"
#include "bench/cli/arguments.h"
#include "bench/cli/output_files.h"
#include "bench/cli/plan_arguments.h"
#include "bench/cli/plan_rows.h"

namespace arcway::internal::cli {

/// Plans alternatives, or the one plan that passes all waypoints to a goal.
/// @throws UsageError where alternatives are asked for and there is more than a start and a goal.
std::vector<CheckedPlan> plans_of(const PlanArguments& arguments, const Planner& planner, const TourRequest& request,
                                  const PlanLimits& limits);

/// What plans were made with.
struct PreparedPlanner {
  const PlanArguments& arguments;
  const LoadedMap& map;
  const Planner& planner;
  double build_seconds;  ///< time for making the planner [s]
};

/// Where results go.
struct PlanOutput {
  OutputFiles& files;
  std::string& text;  ///< for standard output
};

/// Writes the requested files and the printed text.
/// @param plans  at least one; the first one is drawn and sampled.
/// @returns the exit code.
int plan_one(const PreparedPlanner& prepared, const TourRequest& request, const std::vector<CheckedPlan>& plans,
             const PlanOutput& output);

/// Reports that the time limit was over before the map was prepared, so that nothing was planned. Writes --json.
/// @returns the exit code.
int no_plan(const PlanArguments& arguments, const LoadedMap& map, const TourRequest& request, const PlanOutput& output);

/// Plans on rings that are refined near the path, down to the tolerance that the map was read with.
int plan_curved(const PlanArguments& arguments, LoadedMap& map, const TourRequest& request,
                const std::function<Planner(const World&)>& make_planner, const PlanOutput& output);

}  // namespace arcway::internal::cli

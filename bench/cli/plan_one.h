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

/// Writes the requested files, and the printed text to `out`.
/// @param plans  at least one; the first one is drawn and sampled.
/// @returns the exit code.
int plan_one(const PlanArguments& arguments, const LoadedMap& map, const Planner& planner, double build_seconds,
             const TourRequest& request, const std::vector<CheckedPlan>& plans, OutputFiles& files, std::string& out);

/// Reports that the time limit was over before the map was prepared, so that nothing was planned. Writes --json.
/// @returns the exit code.
int no_plan(const PlanArguments& arguments, const LoadedMap& map, const TourRequest& request, const PlanLimits& limits,
            OutputFiles& files, std::string& out);

/// Plans on rings that are refined near the path, down to the tolerance that the map was read with.
int plan_curved(const PlanArguments& arguments, LoadedMap& map, const TourRequest& request,
                const std::function<Planner(const World&)>& make_planner, const PlanLimits& limits, OutputFiles& files,
                std::string& out);

}  // namespace arcway::internal::cli

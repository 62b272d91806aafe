#pragma once

#include <string>
#include <vector>

#include "bench/cli/arguments.h"
#include "bench/cli/output_files.h"
#include "bench/cli/plan_arguments.h"
#include "core/base/team.h"
#include "core/planner/planner.h"

namespace arcway::cli {

/// Plans many queries on one map with all threads and processes, writes a line for each and their summary to `out`.
/// @returns the exit code.
int answer_queries(const PlanArguments& arguments, const LoadedMap& map, const Planner& planner, double build_seconds,
                   const std::vector<NumberedRequest>& queries, const PlanLimits& limits, const Team& team,
                   OutputFiles& files, std::string& out);

}  // namespace arcway::cli

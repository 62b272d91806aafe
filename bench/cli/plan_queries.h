#pragma once

#include <string>
#include <vector>

#include "arcway/planner.h"
#include "arcway/process_group.h"
#include "bench/cli/arguments.h"
#include "bench/cli/output_files.h"
#include "bench/cli/plan_arguments.h"

namespace arcway::internal::cli {

/// Plans many queries on one map with all threads and processes, writes a line for each and their summary to `out`.
/// @returns the exit code.
int answer_queries(const PlanArguments& arguments, const LoadedMap& map, const Planner& planner, double build_seconds,
                   const std::vector<NumberedRequest>& queries, const PlanLimits& limits,
                   const ProcessGroup& process_group, OutputFiles& files, std::string& out);

}  // namespace arcway::internal::cli

#pragma once

#include <string>
#include <vector>

#include "arcway/planner.h"
#include "arcway/process_group.h"
#include "bench/cli/arguments.h"
#include "bench/cli/output_files.h"
#include "bench/cli/plan_arguments.h"
#include "bench/cli/plan_one.h"

namespace arcway::internal::cli {

/// Plans many queries on one map with all threads and processes, writes a line for each and their summary.
/// @returns the exit code.
int answer_queries(const PreparedPlanner& prepared, const std::vector<NumberedRequest>& queries,
                   const ProcessGroup& process_group, const PlanOutput& output);

}  // namespace arcway::internal::cli

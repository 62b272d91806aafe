#pragma once

#include <limits>
#include <span>
#include <stop_token>
#include <vector>

#include "arcway/executor.h"
#include "arcway/export.h"
#include "arcway/planner.h"
#include "arcway/progress.h"

namespace arcway {

/// When a batch ends early, and who is told how far it is.
struct ARCWAY_API BatchOptions {
  double time_limit = std::numeric_limits<double>::infinity();  ///< of each query [s]
  std::stop_token stop = {};                                    ///< of the batch; may be requested from any thread
  ProgressCallback progress = {};                               ///< counts queries, in the stage "queries"
};

/// The plans of many queries, in their order, on the threads of an executor. Each equals that of Planner::plan, bit for
/// bit, with any number of threads. Only measured times, and counters of a lazy graph, depend on the threads.
///
///     const std::vector<PlanResult> plans = plan_batch(planner, requests);
///
/// Once a stop is requested, running queries end as PlanLimits says, and the others get the status kCanceled.
/// @throws std::invalid_argument as Planner::plan does, naming the first request at fault, after all others are done.
ARCWAY_API std::vector<PlanResult> plan_batch(const Planner& planner, std::span<const PlanRequest> requests,
                                              const Executor& executor = ThreadExecutor(),
                                              const BatchOptions& options = {});

}  // namespace arcway

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

struct ARCWAY_API BatchOptions {
  double time_limit = std::numeric_limits<double>::infinity();  ///< of each search [s]
  std::stop_token stop = {};                                    ///< asked from any thread
  ProgressCallback progress = {};                               ///< in queries, stage "queries"
};

/// The plans of many queries, in their order, on the threads of an executor. Each is that of Planner::plan, bit for
/// bit, whatever the number of threads; only times, and on a lazy graph counters, depend on it.
///
///     const std::vector<PlanResult> plans = plan_batch(planner, requests, TbbExecutor());
///
/// Once a stop is requested, searches end as PlanLimits says, and queries not begun have the status kCanceled.
/// @throws std::invalid_argument as Planner::plan does, naming the first request at fault, when all others are done.
ARCWAY_API std::vector<PlanResult> plan_batch(const Planner& planner, std::span<const PlanRequest> requests,
                                              const Executor& executor, const BatchOptions& options = {});

}  // namespace arcway

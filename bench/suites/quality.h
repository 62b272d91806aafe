#pragma once

#include <benchmark/benchmark.h>

#include <vector>

#include "arcway/planner.h"

namespace arcway::internal::bench {

/// Plans with all times in processor time: a busy machine makes no plan look slow. The planner's own clock is the
/// wall's; each stage has its share of the whole.
PlanResult plan_by_processor_time(const Planner& planner, const PlanRequest& request, const PlanLimits& limits = {});
std::vector<PlanResult> plan_by_processor_time(const Planner& planner, const std::vector<PlanRequest>& requests);

/// Adds counters of what searches, refinement, and maneuvers and trees did: expansions_per_query, trials_per_query,
/// poses_per_query.
void count_search(benchmark::State& state, const std::vector<PlanResult>& results);

/// Adds counters of the share solved and why not, what was searched and, where a query is solved, of the travel time
/// over the lower bound, the times of planning and the smallest clearance.
void count_quality(benchmark::State& state, const std::vector<PlanResult>& results);

/// Adds counters of a map, of what it took to prepare it, and of all queries there, also those that are not solved.
void count_map(benchmark::State& state, const Planner& planner, double prepare_seconds,
               const std::vector<PlanResult>& results);

}  // namespace arcway::internal::bench

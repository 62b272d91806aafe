#include "bench/suites/quality.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "bench/cpu_clock.h"
#include "bench/quantiles.h"
#include "core/model/body_size.h"

namespace arcway::internal::bench {

PlanResult plan_by_processor_time(const Planner& planner, const PlanRequest& request, const PlanLimits& limits) {
  const CpuClock clock(CpuClock::Of::kProcess);
  PlanResult result = planner.plan(request, limits);
  PlanStatistics& s = result.statistics;
  const double factor = s.total_seconds > 0.0 ? clock.seconds() / s.total_seconds : 1.0;
  for (double* seconds : {&s.first_path_seconds, &s.search_seconds, &s.refine_seconds, &s.lower_bound_seconds,
                          &s.profile_seconds, &s.total_seconds})
    *seconds *= factor;
  return result;
}

std::vector<PlanResult> plan_by_processor_time(const Planner& planner, const std::vector<PlanRequest>& requests) {
  std::vector<PlanResult> results;
  for (const PlanRequest& request : requests) results.push_back(plan_by_processor_time(planner, request));
  return results;
}

void count_search(benchmark::State& state, const std::vector<PlanResult>& results) {
  PlanStatistics sum;
  for (const PlanResult& result : results) sum += result.statistics;
  const auto add = [&](const char* counter, std::uint64_t count) {
    state.counters[counter] = static_cast<double>(count) / static_cast<double>(results.size());
  };
  add("expansions_per_query", sum.nodes_expanded);
  add("trials_per_query", sum.refine_trials);
  add("poses_per_query", sum.maneuver_poses + sum.tree_poses);
}

void count_quality(benchmark::State& state, const std::vector<PlanResult>& results) {
  double solved = 0.0, clearance = std::numeric_limits<double>::infinity();
  double start_blocked = 0.0, goal_blocked = 0.0, no_path = 0.0;
  std::vector<double> over_bound, first_over_bound, first_seconds, search_seconds, refine_seconds, seconds;
  for (const PlanResult& r : results) {
    start_blocked += r.status == PlanStatus::kStartBlocked;
    goal_blocked += r.status == PlanStatus::kGoalBlocked;
    no_path += r.status == PlanStatus::kNoPath || r.status == PlanStatus::kNoPassage;
    if (!r.solved()) continue;
    solved += 1.0;
    clearance = std::min(clearance, r.min_clearance);
    over_bound.push_back(1.0 + r.optimality_gap());
    first_over_bound.push_back(r.lower_bound > 0.0 ? r.statistics.first_travel_time / r.lower_bound : 1.0);
    first_seconds.push_back(r.statistics.first_path_seconds);
    search_seconds.push_back(r.statistics.search_seconds);
    refine_seconds.push_back(r.statistics.refine_seconds);
    seconds.push_back(r.statistics.total_seconds);
  }
  const auto count = static_cast<double>(results.size());
  state.counters["solved_share"] = solved / count;
  state.counters["start_blocked"] = start_blocked;
  state.counters["goal_blocked"] = goal_blocked;
  state.counters["no_path"] = no_path;
  count_search(state, results);
  state.counters["queries"] = count;
  if (solved == 0.0) return;
  state.counters["time_over_bound_median"] = median(over_bound);
  state.counters["first_over_bound_median"] = median(first_over_bound);
  state.counters["first_path_seconds_median"] = median(first_seconds);
  state.counters["search_seconds_median"] = median(search_seconds);
  state.counters["refine_seconds_median"] = median(refine_seconds);
  state.counters["plan_seconds_median"] = median(seconds);
  state.counters["plan_seconds_p95"] = quantile(seconds, 0.95);
  if (std::isfinite(clearance)) state.counters["min_clearance_m"] = clearance;  // not in a world without obstacles
}

void count_map(benchmark::State& state, const Planner& planner, double prepare_seconds,
               const std::vector<PlanResult>& results) {
  const auto having = [&](PlanStatus status) {
    return static_cast<double>(std::ranges::count(results, status, &PlanResult::status));
  };
  std::vector<double> seconds;
  for (const PlanResult& r : results) seconds.push_back(r.statistics.total_seconds);
  state.counters["vertices"] = static_cast<double>(planner.world().vertices().size());
  state.counters["body_length_m"] = body_length(planner.vehicle());
  state.counters["prepare_seconds"] = prepare_seconds;
  state.counters["queries"] = static_cast<double>(results.size());
  state.counters["solved"] = having(PlanStatus::kSolved);
  state.counters["start_blocked"] = having(PlanStatus::kStartBlocked);
  state.counters["goal_blocked"] = having(PlanStatus::kGoalBlocked);
  state.counters["no_path"] = having(PlanStatus::kNoPath) + having(PlanStatus::kNoPassage);
  state.counters["time_limit"] = having(PlanStatus::kTimeLimit);
  state.counters["first_seconds"] = seconds.front();
  state.counters["plan_seconds_median"] = median(seconds);
  state.counters["plan_seconds_p99"] = quantile(seconds, 0.99);
}

}  // namespace arcway::internal::bench

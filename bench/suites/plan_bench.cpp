#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bench/suites/allocations.h"
#include "bench/suites/backends.h"
#include "bench/suites/corruption.h"
#include "bench/suites/suite.h"
#include "core/path/validation.h"
#include "core/planner.h"
#include "datasets/catalogue.h"
#include "datasets/random_queries.h"

// Whole plans: with the graph built before, with it built for one query, by each heuristic; and how good they are.
namespace arcway::bench {
namespace {

constexpr std::size_t kQueries = 20;

QuerySet fastest_queries(const World& world) { return query_backends().back().make(world); }

const Planner& planner_for(const std::string& world_name, Heuristic heuristic = Heuristic::kTravelTime) {
  static std::map<std::pair<std::string, Heuristic>, Planner> planners;
  const std::pair key{world_name, heuristic};
  const auto found = planners.find(key);
  if (found != planners.end()) return found->second;
  const World& world = shared_world(world_name);
  const SerialExecutor executor;
  return planners
      .emplace(key, Planner(world, Vehicle(), fastest_queries(world), graph_builders().back().build(world, executor),
                            {.heuristic = heuristic}, executor))
      .first->second;
}

bool is_valid(const Planner& planner, const PlanResult& result) {
  TimedPath path;
  for (const TimedSegment& s : result.segments) {
    path.segments.push_back(s.segment);
    path.speed_in.push_back(s.speed_in);
    path.speed_out.push_back(s.speed_out);
    path.durations.push_back(s.duration);
  }
  if (corrupting() && !path.segments.empty()) path.segments.back().length += 0.01;
  return validate(planner.world(), planner.vehicle(), result.start, result.goal, path).valid();
}

/// Share solved, travel time over the lower bound and over the best known time, smallest clearance, expansions.
void count_quality(benchmark::State& state, const std::vector<PlanResult>& results, const std::vector<double>& best) {
  double solved = 0.0, expanded = 0.0, clearance = std::numeric_limits<double>::infinity(), worst = 1.0;
  double start_blocked = 0.0, goal_blocked = 0.0, no_path = 0.0;
  std::vector<double> over_bound;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const PlanResult& r = results[i];
    expanded += static_cast<double>(r.statistics.nodes_expanded);
    start_blocked += r.status == PlanStatus::kStartBlocked;
    goal_blocked += r.status == PlanStatus::kGoalBlocked;
    no_path += r.status == PlanStatus::kNoPath;
    if (!r.solved()) continue;
    solved += 1.0;
    clearance = std::min(clearance, r.min_clearance);
    over_bound.push_back(r.travel_time / r.lower_bound);
    if (best[i] > 0.0) worst = std::max(worst, r.travel_time / best[i]);
  }
  const auto count = static_cast<double>(results.size());
  state.counters["solved_share"] = solved / count;
  state.counters["start_blocked"] = start_blocked;
  state.counters["goal_blocked"] = goal_blocked;
  state.counters["no_path"] = no_path;
  state.counters["expansions_per_query"] = expanded / count;
  state.counters["queries"] = count;
  if (over_bound.empty()) return;
  std::ranges::sort(over_bound);
  state.counters["time_over_bound_median"] = over_bound[over_bound.size() / 2];
  state.counters["time_over_best_worst"] = worst;
  state.counters["min_clearance_m"] = clearance;
}

std::vector<PlanResult> plan_all(const Planner& planner, const std::vector<PlanRequest>& requests) {
  std::vector<PlanResult> results;
  for (const PlanRequest& request : requests) results.push_back(planner.plan(request));
  return results;
}

void time_queries(benchmark::State& state, const std::string& world_name, const std::vector<PlanRequest>& requests,
                  Heuristic heuristic = Heuristic::kTravelTime) {
  const Planner& planner = planner_for(world_name, heuristic);
  const std::vector<PlanResult> results = plan_all(planner, requests);
  // Dijkstra's search finds the graph's best path whatever the heuristic.
  const std::vector<PlanResult> best = plan_all(planner_for(world_name, Heuristic::kDijkstra), requests);
  std::vector<double> best_times;
  for (const PlanResult& r : best) best_times.push_back(r.solved() ? r.travel_time : 0.0);
  bool right = false;  // at least one path, and no wrong one
  for (const PlanResult& r : results) right = right || r.solved();
  for (const PlanResult& r : results) right = right && (!r.solved() || is_valid(planner, r));
  if (!require(state, right, "the validator refuses a path, or there is none")) return;
  const std::uint64_t before = heap_use().allocations;
  plan_all(planner, requests);
  const auto allocated = static_cast<double>(heap_use().allocations - before);
  for (auto _ : state)
    for (const PlanRequest& request : requests) benchmark::DoNotOptimize(planner.plan(request));
  state.counters["vertices"] = static_cast<double>(planner.world().vertices().size());
  state.counters["allocations_per_query"] = allocated / static_cast<double>(requests.size());
  count_quality(state, results, best_times);
}

/// Pairs whose distance is a share of the map's side, from `low` to `low` + 0.1.
std::vector<PlanRequest> requests_at(const std::string& world_name, double low) {
  const World& world = shared_world(world_name);
  const double side = (world.box().max - world.box().min).maxCoeff();
  std::vector<PlanRequest> kept;
  for (const PlanRequest& r :
       random_queries(world, fastest_queries(world), Vehicle(), {.count = 4000, .min_distance = low, .seed = 1})) {
    if ((r.start.position() - r.goal.position()).norm() < (low + 0.1) * side) kept.push_back(r);
    if (kept.size() == kQueries) break;
  }
  return kept;
}

void time_from_nothing(benchmark::State& state, const std::string& world_name) {
  const World& world = shared_world(world_name);
  const std::vector<PlanRequest> requests = catalogue_queries(world_name, kQueries, 1);
  const auto solve = [&] {
    const SerialExecutor executor;
    const Planner planner(world, Vehicle(), fastest_queries(world), graph_builders().back().build(world, executor), {},
                          executor);
    PlanResult result;
    for (const PlanRequest& request : requests)
      if (result = planner.plan(request); result.solved()) break;
    return std::pair(planner, result);
  };
  reset_heap_peak();
  const HeapUse before = heap_use();
  const auto [planner, result] = solve();
  const HeapUse after = heap_use();
  if (!require(state, result.solved() && is_valid(planner, result), "the validator refuses the path, or there is none"))
    return;
  for (auto _ : state) benchmark::DoNotOptimize(solve());
  const auto vertices = static_cast<double>(world.vertices().size());
  state.counters["vertices"] = vertices;
  state.counters["peak_bytes_per_vertex"] = static_cast<double>(after.peak_bytes - before.live_bytes) / vertices;
  state.counters["bytes_per_vertex"] = static_cast<double>(after.live_bytes - before.live_bytes) / vertices;
}

void add(Study study) {
  Series reused(study, "Plan/graph_reused", "obstacles", "20 queries: A* over the part of the graph towards the goal",
                1.0);
  Series built(study, "Plan/graph_built", "obstacles", "O(n log n + k log n), graph and one query", 1.1);
  for (const std::size_t n : sizes(study, {10, 32, 100, 316, 1000, 3162, 10000, 31623}, 32, 3162)) {
    const std::string name = clutter_name("convex", n, 10, 30);
    reused.add(static_cast<double>(n),
               [name](benchmark::State& state) { time_queries(state, name, catalogue_queries(name, kQueries, 1)); });
    built.add(static_cast<double>(n), [name](benchmark::State& state) { time_from_nothing(state, name); });
  }
  const std::size_t obstacles = study == Study::kCheck ? 32 : 1000;
  const std::string name = clutter_name("convex", obstacles, 10, 30);
  Series by_distance(study, "Plan/n:" + std::to_string(obstacles), "percent_of_side", "A*: grows with the distance",
                     2.0);
  for (const std::size_t percent : sizes(study, {10, 20, 40, 60, 80}, 20, 80))
    by_distance.add(static_cast<double>(percent), [name, percent](benchmark::State& state) {
      time_queries(state, name, requests_at(name, 0.01 * static_cast<double>(percent)));
    });
  const std::pair<const char*, Heuristic> heuristics[] = {{"travel_time", Heuristic::kTravelTime},
                                                          {"paper_distance", Heuristic::kPaperDistance},
                                                          {"dijkstra", Heuristic::kDijkstra}};
  for (const auto& [label, heuristic] : heuristics)
    add_benchmark("Search/" + std::string(label) + "/n" + std::to_string(obstacles),
                  [name, heuristic = heuristic](benchmark::State& state) {
                    time_queries(state, name, catalogue_queries(name, kQueries, 1), heuristic);
                  });
  for (const char* kind : {"convex", "star"})
    for (const int fill : {15, 30, 45}) {
      if (study == Study::kCheck && fill != 30) continue;
      const std::string world = clutter_name(kind, 100, 10, fill);
      add_benchmark("Quality/" + std::string(kind) + "/fill" + std::to_string(fill),
                    [world](benchmark::State& state) { time_queries(state, world, catalogue_queries(world, 50, 1)); });
    }
}

const Suite suite(add);

}  // namespace
}  // namespace arcway::bench

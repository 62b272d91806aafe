#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "arcway/datasets/catalog.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/plan_batch.h"
#include "arcway/turning_radii.h"
#include "bench/cpu_clock.h"
#include "bench/quantiles.h"
#include "bench/robots.h"
#include "bench/suites/allocations.h"
#include "bench/suites/backends.h"
#include "bench/suites/plans.h"
#include "bench/suites/quality.h"
#include "bench/suites/suite.h"
#include "bench/suites/work.h"
#include "bench/vehicle_worlds.h"
#include "core/roadmap/feasible_graph.h"

// Whole plans of real vehicles and of the paper's robot: on a prepared map, and one for a new map with everything
// checked before or as it is needed. Batches by several threads. What distance, fill and radii do to plans.
namespace arcway::internal::bench::plan_suite {
namespace {

constexpr std::size_t kQueries = 20;
constexpr std::size_t kFewQueries = 5;  // queries with seven radii, which take long
constexpr std::size_t kVehicleQueries = 10;
constexpr const char* kWrong = "the validator refuses a path, or there is none";

void time_queries(benchmark::State& state, const Planner& planner, const std::vector<PlanRequest>& requests) {
  const std::vector<PlanResult> results = plan_all(planner, requests);
  if (!require(state, are_right(planner, results), kWrong)) return;
  PlanResult result;
  const auto repeat = [&] {
    for (const PlanRequest& request : requests) {
      planner.plan(request, {}, result);
      benchmark::DoNotOptimize(result);
    }
  };
  repeat();
  const LoopWork work;
  for ([[maybe_unused]] auto _ : state) repeat();
  work.count(state, "query", requests.size());
  count_search(state, results);
  set_batch(state, requests.size());
  state.counters["vertices"] = static_cast<double>(planner.world().vertices().size());
  state.counters["queries"] = static_cast<double>(requests.size());
  state.counters["solved"] = static_cast<double>(std::ranges::count_if(results, &PlanResult::solved));
}

/// Pairs whose distance is a share of the map's side, from `low` to `low` + 0.1.
std::vector<PlanRequest> requests_at(const std::string& world_name, double low) {
  const World& world = shared_world(world_name);
  const double side = (world.box().max - world.box().min).maxCoeff();
  std::vector<PlanRequest> kept;
  for (const PlanRequest& r :
       random_queries(world, fastest_queries(world), Vehicle(), {.count = 400, .min_distance = low, .seed = 1})) {
    if ((r.start.position() - r.goal.position()).norm() < (low + 0.1) * side) kept.push_back(r);
    if (kept.size() == kQueries) break;
  }
  return kept;
}

/// The first of a world's queries that has a plan, found once for each key.
PlanRequest first_solved(const std::string& key, const World& world, const Vehicle& vehicle) {
  static std::map<std::string, PlanRequest> known;
  const auto found = known.find(key);
  if (found != known.end()) return found->second;
  const Planner planner = make_planner(world, vehicle, {.graph_mode = GraphMode::kLazy});
  for (const PlanRequest& request : queries_for(vehicle, world, kQueries, 1))
    if (planner.plan(request).solved()) return known.emplace(key, request).first->second;
  throw std::runtime_error(key + ": no query has a plan");
}

/// Queries, graphs and one plan.
void time_from_nothing(benchmark::State& state, const World& world, const Vehicle& vehicle, const PlanRequest& request,
                       GraphMode mode) {
  const auto solve = [&] {
    const Planner planner = make_planner(world, vehicle, {.graph_mode = mode});
    return std::pair(planner, std::vector{planner.plan(request)});
  };
  reset_heap_peak();
  const HeapUse before = heap_use();
  const auto [planner, results] = solve();
  const HeapUse after = heap_use();
  if (!require(state, are_right(planner, results), kWrong)) return;
  const LoopWork work;
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(solve());
  work.count(state, "query");
  count_search(state, results);
  const auto vertices = static_cast<double>(world.vertices().size());
  state.counters["vertices"] = vertices;
  state.counters["peak_bytes_per_vertex"] = static_cast<double>(after.peak_bytes - before.live_bytes) / vertices;
  state.counters["bytes_per_vertex"] = static_cast<double>(after.live_bytes - before.live_bytes) / vertices;
}

/// A real vehicle's plans on a prepared map that has answered these queries before.
void time_prepared(benchmark::State& state, const KeptVehicle& kept, const std::string& world_name) {
  struct Prepared {
    Planner planner;
    bool is_right;
  };
  static std::map<std::pair<std::string_view, std::string>, Prepared> known;
  const World& world = shared_world(kept, world_name);
  const std::vector<PlanRequest> requests = queries_for(kept.vehicle(), world, kVehicleQueries, 1);
  const std::pair key{kept.name, world_name};
  auto found = known.find(key);
  if (found == known.end()) {
    Planner planner = make_planner(world, kept.vehicle(), {});
    planner.warm_up();
    // Asked once, so that no repetition makes the maps that only some queries need.
    const bool is_right = are_right(planner, plan_all(planner, requests));
    found = known.emplace(key, Prepared{std::move(planner), is_right}).first;
  }
  if (!require(state, found->second.is_right, kWrong)) return;
  std::vector<PlanResult> results;
  const LoopWork work;
  for ([[maybe_unused]] auto _ : state) results = plan_all(found->second.planner, requests);
  work.count(state, "query", requests.size());
  count_search(state, results);
  set_batch(state, requests.size());
  state.counters["vertices"] = static_cast<double>(world.vertices().size());
  state.counters["queries"] = static_cast<double>(requests.size());
  state.counters["solved"] = static_cast<double>(std::ranges::count_if(results, &PlanResult::solved));
}

/// How long single queries take, the slow ones above all: when first asked of a prepared planner, and again.
void time_each(benchmark::State& state, const std::string& world_name, std::size_t count) {
  const Planner planner = make_planner(shared_world(world_name), Vehicle(), {.refinement = {.max_trials = 0}});
  planner.warm_up();
  const std::vector<PlanRequest> requests = catalog_queries(world_name, count, 1);
  std::vector<PlanResult> results(requests.size());
  std::vector<double> seconds(requests.size());
  const auto ask_each = [&] {
    for (std::size_t i = 0; i < requests.size(); ++i) {
      const CpuClock planning(CpuClock::Of::kProcess);
      planner.plan(requests[i], {}, results[i]);
      seconds[i] = planning.seconds();
    }
  };
  ask_each();
  state.counters["first_median"] = median(seconds);
  state.counters["first_p99"] = quantile(seconds, 0.99);
  if (!require(state, are_right(planner, results), kWrong)) return;
  for ([[maybe_unused]] auto _ : state) ask_each();
  state.counters["again_median"] = median(seconds);
  state.counters["again_p99"] = quantile(seconds, 0.99);
  state.counters["vertices"] = static_cast<double>(planner.world().vertices().size());
  state.counters["queries"] = static_cast<double>(count);
  state.counters["solved"] = static_cast<double>(std::ranges::count_if(results, &PlanResult::solved));
  set_batch(state, count);
}

/// Queries that do not wait for one another.
void time_batch(benchmark::State& state, const std::string& world_name, std::size_t queries, std::size_t threads) {
  const Planner& planner = shared_planner(world_name);
  const std::vector<PlanRequest> requests = catalog_queries(world_name, queries, 1);
  const std::unique_ptr<Executor> executor = make_executor(threads);
  const std::vector<PlanResult> results = plan_batch(planner, requests, *executor);
  if (!require(state, are_right(planner, results), kWrong)) return;
  const std::vector<PlanResult> one_by_one = plan_all(planner, requests);
  const auto same = [](const PlanResult& a, const PlanResult& b) {
    return a.status == b.status && a.travel_time == b.travel_time && a.length == b.length;
  };
  if (!require(state, std::ranges::equal(results, one_by_one, same), "a batch differs from its queries one by one"))
    return;
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(plan_batch(planner, requests, *executor));
  set_batch(state, queries);
}

void time_radii(benchmark::State& state, const std::string& world_name, std::size_t radii) {
  const Vehicle vehicle = kGentleRobots[0].vehicle();
  std::vector<double> all = turning_radii(vehicle, shared_world(world_name));
  all.resize(std::min(radii, all.size()));
  const Planner planner = make_planner(shared_world(world_name), vehicle, {.radii = all});
  time_queries(state, planner, catalog_queries(world_name, kFewQueries, 1));
  state.counters["links"] = static_cast<double>(planner.feasible_graph().counts().kept);
}

void add_vehicles(Study study) {
  const std::string law = "A* over the part of the graph towards the goal";
  const int repetitions = study == Study::kCheck ? 1 : 3;
  for (const KeptVehicle& kept : real_vehicles()) {
    Series prepared(study, "PlanPrepared/" + std::string(kept.name), "obstacles", law, 1.0);
    Series first(study, "PlanFirst/" + std::string(kept.name), "obstacles",
                 "O(n log n), visibility graph and what one query asks for", 1.1);
    prepared.allow(20.0);
    first.allow(4.0);
    for (const std::size_t n : sizes(study, {10, 32, 100, 316, 1000}, 10, 1000)) {
      const std::string name = clutter_name("convex", n, 10, 30);
      const auto size = static_cast<double>(n);
      prepared.add(size, [&kept, name](benchmark::State& state) { time_prepared(state, kept, name); })
          ->Iterations(1)
          ->Repetitions(repetitions);
      first
          .add(size,
               [&kept, name](benchmark::State& state) {
                 const World& world = shared_world(kept, name);
                 const PlanRequest request =
                     first_solved(std::string(kept.name) + " in " + name, world, kept.vehicle());
                 time_from_nothing(state, world, kept.vehicle(), request, GraphMode::kLazy);
               })
          ->Iterations(1)
          ->Repetitions(repetitions);
    }
  }
}

void add(Study study) {
  add_vehicles(study);
  Series reused(study, "Plan/graph_reused", "obstacles", "A* over the part of the graph towards the goal", 1.0);
  Series eager(study, "Plan/eager", "obstacles", "O(n log n + k log n), graphs and one query", 1.1);
  reused.allow(6.0);
  Series lazy(study, "Plan/lazy", "obstacles", "O(n log n), visibility graph and what one query asks for", 1.1);
  for (const std::size_t n : sizes(study, {10, 32, 100, 316, 1000, 3162, 10000, 31623, 100000}, 32, 1000)) {
    const std::string name = clutter_name("convex", n, 10, 30);
    const auto size = static_cast<double>(n);
    reused.add(size, [name](benchmark::State& state) {
      time_queries(state, shared_planner(name), catalog_queries(name, kQueries, 1));
    });
    const auto from_nothing = [name](benchmark::State& state, GraphMode mode) {
      const World& world = shared_world(name);
      time_from_nothing(state, world, Vehicle(), first_solved(name, world, Vehicle()), mode);
    };
    eager.add(size, [from_nothing](benchmark::State& state) { from_nothing(state, GraphMode::kEager); });
    lazy.add(size, [from_nothing](benchmark::State& state) { from_nothing(state, GraphMode::kLazy); });
  }
  if (study == Study::kQuick) return;
  const std::size_t many = study == Study::kCheck ? 32 : 1000;
  Series each(study, "PlanEach/n:" + std::to_string(many), "fill_percent", "falls with what is seen", 0.0);
  each.allow(30.0);
  for (const int fill : {15, 30})
    each.add(fill, [many, fill, count = study == Study::kCheck ? 20 : 200](benchmark::State& state) {
      time_each(state, clutter_name("convex", many, 10, fill), static_cast<std::size_t>(count));
    });
  const std::size_t obstacles = study == Study::kCheck ? 32 : 316;
  const std::string at = "/n:" + std::to_string(obstacles);
  const std::string name = clutter_name("convex", obstacles, 10, 30);
  Series by_distance(study, "Plan" + at, "percent_of_side", "A*: grows with the distance", 0.5);
  by_distance.allow(6.0);
  for (const std::size_t percent : sizes(study, {10, 20, 40, 60, 80}, 20, 80))
    by_distance.add(static_cast<double>(percent), [name, percent](benchmark::State& state) {
      time_queries(state, shared_planner(name), requests_at(name, 0.01 * static_cast<double>(percent)));
    });
  Series by_fill(study, "Plan" + at, "fill_percent", "falls with what is seen", 0.0);
  for (const std::size_t fill : sizes(study, {5, 10, 20, 30, 40, 50}, 30, 50)) {
    const std::string filled = clutter_name("convex", obstacles, 10, static_cast<int>(fill));
    by_fill.add(static_cast<double>(fill), [filled](benchmark::State& state) {
      time_queries(state, shared_planner(filled), catalog_queries(filled, kQueries, 1));
    });
  }
  const std::size_t batch = study == Study::kCheck ? 20 : 100;
  Series by_threads(study, "PlanBatch" + at, "threads", "1 / threads", 0.0);
  by_threads.allow(4.0);
  for (const std::size_t t : thread_counts())
    by_threads.add(static_cast<double>(t),
                   [name, batch, t](benchmark::State& state) { time_batch(state, name, batch, t); });
  const std::size_t fewer = study == Study::kCheck ? 10 : 100;
  Series by_radii(study, "PlanRadii/n:" + std::to_string(fewer), "radii", "at most O(r^2) pairs of radii an edge", 1.0);
  by_radii.allow(6.0);
  for (const std::size_t r : sizes(study, {1, 2, 3, 4, 5, 6, 7}, 2, 7))
    by_radii.add(static_cast<double>(r),
                 [fewer, r](benchmark::State& state) { time_radii(state, clutter_name("convex", fewer, 10, 15), r); });
}

const Suite suite(add);

}  // namespace
}  // namespace arcway::internal::bench::plan_suite

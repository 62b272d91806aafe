#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "arcway/datasets/catalog.h"
#include "arcway/turning_radii.h"
#include "bench/quantiles.h"
#include "bench/robots.h"
#include "bench/slowest_query.h"
#include "bench/suites/plans.h"
#include "bench/suites/quality.h"
#include "bench/suites/suite.h"
#include "bench/vehicle_worlds.h"

// How good the plans are, beside how long they take: real vehicles and other bodies in worlds of their size, and the
// catalog's query sets. Also the heuristics, and the planner with its features switched off one by one.
namespace arcway::internal::bench::quality_suite {
namespace {

constexpr const char* kWrong = "the validator refuses a path, or there is none";

/// Keeps the slowest query in the label, which the report draws.
void label_slowest(benchmark::State& state, const std::vector<PlanResult>& results, const std::string& world_name) {
  const auto slowest =
      std::ranges::max_element(results, {}, [](const PlanResult& result) { return result.statistics.total_seconds; });
  state.SetLabel(label_of({.world = world_name,
                           .query = static_cast<std::size_t>(slowest - results.begin()),
                           .seconds = slowest->statistics.total_seconds}));
}

/// The largest travel time over the best known one.
void count_worst(benchmark::State& state, const std::vector<PlanResult>& results, const std::vector<PlanResult>& best) {
  double worst = 1.0;
  for (std::size_t i = 0; i < results.size(); ++i)
    if (results[i].solved() && best[i].solved()) worst = std::max(worst, results[i].travel_time / best[i].travel_time);
  state.counters["time_over_best_worst"] = worst;
}

void time_quality(benchmark::State& state, const std::string& world_name, std::size_t queries,
                  Heuristic heuristic = Heuristic::kTravelTime) {
  const Planner& planner = shared_planner(world_name, heuristic);
  const std::vector<PlanRequest> requests = catalog_queries(world_name, queries, 1);
  const std::vector<PlanResult> results = plan_by_processor_time(planner, requests);
  if (!require(state, are_right(planner, results), kWrong)) return;
  for ([[maybe_unused]] auto _ : state)
    for (const PlanRequest& request : requests) benchmark::DoNotOptimize(planner.plan(request));
  set_batch(state, queries);
  label_slowest(state, results, world_name);
  count_quality(state, results);
  // Dijkstra's search finds the graph's best path whatever the heuristic.
  count_worst(state, results, plan_all(shared_planner(world_name, Heuristic::kDijkstra), requests));
}

/// A real vehicle in its own world. Each query is planned once.
void time_vehicle(benchmark::State& state, const KeptVehicle& kept, const std::string& world_name,
                  std::size_t queries) {
  const World& world = shared_world(kept, world_name);
  const Planner planner = make_planner(world, kept.vehicle(), {});
  planner.warm_up();
  const std::vector<PlanRequest> requests = queries_for(kept.vehicle(), world, queries, 1);
  std::vector<PlanResult> results;
  for ([[maybe_unused]] auto _ : state) results = plan_by_processor_time(planner, requests);
  if (!require(state, are_right(planner, results), kWrong)) return;
  set_batch(state, queries);
  label_slowest(state, results, world_name);
  count_quality(state, results);
}

/// The planner without one of its features.
struct Variant {
  const char* name;
  PlannerOptions options;
};

std::vector<Variant> variants(const World& world) {
  const double smallest = turning_radii(kGentleRobots[0].vehicle(), world).front();
  PlannerOptions one_radius, unrefined, no_maneuvers{.maneuver_poses = 0}, paper;
  one_radius.radii.assign(1, smallest);
  PlannerOptions no_gap_circles;
  no_gap_circles.gap_circles = false;
  PlannerOptions segment_times{.time_model = TimeModel::kSegments};
  unrefined.refinement.max_trials = 0;
  paper.heuristic = Heuristic::kPaperDistance;
  PlannerOptions bare = one_radius;
  bare.refinement.max_trials = 0;
  bare.maneuver_poses = 0;
  bare.gap_circles = false;
  return {{"everything", {}},
          {"one radius", one_radius},
          {"no refinement", unrefined},
          {"no maneuvers", no_maneuvers},
          {"no circles in gaps", no_gap_circles},
          {"none of the four", bare},
          {"the paper's heuristic", paper},
          {"the paper's segment times", segment_times}};
}

/// Gaps are compared over the queries that every variant solves, so that solving more does not look worse.
void time_variant(benchmark::State& state, const std::string& world_name, std::size_t chosen, std::size_t queries) {
  static std::map<std::string, std::vector<std::vector<PlanResult>>> plans;
  const World& world = shared_world(world_name);
  const std::vector<Variant> all = variants(world);
  const std::vector<PlanRequest> requests = catalog_queries(world_name, queries, 1);
  std::vector<std::vector<PlanResult>>& results = plans[world_name];
  const Planner planner = make_planner(world, kGentleRobots[0].vehicle(), all[chosen].options);
  for (const Variant& v : all)
    if (results.size() < all.size())
      results.push_back(plan_all(make_planner(world, kGentleRobots[0].vehicle(), v.options), requests));
  if (!require(state, are_right(planner, results[chosen]), kWrong)) return;
  for ([[maybe_unused]] auto _ : state)
    for (const PlanRequest& request : requests) benchmark::DoNotOptimize(planner.plan(request));
  set_batch(state, queries);
  count_search(state, results[chosen]);
  std::vector<double> gaps;
  for (std::size_t q = 0; q < queries; ++q) {
    if (std::ranges::all_of(results, [q](const auto& r) { return r[q].solved(); }))
      gaps.push_back(100.0 * results[chosen][q].optimality_gap());
  }
  state.counters["solved"] = static_cast<double>(std::ranges::count_if(results[chosen], &PlanResult::solved));
  state.counters["gap_percent_median"] = gaps.empty() ? 0.0 : median(gaps);
  state.counters["compared"] = static_cast<double>(gaps.size());
}

/// @param stage  of the benchmarks' names.
void add_vehicles(Study study, const std::string& stage, const std::vector<KeptVehicle>& vehicles) {
  const bool check = study == Study::kCheck;
  const std::size_t queries = check ? 4 : study == Study::kQuick ? 10 : 50;
  for (const KeptVehicle& kept : vehicles)
    for (const char* kind : {"convex", "star"})
      for (const int fill : {15, 30, 45}) {
        if (check && (fill != 15 || kind != std::string_view("convex"))) continue;
        if (study == Study::kQuick && fill == 45) continue;
        const std::string world = clutter_name(kind, check ? 30 : 100, 10, fill);
        add_benchmark(stage + "/" + std::string(kept.name) + "/" + kind + "_f" + std::to_string(fill),
                      [&kept, world, queries](benchmark::State& state) { time_vehicle(state, kept, world, queries); })
            ->Iterations(1)
            ->Repetitions(1);
      }
}

void add(Study study) {
  add_vehicles(study, "Quality", real_vehicles());
  if (study == Study::kQuick) return;
  add_vehicles(study, "QualityBody", vehicles_of_other_outlines());
  const std::size_t queries = study == Study::kFull ? 50 : 20;
  const std::size_t ablated = study == Study::kFull ? 20 : 1;  // by eight variants
  const std::size_t compared = study == Study::kCheck ? 10 : 50;
  const std::size_t obstacles = study == Study::kCheck ? 32 : 316;
  const std::pair<const char*, Heuristic> heuristics[] = {{"travel_time", Heuristic::kTravelTime},
                                                          {"paper_distance", Heuristic::kPaperDistance},
                                                          {"dijkstra", Heuristic::kDijkstra}};
  const std::string name = clutter_name("convex", obstacles, 10, 30);
  for (const auto& [label, heuristic] : heuristics)
    add_benchmark("Search/" + std::string(label) + "/n" + std::to_string(obstacles),
                  [name, queries, heuristic = heuristic](benchmark::State& state) {
                    time_quality(state, name, queries, heuristic);
                  });
  for (const char* kind : {"convex", "star"})
    for (const int fill : {15, 30, 45}) {
      if (study == Study::kCheck && fill != 30) continue;
      const std::string world = clutter_name(kind, study == Study::kCheck ? 30 : 100, 10, fill);
      const std::string label = std::string(kind) + "_f" + std::to_string(fill);
      add_benchmark("Quality/" + label,
                    [world, compared](benchmark::State& state) { time_quality(state, world, compared); });
      const std::vector<Variant> all = variants(shared_world(world));
      for (std::size_t v = 0; v < all.size(); ++v)
        add_benchmark("Ablation/" + label + "/" + all[v].name,
                      [world, v, ablated](benchmark::State& state) { time_variant(state, world, v, ablated); })
            ->Iterations(1)
            ->Repetitions(1);
    }
}

const Suite suite(add);

}  // namespace
}  // namespace arcway::internal::bench::quality_suite

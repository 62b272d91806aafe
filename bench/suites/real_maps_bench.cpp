#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/cpu_clock.h"
#include "bench/quantiles.h"
#include "bench/suites/plans.h"
#include "bench/suites/run_policy.h"
#include "bench/suites/suite.h"
#include "datasets/random_queries.h"
#include "datasets/read_map.h"

// Maps of a city, a coast and a grid of random cells, from the folder that ARCWAY_SHARED_DATA names: what it takes to
// prepare them, and to plan between random poses.
namespace arcway::bench {
namespace {

namespace fs = std::filesystem;

void plan_on(benchmark::State& state, const std::string& file, GraphMode mode, std::size_t queries) {
  const char* folder = std::getenv("ARCWAY_SHARED_DATA");
  if (folder == nullptr || !fs::exists(fs::path(folder) / file)) {
    leave_out(state, "ARCWAY_SHARED_DATA names no folder with " + file);
    return;
  }
  const World world = to_world(read_map(fs::path(folder) / file), file);
  const CpuClock preparing(CpuClock::Of::kProcess);
  const Planner planner = make_planner(world, Vehicle(), {.graph_mode = mode});
  const double prepare_seconds = preparing.seconds();
  const std::vector<PlanRequest> requests =
      random_queries(world, fastest_queries(world), Vehicle(), {.count = queries, .seed = 1});
  std::vector<PlanResult> results;
  std::vector<double> seconds;
  for (auto _ : state) {
    for (const PlanRequest& request : requests) {
      const CpuClock planning(CpuClock::Of::kProcess);
      results.push_back(planner.plan(request));
      seconds.push_back(planning.seconds());
    }
  }
  if (!require(state, are_right(planner, results), "the validator refuses a path, or there is none")) return;
  set_batch(state, queries);
  state.counters["vertices"] = static_cast<double>(world.vertices().size());
  state.counters["prepare_s"] = prepare_seconds;
  state.counters["solved"] = static_cast<double>(std::ranges::count_if(results, &PlanResult::solved));
  state.counters["median_ms"] = 1e3 * quantile(seconds, 0.5);
  state.counters["p99_ms"] = 1e3 * quantile(seconds, 0.99);
}

void add_map(const std::string& name, const std::string& file, GraphMode mode, std::size_t queries) {
  const std::string full = "RealMap/" + name + (mode == GraphMode::kLazy ? "/lazy" : "/prepared");
  add_benchmark(full, [=](benchmark::State& state) { plan_on(state, file, mode, queries); })
      ->Iterations(1)
      ->Repetitions(1);
}

void add(Study study) {
  if (study != Study::kFull) {
    add_map("luxembourg", "city/luxembourg.geojson.gz", GraphMode::kLazy, study == Study::kQuick ? 3 : 1);
    return;
  }
  for (const GraphMode mode : {GraphMode::kEager, GraphMode::kLazy}) {
    add_map("random512-20-0", "movingai/random512-20-0.geojson.gz", mode, 100);
    add_map("luxembourg", "city/luxembourg.geojson.gz", mode, 100);
    add_map("chile", "coast/chile.geojson.gz", mode, 100);
  }
}

const Suite suite(add);

}  // namespace
}  // namespace arcway::bench

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "arcway/datasets/random_queries.h"
#include "arcway/datasets/read_map.h"
#include "bench/cpu_clock.h"
#include "bench/robots.h"
#include "bench/suites/plans.h"
#include "bench/suites/quality.h"
#include "bench/suites/run_policy.h"
#include "bench/suites/suite.h"

// Preparing and planning on maps of a city, a coast and a grid of random cells, from the folder that ARCWAY_SHARED_DATA
// names. Each has a vehicle that suits it. Queries are random poses that a disc can move between.
namespace arcway::internal::bench::real_maps_suite {
namespace {

namespace fs = std::filesystem;

constexpr double kTimeLimit = 10.0;  // time limit of one query [s]

struct RealMap {
  const char* name;
  const char* file;
  Vehicle (*vehicle)();
};
constexpr RealMap kGrid{"random512-20-0", "movingai/random512-20-0.geojson.gz", small_robot};
constexpr RealMap kCity{"luxembourg", "city/luxembourg.geojson.gz", [] { return Vehicle(); }};
constexpr RealMap kCityByCar{"luxembourg_by_car", "city/luxembourg.geojson.gz", town_car};
constexpr RealMap kCoast{"chile", "coast/chile.geojson.gz", boat};

void plan_on(benchmark::State& state, const RealMap& map, GraphMode mode, std::size_t count) {
  const char* folder = std::getenv("ARCWAY_SHARED_DATA");
  if (folder == nullptr || !fs::exists(fs::path(folder) / map.file)) {
    leave_out(state, std::string("ARCWAY_SHARED_DATA names no folder with ") + map.file);
    return;
  }
  const World world = to_world(read_map(fs::path(folder) / map.file), map.file);
  const Vehicle vehicle = map.vehicle();
  const CpuClock preparing(CpuClock::Of::kProcess);
  const Planner planner = make_planner(world, vehicle, {.graph_mode = mode});
  const double prepare_seconds = preparing.seconds();
  const std::vector<PlanRequest> requests =
      random_queries(world, planner.queries(), vehicle, {.count = count, .seed = 1, .passable = true});
  std::vector<PlanResult> results;
  for ([[maybe_unused]] auto _ : state)
    for (const PlanRequest& request : requests)
      results.push_back(plan_by_processor_time(planner, request, {.time = kTimeLimit}));
  if (!require(state, are_right(planner, results), "the validator refuses a path, or there is none")) return;
  set_batch(state, count);
  count_search(state, results);
  count_map(state, planner, prepare_seconds, results);
}

void add_map(const RealMap& map, GraphMode mode, std::size_t count) {
  const std::string name = std::string("RealMap/") + map.name + (mode == GraphMode::kLazy ? "/lazy" : "/prepared");
  add_benchmark(name, [=](benchmark::State& state) { plan_on(state, map, mode, count); })
      ->Iterations(1)
      ->Repetitions(1);
}

void add(Study study) {
  if (study != Study::kFull) {
    add_map(kCity, GraphMode::kLazy, study == Study::kQuick ? 3 : 1);
    return;
  }
  for (const GraphMode mode : {GraphMode::kEager, GraphMode::kLazy})
    for (const RealMap& map : {kGrid, kCity, kCoast}) add_map(map, mode, 100);
  add_map(kCityByCar, GraphMode::kEager, 20);  // its accelerations make searches long
}

const Suite suite(add);

}  // namespace
}  // namespace arcway::internal::bench::real_maps_suite

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "arcway/datasets/catalog.h"
#include "arcway/turning_radii.h"
#include "bench/quantiles.h"
#include "bench/robots.h"
#include "bench/suites/plans.h"
#include "bench/suites/quality.h"
#include "bench/suites/suite.h"
#include "core/motion/speed_profile.h"

// Travel time over the number of radii, for robots whose turns are the faster the wider they are.
namespace arcway::internal::bench::radii_suite {
namespace {

constexpr const char* kWrong = "the validator refuses a path, or there is none";

/// Travel times of a planner's answers, 0 where there is none.
struct Times {
  std::vector<double> first, refined;
};

Times times_of(const std::vector<PlanResult>& results, const Vehicle& vehicle) {
  Times times;
  for (const PlanResult& r : results) {
    times.first.push_back(speed_profile(r.first_path, vehicle).total_time);
    times.refined.push_back(speed_profile(r.path(), vehicle).total_time);
  }
  return times;
}

void count_ratios(benchmark::State& state, const std::string& name, const std::vector<double>& mine,
                  const std::vector<double>& others) {
  std::vector<double> ratios;
  for (std::size_t q = 0; q < mine.size(); ++q)
    if (mine[q] > 0.0 && others[q] > 0.0) ratios.push_back(mine[q] / others[q]);
  if (ratios.empty()) return;
  state.counters[name + "_median"] = median(ratios);
  state.counters[name + "_worst"] = std::ranges::max(ratios);
}

void time_radii(benchmark::State& state, const GentleRobot& robot, const std::string& world_name, std::size_t radii,
                std::size_t queries) {
  static std::map<std::string, std::pair<Times, Times>> references;  // one radius; turns no wider than that
  const World& world = shared_world(world_name);
  const Vehicle vehicle = robot.vehicle();
  const std::vector<PlanRequest> requests = catalog_queries(world_name, queries, 1);
  std::vector<double> all = turning_radii(vehicle, world);
  const auto planned = [&](const Vehicle& driven, const PlannerOptions& options) {
    return times_of(plan_all(make_planner(world, driven, options), requests), vehicle);
  };
  const std::string key = robot.name() + world_name;
  if (!references.contains(key))
    references[key] = {planned(vehicle, {.radii = {all.front()}}), planned(without_faster_turns(vehicle), {})};
  all.resize(std::min(radii, all.size()));
  const Planner planner = make_planner(world, vehicle, {.radii = all});
  std::vector<PlanResult> results;
  for ([[maybe_unused]] auto _ : state) results = plan_all(planner, requests);
  if (!require(state, are_right(planner, results), kWrong)) return;
  set_batch(state, queries);
  count_search(state, results);
  const Times times = times_of(results, vehicle);
  const auto& [one, tightest] = references[key];
  count_ratios(state, "first_over_one", times.first, one.first);
  count_ratios(state, "refined_over_one", times.refined, one.refined);
  count_ratios(state, "refined_over_tightest", times.refined, tightest.refined);
  state.counters["solved"] = static_cast<double>(std::ranges::count_if(results, &PlanResult::solved));
}

void add(Study study) {
  const bool check = study == Study::kCheck;
  for (const GentleRobot& robot : kGentleRobots)
    for (const char* kind : {"convex", "star"})
      for (const int fill : {15, 30}) {
        if (check && (&robot != kGentleRobots || fill == 30)) continue;
        const std::string world = clutter_name(kind, check ? 10 : 100, 10, fill);
        const std::size_t most = turning_radii(robot.vehicle(), shared_world(world)).size();
        for (std::size_t r = 1; r <= (check ? 2 : most); ++r)
          add_benchmark(
              "Radii/" + robot.name() + "/" + kind + "_f" + std::to_string(fill) + "/radii:" + std::to_string(r),
              [&robot, world, r, queries = std::size_t{check ? 5u : 20u}](benchmark::State& state) {
                time_radii(state, robot, world, r, queries);
              })
              ->Iterations(1)
              ->Repetitions(1);
      }
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::radii_suite

#include <cstdint>
#include <string>
#include <vector>

#include "arcway/datasets/catalog.h"
#include "bench/quantiles.h"
#include "bench/robots.h"
#include "bench/suites/plans.h"
#include "bench/suites/quality.h"
#include "bench/suites/suite.h"

// What a body costs that is no rectangle: the same robot with other outlines within the same rectangle, on prepared
// maps. Every query is planned for the rectangle and for the outline in turn.
namespace arcway::internal::bench::bodies_suite {
namespace {

constexpr std::size_t kPlans = 20;

struct Outline {
  const char* name;
  std::vector<Ring>
      rings;  // about F, within the rectangle of the paper's robot: 1.4 m ahead, 0.1 m behind, 0.4 m beside
};

const std::vector<Outline>& outlines() {
  static const std::vector<Outline> all{
      {"hexagon", {{{-0.1, -0.4}, {1.1, -0.4}, {1.4, -0.1}, {1.4, 0.1}, {1.1, 0.4}, {-0.1, 0.4}}}},
      {"octagon",
       {{{0.0, -0.4}, {1.3, -0.4}, {1.4, -0.3}, {1.4, 0.3}, {1.3, 0.4}, {0.0, 0.4}, {-0.1, 0.3}, {-0.1, -0.3}}}},
      {"fork",
       {{{-0.1, -0.4},
         {0.7, -0.4},
         {0.7, -0.25},
         {1.4, -0.25},
         {1.4, -0.1},
         {0.7, -0.1},
         {0.7, 0.1},
         {1.4, 0.1},
         {1.4, 0.25},
         {0.7, 0.25},
         {0.7, 0.4},
         {-0.1, 0.4}}}},
      {"two_parts",
       {{{-0.1, -0.4}, {0.5, -0.4}, {0.5, 0.4}, {-0.1, 0.4}}, {{0.8, -0.3}, {1.4, -0.4}, {1.4, 0.4}, {0.8, 0.3}}}}};
  return all;
}

VehicleParameters robot(std::vector<Ring> rings) {
  VehicleParameters parameters = kGentleRobots[0].vehicle().parameters();
  parameters.footprint = std::move(rings);
  return parameters;
}

void time_body(benchmark::State& state, const Outline& outline, const std::string& world_name) {
  const World& world = shared_world(world_name);
  const Planner rectangle = make_planner(world, Vehicle(robot({})), {});
  const Planner other = make_planner(world, Vehicle(robot(outline.rings)), {});
  const std::vector<PlanRequest> requests = catalog_queries(world_name, kPlans, 1);
  // Asked once, so that no repetition makes the maps that only some queries need.
  const std::vector<PlanResult> of_rectangle = plan_all(rectangle, requests), of_other = plan_all(other, requests);
  if (!require(state, are_right(other, of_other), "the validator refuses a path, or there is none")) return;
  std::vector<double> over, travel;
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < requests.size(); ++i) {
      const double before = plan_by_processor_time(rectangle, requests[i]).statistics.total_seconds;
      const double now = plan_by_processor_time(other, requests[i]).statistics.total_seconds;
      if (of_rectangle[i].solved() && of_other[i].solved() && before > 0.0) over.push_back(now / before);
    }
  }
  for (std::size_t i = 0; i < requests.size(); ++i)
    if (of_rectangle[i].solved() && of_other[i].solved())
      travel.push_back(of_other[i].travel_time / of_rectangle[i].travel_time);
  set_batch(state, 2 * requests.size());
  count_search(state, of_other);
  if (over.empty()) return;
  state.counters["time_over_rectangle"] = median(over);
  state.counters["travel_over_rectangle"] = median(travel);
}

void add(Study study) {
  for (const Outline& outline : outlines()) {
    Series series(study, std::string("PlanBody/") + outline.name, "obstacles",
                  "A* over the part of the graph towards the goal", 1.0);
    series.allow(20.0);
    for (const std::size_t n : sizes(study, {10, 32, 100, 316}, 10, 100))
      series
          .add(static_cast<double>(n),
               [&outline, n](benchmark::State& state) { time_body(state, outline, clutter_name("convex", n, 10, 30)); })
          ->Iterations(1)
          ->Repetitions(study == Study::kCheck ? 1 : 3);
  }
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::bodies_suite

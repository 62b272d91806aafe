#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/catalog.h"
#include "arcway/zone.h"
#include "bench/quantiles.h"
#include "bench/robots.h"
#include "bench/suites/plans.h"
#include "bench/suites/quality.h"
#include "bench/suites/suite.h"

// What speed limits cost: the same map with 20 zones and without. Every query is planned on both in turn.
namespace arcway::internal::bench::zones_suite {
namespace {

constexpr std::size_t kPlans = 20, kZones = 20;
constexpr double kSlower = 0.5;                      // limit of the zones, as a share of the top speed
constexpr double kSmallest = 0.03, kLargest = 0.08;  // radius of a zone, as a share of the map's width
constexpr std::size_t kFewestCorners = 4, kMostCorners = 7;
constexpr std::uint64_t kSeed = 3;

// Regular polygons, anywhere and turned at random.
std::vector<Zone> random_zones(const World& world, double speed) {
  const Box& box = world.box();
  const double width = (box.max - box.min).maxCoeff();
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::uniform_int_distribution<std::size_t> some_corners(kFewestCorners, kMostCorners);
  std::vector<Zone> zones(kZones);
  for (Zone& zone : zones) {
    const double radius = width * std::lerp(kSmallest, kLargest, share(random));
    const Vec2 center(std::lerp(box.min.x(), box.max.x(), share(random)),
                      std::lerp(box.min.y(), box.max.y(), share(random)));
    const double turned = kTwoPi * share(random);
    const std::size_t corners = some_corners(random);
    for (std::size_t k = 0; k < corners; ++k) {
      const double angle = turned + kTwoPi * static_cast<double>(k) / static_cast<double>(corners);
      zone.area.outer.push_back(center + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    zone.rule = SpeedLimit{speed};
  }
  return zones;
}

void time_zones(benchmark::State& state, const Vehicle& vehicle, const std::string& world_name) {
  const World& world = shared_world(world_name);
  const World limited = world.with_zones(random_zones(world, kSlower * vehicle.max_speed()));
  const Planner plain = make_planner(world, vehicle, {}), zoned = make_planner(limited, vehicle, {});
  const std::vector<PlanRequest> requests = catalog_queries(world_name, kPlans, 1);
  // Asked once, so that no repetition makes the maps that only some queries need.
  const std::vector<PlanResult> without = plan_all(plain, requests), with = plan_all(zoned, requests);
  if (!require(state, are_right(plain, without) && are_right(zoned, with),
               "the validator refuses a path, or there is none"))
    return;
  std::vector<double> over, travel, gaps;
  double total_without = 0.0, total_with = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < requests.size(); ++i) {
      const double before = plan_by_processor_time(plain, requests[i]).statistics.total_seconds;
      const double now = plan_by_processor_time(zoned, requests[i]).statistics.total_seconds;
      if (!without[i].solved() || !with[i].solved() || !(before > 0.0)) continue;
      over.push_back(now / before);
      total_without += before;
      total_with += now;
    }
  }
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (!without[i].solved() || !with[i].solved()) continue;
    travel.push_back(with[i].travel_time / without[i].travel_time);
    gaps.push_back(with[i].optimality_gap());
  }
  set_batch(state, 2 * requests.size());
  count_search(state, with);
  if (over.empty()) return;
  state.counters["time_over_no_zones"] = median(over);
  state.counters["total_over_no_zones"] = total_with / total_without;
  state.counters["travel_over_no_zones"] = median(travel);
  state.counters["gap_median"] = median(gaps);
}

struct Robot {
  const char* name;
  Vehicle vehicle;
};

void add(Study study) {
  for (const Robot& robot :
       {Robot{"paper", Vehicle(VehicleParameters{})}, Robot{"gentle", kGentleRobots[0].vehicle()}}) {
    Series series(study, std::string("PlanZones/") + robot.name, "obstacles",
                  "A* over the part of the graph towards the goal", 1.0);
    series.allow(20.0);
    for (const std::size_t n : sizes(study, {100, 316, 1000}, 100, 1000))
      series
          .add(static_cast<double>(n),
               [vehicle = robot.vehicle, n](benchmark::State& state) {
                 time_zones(state, vehicle, clutter_name("convex", n, 10, 15));
               })
          ->Iterations(1)
          ->Repetitions(study == Study::kCheck ? 1 : 3);
  }
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::zones_suite

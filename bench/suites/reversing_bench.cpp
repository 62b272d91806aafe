#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/read_map.h"
#include "bench/suites/plans.h"
#include "bench/suites/quality.h"
#include "bench/suites/suite.h"
#include "bench/suites/work.h"

// Parking, with both gears: bays of one length and less and less room, and the TPCAP cases where the folder that
// ARCWAY_SHARED_DATA names has them.
namespace arcway::internal::bench::reversing_suite {
namespace {

constexpr const char* kWrong = "the validator refuses the path, or there is none";

Vehicle car() {
  return Vehicle({.length = 4.72,
                  .width = 1.942,
                  .wheelbase = 2.8,
                  .max_steering_angle = 0.75,
                  .max_speed = 2.5,
                  .turn_speed = ConstantTurnSpeed{2.0},
                  .max_acceleration = 1.0});
}

Polygon box(double x0, double y0, double x1, double y1) {
  return {{Vec2(x0, y0), Vec2(x1, y0), Vec2(x1, y1), Vec2(x0, y1)}, {}};
}

struct Parking {
  World world;
  PlanRequest request;
};

// A street along x, a wall on its far side, and a bay between two parked cars: `room` more than the car takes, in all.
Parking parallel_bay(double room) {
  constexpr double kCurb = -1.2, kStreet = 5.0;
  const double bay = 4.72 + room;
  return {World({box(-20, kCurb - 0.3, 30, kCurb), box(-6, kCurb, 0, 1.0), box(bay, kCurb, bay + 6, 1.0),
                 box(-20, kStreet + 1.0, 30, kStreet + 1.3)}),
          {.start = {-12, 2.6, 0}, .goal = {0.5 * room + 0.96, -0.1, 0}, .reverse = true}};
}

Parking perpendicular_bay(double room) {
  constexpr double kDepth = 5.2, kLane = 5.5;
  const double bay = 1.942 + room;
  return {World({box(-20, -0.3 - kDepth, 20, -kDepth), box(-12, -kDepth, -0.5 * bay, 0), box(0.5 * bay, -kDepth, 12, 0),
                 box(-20, kLane, 20, kLane + 0.3)}),
          {.start = {-9, 2.6, 0}, .goal = {0, 0.2 - kDepth + 0.96, 0.5 * kPi}, .reverse = true}};
}

Parking tpcap_case(const std::filesystem::path& file) {
  const MapFile map = read_map(file);
  return {to_world(map, file.string()), {.start = *map.start, .goal = *map.goal, .reverse = true}};
}

void time_parking(benchmark::State& state, const Parking& parking) {
  const Planner planner = make_planner(parking.world, car(), {});
  const PlanResult result = planner.plan(parking.request);
  if (!require(state, are_right(planner, {result}), kWrong)) return;
  const LoopWork work;
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(planner.plan(parking.request));
  work.count(state, "query");
  count_search(state, {result});
  state.counters["travel_time_s"] = result.travel_time;
  state.counters["time_over_bound"] = result.travel_time / result.lower_bound;
  state.counters["cusps"] = static_cast<double>(cusps_of(result.path()));
}

void add(Study study) {
  for (const int centimeters : {300, 150, 100, 80}) {
    if (study == Study::kCheck && centimeters < 150) continue;
    const double room = 0.01 * centimeters;
    const std::string at = "/room_cm:" + std::to_string(centimeters);
    add_benchmark("Reversing/parallel" + at,
                  [room](benchmark::State& state) { time_parking(state, parallel_bay(room)); });
  }
  for (const int centimeters : {100, 60, 40}) {
    if (study == Study::kCheck && centimeters < 60) continue;
    const double room = 0.01 * centimeters;
    const std::string at = "/room_cm:" + std::to_string(centimeters);
    add_benchmark("Reversing/perpendicular" + at,
                  [room](benchmark::State& state) { time_parking(state, perpendicular_bay(room)); });
  }
  const char* shared = std::getenv("ARCWAY_SHARED_DATA");
  if (!shared) return;
  for (int number = 1; number <= 19; number += 2) {
    const std::filesystem::path file =
        std::filesystem::path(shared) / "parking" / ("Case" + std::to_string(number) + ".csv");
    if (!std::filesystem::exists(file) || (study == Study::kCheck && number > 1)) continue;
    add_benchmark("Reversing/tpcap_" + std::to_string(number),
                  [file](benchmark::State& state) { time_parking(state, tpcap_case(file)); });
  }
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::reversing_suite

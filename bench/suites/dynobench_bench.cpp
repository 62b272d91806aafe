#include <cmath>
#include <string>
#include <vector>

#include "bench/suites/plans.h"
#include "bench/suites/quality.h"
#include "bench/suites/suite.h"
#include "bench/suites/work.h"

// Problems of dynobench (github.com/quimortiz/dynobench, MIT license, commit 4ddf752), with the best costs stored
// there.
namespace arcway::internal::bench::dynobench_suite {
namespace {

struct Problem {
  std::string name;
  World world;
  Vehicle vehicle;
  PlanRequest request;
  double stored_cost;  // [s]
};

Polygon box(const Vec2& center, const Vec2& size) {
  const Vec2 low = center - 0.5 * size, high = center + 0.5 * size;
  return {{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, {}};
}

// A car that turns about its middle: v from 0.25 to 0.5 m/s, at most 0.5 rad/s. Speeds may jump there. The axles of
// ours must be apart.
Vehicle unicycle1_v1() {
  constexpr double kWheelbase = 1e-6, kSlowest = 0.25, kFastest = 0.5, kTurnRate = 0.5, kAnyAcceleration = 1e6;
  const double tightest = kSlowest / kTurnRate;
  return Vehicle({.length = 0.5,
                  .width = 0.25,
                  .wheelbase = kWheelbase,
                  .max_steering_angle = std::atan(kWheelbase / tightest),
                  .max_speed = kFastest,
                  .turn_speed = TurnSpeedTable{{{tightest, kSlowest}, {kFastest / kTurnRate, kFastest}}},
                  .max_acceleration = kAnyAcceleration,
                  .safety_margin = 1e-6});
}

// There the middle of the body stays within the bounds; here all of it does.
Problem kink_0() {
  const std::vector<Polygon> boxes{box({3.0, 5.2}, {3.0, 1.6}), box({3.9, 4.0}, {1.2, 0.8}),
                                   box({2.1, 3.4}, {1.2, 0.8}), box({3.0, 2.0}, {3.0, 2.0})};
  return {.name = "unicycle1_v1/kink_0",
          .world = World(boxes, box({3.0, 3.0}, {6.0, 6.0}).outer),
          .vehicle = unicycle1_v1(),
          .request = {.start = {0.5, 4.5, 1.55}, .goal = {5.5, 4.0, 1.55}},
          .stored_cost = 21.2};
}

void time_plan(benchmark::State& state, const Problem& problem) {
  const Planner planner = make_planner(problem.world, problem.vehicle, {});
  const PlanResult plan = planner.plan(problem.request);
  if (!require(state, plan.solved(), "no path found")) return;
  if (!require(state, is_valid(Validator(problem.world), problem.vehicle, plan), "the validator refuses the path"))
    return;
  const LoopWork work;
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(planner.plan(problem.request));
  work.count(state, "query");
  count_search(state, {plan});
  state.counters["travel_time_s"] = plan.travel_time;
  state.counters["first_s"] = plan.statistics.first_travel_time;
  state.counters["lower_bound_s"] = plan.lower_bound;
  state.counters["stored_s"] = problem.stored_cost;
  state.counters["over_stored"] = plan.travel_time / problem.stored_cost;
}

void add(Study) {
  for (const Problem& problem : {kink_0()})
    add_benchmark("Dynobench/" + problem.name, [problem](benchmark::State& state) { time_plan(state, problem); });
}

const Suite suite(add);

}  // namespace
}  // namespace arcway::internal::bench::dynobench_suite

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bench/suites/backends.h"
#include "bench/suites/plans.h"
#include "bench/suites/suite.h"
#include "core/alternatives.h"
#include "core/stop_clock.h"
#include "core/stopwatch.h"
#include "core/tour.h"
#include "datasets/random_queries.h"

// How far behind a time limit a plan ends, from map to plan and on a planner that is made already, one thread. A limit
// holds where `worst_of_allowed` is at most 1: then every query ended within 10 % and 5 ms of its limit.
namespace arcway::bench {
namespace {

constexpr double kAllowedShare = 0.1;     // behind the limit, of the limit
constexpr double kAllowedSeconds = 5e-3;  // and beside that
constexpr std::size_t kQueries = 4;       // of each world

enum class Task { kPlan, kReverse, kAlternatives, kTour };
struct TaskName {
  Task task;
  const char* name;
};
constexpr std::array<TaskName, 4> kTasks{{{Task::kPlan, "forwards"},
                                          {Task::kReverse, "both_gears"},
                                          {Task::kAlternatives, "alternatives"},
                                          {Task::kTour, "tour"}}};

struct Robot {
  const char* name;
  double lateral;  // acceleration [m/s^2]; 0: the paper's robot
};
constexpr std::array<Robot, 2> kRobots{{{"paper", 0.0}, {"lateral2", 2.0}}};

Vehicle vehicle_of(const Robot& robot) {
  if (robot.lateral == 0.0) return Vehicle();
  return Vehicle({.turn_speed = LateralAccelerationLimit{robot.lateral}, .max_acceleration = 2.0});
}

std::vector<PlanResult> answers_of(const Planner& planner, Task task, const PlanRequest& request,
                                   const PlanLimits& limits) {
  PlanRequest both = request;
  both.reverse = true;
  const Pose& goal = request.goal;
  const Vec2 middle = 0.5 * (request.start.position() + goal.position());
  switch (task) {
    case Task::kReverse:
      return {planner.plan(both, limits)};
    case Task::kAlternatives:
      return plan_alternatives(planner, request, 3, limits);
    case Task::kTour:
      return {plan_tour(planner,
                        {.start = request.start,
                         .via = {{.position = middle}},
                         .goals = {{.position = goal.position(), .heading = goal.heading}}},
                        limits)
                  .plan};
    case Task::kPlan:
      break;
  }
  return {planner.plan(request, limits)};
}

struct Ended {
  double behind = 0.0;  // its limit [s]
  std::vector<PlanResult> answers;
};

// @param made  the planner; none: to be made within the limit.
Ended ended(const World& world, const Vehicle& vehicle, const Planner* made, Task task, const PlanRequest& request,
            double limit) {
  Ended end;
  const Stopwatch watch;
  const StopClock clock(limit);
  try {
    const SerialExecutor serial;
    const StoppableExecutor executor(serial, clock);
    std::optional<Planner> own;
    if (!made)
      own.emplace(world, vehicle, fastest_queries(world), graph_builders().back().build(world, executor),
                  PlannerOptions{.graph_mode = GraphMode::kLazy}, executor);
    end.answers = answers_of(made ? *made : *own, task, request, {.time = clock.seconds_left()});
  } catch (const Cancelled&) {
  }
  end.behind = watch.seconds() - limit;
  return end;
}

void time_limit(benchmark::State& state, const std::string& name, const Robot& robot, Task task, bool build,
                double limit) {
  const World& world = shared_world(name);
  const Vehicle vehicle = vehicle_of(robot);
  std::optional<Planner> made;
  if (!build) made.emplace(make_planner(world, vehicle, {.graph_mode = GraphMode::kLazy}));
  const std::vector<PlanRequest> requests =
      random_queries(world, fastest_queries(world), vehicle, {.count = kQueries, .min_distance = 0.5});
  const Validator validator(world);
  double worst = 0.0, worst_behind = 0.0;
  std::size_t solved = 0, asked = 0;
  for (auto _ : state) {
    for (const PlanRequest& request : requests) {
      const Ended end = ended(world, vehicle, made ? &*made : nullptr, task, request, limit);
      worst_behind = std::max(worst_behind, end.behind);
      worst = std::max(worst, end.behind / (kAllowedShare * limit + kAllowedSeconds));
      ++asked;
      solved += !end.answers.empty() && end.answers.front().solved() ? 1 : 0;
      state.PauseTiming();
      for (const PlanResult& answer : end.answers)
        if (!require(state, !answer.solved() || is_valid(validator, vehicle, answer), "the validator refuses a path"))
          return;
      state.ResumeTiming();
    }
  }
  set_batch(state, requests.size());
  state.counters["worst_behind_ms"] = 1e3 * worst_behind;
  state.counters["worst_of_allowed"] = worst;
  state.counters["solved_share"] = static_cast<double>(solved) / static_cast<double>(asked);
}

void add(Study study) {
  std::vector<std::string> worlds{clutter_name("convex", 100, 8, 30)};
  if (study != Study::kCheck)
    for (const char* name : {"maze/v1000/s1", "parking/v2000/s1", "corridor/v5000/s1", "adversarial/comb/v4000/s1",
                             "adversarial/contacts/v8000/s1", "city/v20000/s1"})
      worlds.emplace_back(name);
  if (study == Study::kFull) {
    worlds.push_back(clutter_name("star", 10'000, 10, 30));
    worlds.emplace_back("islands/v100000/s1");
  }
  for (const std::string& world : worlds)
    for (const Robot& robot : kRobots)
      for (const auto& [task, task_name] : kTasks)
        for (const bool build : {true, false})
          for (const int milliseconds : {10, 100, 1000}) {
            if (study == Study::kCheck && (milliseconds == 1000 || robot.lateral == 0.0)) continue;
            std::string label = world;
            std::ranges::replace(label, '/', '_');
            add_benchmark("TimeLimit/" + label + "/" + robot.name + "/" + task_name + "/" +
                              (build ? "from_map" : "on_planner") + "/limit_ms:" + std::to_string(milliseconds),
                          [world, robot, task = task, build, milliseconds](benchmark::State& state) {
                            time_limit(state, world, robot, task, build, 1e-3 * milliseconds);
                          })
                ->Iterations(1)
                ->Repetitions(1);
          }
}

const Suite suite(add);

}  // namespace
}  // namespace arcway::bench

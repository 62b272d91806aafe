#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arcway/alternatives.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/datasets/read_map.h"
#include "arcway/tour.h"
#include "bench/robots.h"
#include "bench/suites/backends.h"
#include "bench/suites/plans.h"
#include "bench/suites/run_policy.h"
#include "bench/suites/suite.h"
#include "core/base/stopwatch.h"

// How far behind a time limit a plan ends, on one thread. It is asked from map to plan, of a planner that is made
// already or has just been, and of a map that is prepared for its vehicle. A limit holds where `worst_of_allowed` is at
// most 1: then every query ended within 10 % and 5 ms of its limit. The map of a coast is from the folder that
// ARCWAY_SHARED_DATA names.
namespace arcway::internal::bench::limits_suite {
namespace {

constexpr double kAllowedShare = 0.1;     // allowed overshoot, as a share of the limit
constexpr double kAllowedSeconds = 5e-3;  // allowed overshoot beside that share [s]
constexpr std::size_t kQueries = 4;       // queries of each world; one where only answers are checked
constexpr double kLongest = 20.0;         // time limit of a query that is only checked [s]

enum class Task { kPlan, kReverse, kAlternatives, kTour };
struct TaskName {
  Task task;
  const char* name;
};
constexpr std::array<TaskName, 4> kTasks{{{Task::kPlan, "forwards"},
                                          {Task::kReverse, "both_gears"},
                                          {Task::kAlternatives, "alternatives"},
                                          {Task::kTour, "tour"}}};

// What is made before the time runs.
enum class Made { kNothing, kNewPlanner, kPlanner, kPrepared };
struct MadeName {
  Made made;
  const char* name;
};
constexpr std::array<MadeName, 4> kMade{{{Made::kNothing, "from_map"},
                                         {Made::kNewPlanner, "on_new_planner"},  // which answers its first query
                                         {Made::kPlanner, "on_planner"},
                                         {Made::kPrepared, "on_prepared"}}};

struct Robot {
  const char* name;
  Vehicle (*vehicle)();
};
const Robot kPaper{"paper", [] { return Vehicle(); }};
const Robot kLateral{"lateral2",
                     [] { return Vehicle({.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0}); }};
const Robot kBoat{"boat", boat};

constexpr const char* kCoast = "coast/chile.geojson.gz";  // in the shared folder

// Null if the shared folder does not have the map, which then is left out.
const World* world_of(benchmark::State& state, const std::string& name) {
  if (name != kCoast) return &shared_world(name);
  static std::optional<World> coast;
  const char* folder = std::getenv("ARCWAY_SHARED_DATA");
  const std::filesystem::path file = std::filesystem::path(folder ? folder : "") / name;
  if (folder == nullptr || !std::filesystem::exists(file)) {
    leave_out(state, "ARCWAY_SHARED_DATA names no folder with " + name);
    return nullptr;
  }
  if (!coast) coast = to_world(read_map(file), name);
  return &*coast;
}

struct Query {
  PlanRequest request;
  Vec2 waypoint;  // of a tour
};

// From pose to pose, `count` of them; tours pass the start of the next query.
std::vector<Query> queries_of(const World& world, const Vehicle& vehicle, std::size_t count) {
  const std::vector<PlanRequest> requests =
      random_queries(world, fastest_queries(world), vehicle, {.count = kQueries, .min_distance = 0.5});
  std::vector<Query> queries;
  for (std::size_t i = 0; i < std::min(count, requests.size()); ++i)
    queries.push_back({requests[i], requests[(i + 1) % requests.size()].start.position()});
  return queries;
}

std::vector<PlanResult> answers_of(const Planner& planner, Task task, const Query& query, const PlanLimits& limits) {
  const PlanRequest& request = query.request;
  PlanRequest both = request;
  both.reverse = true;
  const Pose& goal = request.goal;
  switch (task) {
    case Task::kReverse:
      return {planner.plan(both, limits)};
    case Task::kAlternatives:
      return plan_alternatives(planner, request, 3, limits);
    case Task::kTour:
      return {plan_tour(planner,
                        {.start = request.start,
                         .waypoints = {{.position = query.waypoint}},
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

// What is planned on: a map, a vehicle, and a planner for both or null, if it is to be made within the limit.
struct Setup {
  const World& world;
  const Vehicle& vehicle;
  const Planner* made;
};

Ended ended(const Setup& setup, Task task, const Query& query, double limit) {
  Ended end;
  const Stopwatch watch;
  const StopClock clock(limit);
  try {
    const SerialExecutor serial;
    const StoppableExecutor executor(serial, clock);
    std::optional<Planner> own;
    if (!setup.made) own.emplace(make_planner(setup.world, setup.vehicle, {.graph_mode = GraphMode::kLazy}, executor));
    end.answers = answers_of(setup.made ? *setup.made : *own, task, query, {.time = clock.seconds_left()});
  } catch (const Canceled&) {
  }
  end.behind = watch.seconds() - limit;
  return end;
}

struct Case {
  std::string world;
  Robot robot;
  Task task;
  Made made;
  double limit;         // [s]
  std::size_t queries;  // asked
};

void time_limit(benchmark::State& state, const Case& measured) {
  const auto& [name, robot, task, made, limit, asked_queries] = measured;
  const World* const found = world_of(state, name);
  if (found == nullptr) return;
  const World& world = *found;
  const Vehicle vehicle = robot.vehicle();
  const GraphMode mode = made == Made::kPrepared ? GraphMode::kEager : GraphMode::kLazy;
  const Planner planner = make_planner(world, vehicle, {.graph_mode = mode});
  const std::vector<Query> queries = queries_of(world, vehicle, asked_queries);
  const Validator validator(world);
  const auto are_valid = [&](const std::vector<PlanResult>& answers) {
    return std::ranges::all_of(
        answers, [&](const PlanResult& answer) { return !answer.solved() || is_valid(validator, vehicle, answer); });
  };
  const std::string key = name + " " + robot.name + " " + std::to_string(static_cast<int>(task));
  const auto is_right = [&, task = task] {
    std::vector<PlanResult> all;
    for (const Query& query : queries)
      for (PlanResult& answer : answers_of(planner, task, query, {.time = kLongest})) all.push_back(std::move(answer));
    return std::ranges::any_of(all, &PlanResult::solved) && are_valid(all);
  };
  if (!require_once(state, key, is_right, "the validator refuses a path, or there is none")) return;
  double worst = 0.0, worst_behind = 0.0;
  std::size_t solved = 0, asked = 0;
  for ([[maybe_unused]] auto _ : state) {
    for (const Query& query : queries) {
      state.PauseTiming();
      std::optional<Planner> anew;
      if (made == Made::kNewPlanner) anew.emplace(make_planner(world, vehicle, {.graph_mode = mode}));
      state.ResumeTiming();
      const Planner* const used = anew ? &*anew : &planner;
      const Ended end = ended({world, vehicle, made == Made::kNothing ? nullptr : used}, task, query, limit);
      worst_behind = std::max(worst_behind, end.behind);
      worst = std::max(worst, end.behind / (kAllowedShare * limit + kAllowedSeconds));
      ++asked;
      solved += !end.answers.empty() && end.answers.front().solved() ? 1 : 0;
      state.PauseTiming();
      if (!require(state, are_valid(end.answers), "the validator refuses a path")) return;
      state.ResumeTiming();
    }
  }
  set_batch(state, queries.size());
  state.counters["worst_behind_ms"] = 1e3 * worst_behind;
  state.counters["worst_of_allowed"] = worst;
  state.counters["solved_share"] = static_cast<double>(solved) / static_cast<double>(asked);
}

void add_world(Study study, const std::string& world, const Robot& robot) {
  const std::size_t queries = study == Study::kCheck ? 1 : kQueries;
  std::string label = world.substr(0, world.find('.'));
  std::ranges::replace(label, '/', '_');
  for (const auto& [task, task_name] : kTasks)
    for (const auto& [made, made_name] : kMade)
      for (const int milliseconds : {10, 100, 1000}) {
        if (study == Study::kCheck && (milliseconds != 100 || made != Made::kPlanner)) continue;
        add_benchmark("TimeLimit/" + label + "/" + robot.name + "/" + task_name + "/" + made_name +
                          "/limit_ms:" + std::to_string(milliseconds),
                      [world, robot, task = task, made = made, milliseconds, queries](benchmark::State& state) {
                        time_limit(state, {world, robot, task, made, 1e-3 * milliseconds, queries});
                      })
            ->Iterations(1)
            ->Repetitions(1);
      }
}

void add(Study study) {
  const std::string clutter = clutter_name("convex", study == Study::kCheck ? 20 : 100, 8, 30);
  add_world(study, clutter, kLateral);
  if (study == Study::kCheck) return;
  add_world(study, clutter, kPaper);
  add_world(study, kCoast, kBoat);
  for (const std::string& world :
       {std::string("maze/v1000/s1"), std::string("parking/v2000/s1"), std::string("corridor/v5000/s1"),
        std::string("adversarial/comb/v4000/s1"), std::string("adversarial/contacts/v8000/s1"),
        std::string("adversarial/touching/v20000/s1"),  // cells that touch at corners
        std::string("city/v20000/s1"), clutter_name("star", 10'000, 10, 30), std::string("islands/v100000/s1")})
    for (const Robot& robot : {kPaper, kLateral}) add_world(study, world, robot);
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::limits_suite

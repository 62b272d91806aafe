#include <algorithm>
#include <string>
#include <vector>

#include "arcway/datasets/catalog.h"
#include "arcway/datasets/driven_world.h"
#include "bench/cpu_clock.h"
#include "bench/quantiles.h"
#include "bench/suites/plans.h"
#include "bench/suites/suite.h"

// The share solved of worlds in which a path is known: `driven/...` of the catalog. From map to plan, one thread.
namespace arcway::internal::bench::driven_suite {
namespace {

constexpr double kSlower = 1.0 + 1e-9;  // plans that take longer than the drive by more than rounding

struct Answer {
  bool solved = false, proved = false, valid = true;
  double seconds = 0.0;     // processor time from map to plan [s]
  double over_drive = 0.0;  // travel time / the drive's
};

PlanResult plan(const DrivenWorld& driven, const World& world, bool reverse) {
  const Planner planner = make_planner(world, Vehicle(driven.robot), {.graph_mode = GraphMode::kLazy});
  return planner.plan({.start = *driven.map.start, .goal = *driven.map.goal, .reverse = reverse});
}

/// Whether an answer without a path claims that there is none.
bool is_proof(const PlanResult& result) { return !result.solved() && result.certainty == Certainty::kProved; }

Answer answer_for(const DrivenWorld& driven, bool reverse) {
  const World world = to_world(driven.map, "driven");
  const CpuClock clock(CpuClock::Of::kThread);
  const PlanResult result = plan(driven, world, reverse);
  Answer answer{.solved = result.solved(), .seconds = clock.seconds()};
  answer.proved = !answer.solved && is_proof(result);
  if (!answer.solved) return answer;
  answer.over_drive = result.travel_time / plan_of_drive(driven).travel_time;
  answer.valid = is_valid(Validator(world), Vehicle(driven.robot), result);
  return answer;
}

// Numbers of robots, both ends included.
struct Robots {
  std::size_t first, last;
};

std::vector<std::string> names(DrivenKind kind, bool both_gears, int millimeters, const Robots& robots,
                               std::size_t seeds) {
  std::vector<std::string> all;
  for (std::size_t seed = 1; seed <= seeds; ++seed)
    for (std::size_t robot = robots.first; robot <= robots.last; ++robot)
      all.push_back("driven/" + std::string(name_of(kind)) + "/r" + std::to_string(robot) + "/g" +
                    std::to_string(both_gears ? 2 : 1) + "/c" + std::to_string(millimeters) + "/s" +
                    std::to_string(100 * seed + robot));
  return all;
}

void count(benchmark::State& state, const std::vector<Answer>& answers) {
  const auto share = [&](const auto& holds) {
    return static_cast<double>(std::ranges::count_if(answers, holds)) / static_cast<double>(answers.size());
  };
  std::vector<double> seconds;
  for (const Answer& answer : answers) seconds.push_back(answer.seconds);
  state.counters["worlds"] = static_cast<double>(answers.size());
  state.counters["solved_share"] = share([](const Answer& a) { return a.solved; });
  state.counters["slower_share"] = share([](const Answer& a) { return a.over_drive > kSlower; });
  state.counters["cpu_median_s"] = median(seconds);
  state.counters["cpu_worst_s"] = std::ranges::max(seconds);
}

void time_driven(benchmark::State& state, const std::vector<std::string>& worlds, bool reverse) {
  std::vector<DrivenWorld> driven;
  for (const std::string& name : worlds) driven.push_back(*catalog_driven_world(name));
  std::vector<Answer> answers;
  std::string missed;
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    answers.push_back(answer_for(driven[i], reverse));
    if (!require(state, answers.back().valid, worlds[i] + ": the validator refuses the path")) return;
    if (!require(state, !answers.back().proved, worlds[i] + ": said to have no path, but its drive is one")) return;
    if (!answers.back().solved) missed += (missed.empty() ? "missed: " : ", ") + worlds[i];
  }
  state.SetLabel(missed);
  for ([[maybe_unused]] auto _ : state)
    for (const DrivenWorld& world : driven)
      benchmark::DoNotOptimize(plan(world, to_world(world.map, "driven"), reverse));
  set_batch(state, worlds.size());
  count(state, answers);
}

void add(Study study) {
  const Robots rectangles{1, study == Study::kCheck ? 2 : kDrivenRectangles};
  const Robots others{kDrivenRectangles + 1, study == Study::kCheck ? kDrivenRectangles + 2 : driven_robots().size()};
  const std::size_t seeds = study == Study::kFull ? 12 : 1;
  for (const bool reverse : {false, true}) {
    for (const int millimeters : {50, 2}) {
      for (const DrivenKind kind : kDrivenKinds) {
        if (study == Study::kCheck && (millimeters == 2 || kind != DrivenKind::kScattered)) continue;
        for (const bool is_rectangle : {true, false}) {
          const std::vector<std::string> worlds =
              names(kind, reverse, millimeters, is_rectangle ? rectangles : others, seeds);
          add_benchmark("Driven/" + std::string(reverse ? "both_gears/" : "forwards/") + name_of(kind) +
                            (is_rectangle ? "" : "/other_bodies") + "/clearance_mm_" + std::to_string(millimeters),
                        [worlds, reverse](benchmark::State& state) { time_driven(state, worlds, reverse); })
              ->Iterations(1)
              ->Repetitions(1);
        }
      }
    }
  }
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::driven_suite

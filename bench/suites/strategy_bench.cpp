#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "arcway/datasets/catalog.h"
#include "bench/robots.h"
#include "bench/suites/plans.h"
#include "bench/suites/quality.h"
#include "bench/suites/suite.h"
#include "core/planner/strategy.h"
#include "core/refine/moves.h"

// The strategy without each of its rows, and refinement without each of its moves: what is no longer solved, how much
// slower plans get, and how much sooner they are there.
namespace arcway::internal::bench::strategy_suite {
namespace {

/// A set of queries that the rows of one kind matter for.
struct Case {
  const char* name;
  bool has_several_radii;  ///< wider turns are faster for the robot
  bool reverses;
};
constexpr std::size_t kChecked = 12;  // one of this many names is checked, as all run the same code
constexpr Case kCases[] = {{"one radius", false, false}, {"several radii", true, false}, {"both gears", false, true}};

bool may_be_taken(const StrategyRow& row, const Case& c) {
  if (row.when.driving == Driving::kForwards && c.reverses) return false;
  if (row.when.driving == Driving::kBothGears && !c.reverses) return false;
  return row.when.radii != Radii::kSeveral || c.has_several_radii;
}

std::vector<std::string> names_for(const Case& c) {
  std::vector<std::string> names;
  const auto add = [&names](std::string_view name) {
    if (std::ranges::find(names, name) == names.end()) names.emplace_back(name);
  };
  for (const StrategyRow& row : kStrategy)
    if (may_be_taken(row, c)) add(row.name);
  for (const MoveRow& row : kMoves) add(row.name);
  if (!c.reverses) return names;
  for (const GearMoveRow& row : kGearMoves) add(row.name);
  return names;
}

std::vector<PlanRequest> requests_of(const Case& c, const std::string& world, std::size_t queries) {
  std::vector<PlanRequest> requests = catalog_queries(world, queries, 1);
  for (PlanRequest& request : requests) request.reverse = c.reverses;
  return requests;
}

Planner planner_without(const Case& c, const std::string& world, std::vector<std::string> names) {
  PlannerOptions options;
  options.leave_out = std::move(names);
  return make_planner(shared_world(world), c.has_several_radii ? kGentleRobots[1].vehicle() : Vehicle{}, options);
}

const std::vector<PlanResult>& whole_plans(const Case& c, const std::string& world,
                                           const std::vector<PlanRequest>& requests) {
  static std::map<std::pair<std::string, std::string>, std::vector<PlanResult>> plans;
  const auto [found, is_new] = plans.try_emplace({c.name, world});
  if (is_new) found->second = plan_all(planner_without(c, world, {}), requests);
  return found->second;
}

/// @param name  of what is left out; empty: nothing.
void time_without(benchmark::State& state, const Case& c, const std::string& world, std::size_t queries,
                  const std::string& name) {
  const std::vector<PlanRequest> requests = requests_of(c, world, queries);
  const std::vector<PlanResult>& whole = whole_plans(c, world, requests);
  const Planner planner = planner_without(c, world, name.empty() ? std::vector<std::string>{} : std::vector{name});
  std::vector<PlanResult> results;
  for ([[maybe_unused]] auto _ : state) results = plan_all(planner, requests);
  set_batch(state, queries);
  const bool any = std::ranges::any_of(results, &PlanResult::solved);
  if (!require(state, !any || are_right(planner, results), "the validator refuses a path")) return;
  double solved = 0.0, time = 0.0, whole_time = 0.0;
  for (std::size_t q = 0; q < queries; ++q) {
    solved += results[q].solved();
    if (!results[q].solved() || !whole[q].solved()) continue;
    time += results[q].travel_time;
    whole_time += whole[q].travel_time;
  }
  count_search(state, results);
  state.counters["queries"] = static_cast<double>(queries);
  state.counters["solved"] = solved;
  state.counters["slower_percent"] = whole_time > 0.0 ? 100.0 * (time / whole_time - 1.0) : 0.0;
}

void add(Study study) {
  const std::size_t queries = study == Study::kFull ? 30 : 2;
  const std::string world = clutter_name("star", study == Study::kCheck ? 12 : 60, 10, 45);
  for (const Case& c : kCases) {
    const auto add_row = [&](const std::string& label, const std::string& name) {
      add_benchmark(
          "Strategy/" + std::string(c.name) + "/" + label,
          [&c, world, queries, name](benchmark::State& state) { time_without(state, c, world, queries, name); })
          ->Iterations(1)
          ->Repetitions(1);
    };
    add_row("everything", "");
    const std::vector<std::string> names = names_for(c);
    for (std::size_t i = 0; i < names.size(); i += study == Study::kCheck ? kChecked : 1) add_row(names[i], names[i]);
  }
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::strategy_suite

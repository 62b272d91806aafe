#include <algorithm>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "accel/make_queries.h"
#include "accel/wedge/changed_graph.h"
#include "accel/wedge/wedge_graph.h"
#include "bench/cpu_clock.h"
#include "bench/quantiles.h"
#include "bench/suites/corruption.h"
#include "bench/suites/suite.h"
#include "core/graph/feasible_tables.h"
#include "core/planner.h"
#include "core/world_change.h"
#include "datasets/map_file.h"

// A prepared map after some obstacles have left their places and come back a little aside, against preparing it anew:
// queries and all graphs, one thread; or lazily, where it keeps the bitangents that were checked before.
namespace arcway::bench {
namespace {

Planner build(const World& world, const PlannerOptions& options) {
  return {world,   Vehicle(),       make_embree_queries(world), build_reduced_visibility_graph_by_wedges(world),
          options, SerialExecutor()};
}

Planner change(const Planner& before, const World& after, const std::vector<ObstacleId>& moved,
               const PlannerOptions& options) {
  const WorldChange what(before.world(), after, moved);
  VisibilityGraph graph = change_reduced_visibility_graph(before.visibility_graph(), after, what);
  if (corrupting()) graph = corrupted(graph);
  return {before, after, what, make_embree_queries(after), std::move(graph), options, SerialExecutor()};
}

bool same(const Planner& a, const Planner& b) {
  const FeasibleTables x = a.feasible_graph().tables(), y = b.feasible_graph().tables();
  const auto same_bytes = [](const auto& left, const auto& right) {
    return left.size() == right.size() &&
           (left.empty() || std::memcmp(left.data(), right.data(), left.size() * sizeof left[0]) == 0);
  };
  return a.visibility_graph() == b.visibility_graph() && same_bytes(x.interval_starts, y.interval_starts) &&
         same_bytes(x.intervals, y.intervals) && same_bytes(x.link_starts, y.link_starts) &&
         same_bytes(x.links, y.links) && same_bytes(x.link_counts, y.link_counts);
}

void time_change(benchmark::State& state, const std::string& name, std::size_t count, GraphMode mode) {
  const World& world = shared_world(name);
  const Planner before = build(world, {});
  // Spread evenly over the map's file, in which neighbours in space have nothing to do with each other.
  std::vector<ObstacleId> moved;
  for (std::size_t i = 0; i < count; ++i)
    moved.push_back(static_cast<ObstacleId>((2 * i + 1) * world.obstacle_count() / (2 * count)));
  const std::vector<Polygon> obstacles = to_map_file(world).obstacles;
  std::vector<Polygon> added;
  for (const ObstacleId o : moved) {
    added.push_back(obstacles[o]);
    for (Vec2& p : added.back().outer) p += Vec2(0.25, 0.125);
  }
  const auto change_once = [&](const PlannerOptions& options) {
    return change(before, world.changed(moved, added), moved, options);
  };
  const MapFile after = to_map_file(world.changed(moved, added));
  const auto build_once = [&](const PlannerOptions& options) {
    return build(World(after.obstacles, after.bounds), options);
  };
  if (!require(state, same(change_once({}), build_once({})), "graphs differ from those built anew")) return;
  const PlannerOptions options{.graph_mode = mode};
  const auto seconds_of = [](const auto& make) {
    const CpuClock making(CpuClock::Of::kProcess);
    benchmark::DoNotOptimize(make());
    return making.seconds();
  };
  std::vector<double> changes, rebuilds;
  for (auto _ : state) {
    changes.push_back(seconds_of([&] { return change_once(options); }));
    state.PauseTiming();
    rebuilds.push_back(seconds_of([&] { return build_once(options); }));
    state.ResumeTiming();
  }
  state.counters["vertices"] = static_cast<double>(world.vertices().size());
  state.counters["of_rebuild"] = median(changes) / median(rebuilds);
}

void add(Study study) {
  for (const std::size_t n : sizes(study, {30, 1000, 10000}, 30, 1000)) {
    if (study != Study::kCheck && n == 30) continue;
    const std::string name = clutter_name("convex", n, 10, 30);
    for (const auto& [mode, label] : {std::pair(GraphMode::kEager, "eager"), std::pair(GraphMode::kLazy, "lazy")}) {
      Series by_count(study, std::string("Change/") + label + "/n:" + std::to_string(n), "moved",
                      "O(n) and what is near the change", 1.0);
      by_count.allow(30.0);
      for (const std::size_t count : sizes(study, {1, 10, 100}, 1, 100))
        by_count.add(static_cast<double>(count),
                     [name, count, mode = mode](benchmark::State& state) { time_change(state, name, count, mode); });
    }
  }
}

const Suite suite(add);

}  // namespace
}  // namespace arcway::bench

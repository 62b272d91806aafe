#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "accel/backend/make_queries.h"
#include "accel/graphs/changed_graph.h"
#include "arcway/accel/accel_backend.h"
#include "arcway/accel/tangent_cone_graph.h"
#include "arcway/datasets/catalog.h"
#include "arcway/datasets/map_file.h"
#include "arcway/feasible_graph_snapshot.h"
#include "arcway/planner.h"
#include "arcway/world_change.h"
#include "bench/cpu_clock.h"
#include "bench/quantiles.h"
#include "bench/suites/corruption.h"
#include "bench/suites/plans.h"
#include "bench/suites/suite.h"
#include "core/roadmap/finished_feasible_graph.h"

// A prepared map of which some obstacles move a little, against preparing it anew: queries and all graphs, one thread.
// A lazy planner keeps what was checked before, away from the change. It is compared with a new lazy planner, with and
// without some plans.
namespace arcway::internal::bench::accel_change_suite {
namespace {

constexpr std::size_t kPlans = 20;
constexpr std::size_t kFewPlans = 3;  // in front of a change of one obstacle; many take minutes on the largest maps

Planner build(const World& world, const PlannerOptions& options) {
  return {world, Vehicle(),
          backend_of(world, make_embree_queries(world), build_reduced_visibility_graph_by_tangent_cones(world)),
          options};
}

Planner change(const Planner& before, const World& after, const std::vector<ObstacleId>& moved,
               const PlannerOptions& options) {
  const WorldChange what(before.world(), after, moved);
  VisibilityGraph graph = change_reduced_visibility_graph(before.visibility_graph(), after, what);
  if (corrupting()) graph = corrupted(graph);
  return Planner::changed(before, what, backend_of(after, make_embree_queries(after), std::move(graph)), options);
}

bool same(const Planner& a, const Planner& b) {
  const FeasibleGraphSnapshot x = a.feasible_graph().finished()->snapshot(),
                              y = b.feasible_graph().finished()->snapshot();
  const auto same_bytes = [](const auto& left, const auto& right) {
    return left.size() == right.size() &&
           (left.empty() || std::memcmp(left.data(), right.data(), left.size() * sizeof left[0]) == 0);
  };
  return a.visibility_graph() == b.visibility_graph() && same_bytes(x.interval_starts, y.interval_starts) &&
         same_bytes(x.intervals, y.intervals) && same_bytes(x.link_starts, y.link_starts) &&
         same_bytes(x.links, y.links) && same_bytes(x.link_counts, y.link_counts);
}

std::vector<double> times(const std::vector<PlanResult>& results) {
  std::vector<double> seconds;
  seconds.reserve(results.size());
  for (const PlanResult& r : results) seconds.push_back(r.travel_time);
  return seconds;
}

void time_change(benchmark::State& state, const std::string& name, std::size_t count, GraphMode mode) {
  const World& world = shared_world(name);
  const Planner before = build(world, {});
  // Spread evenly over the map's file, in which neighbors in space have nothing to do with each other.
  std::vector<ObstacleId> moved;
  for (std::size_t i = 0; i < count; ++i)
    moved.push_back(static_cast<ObstacleId>((2 * i + 1) * world.obstacle_count() / (2 * count)));
  const std::vector<Polygon> obstacles = to_map_file(world).obstacles;
  std::vector<Polygon> added;
  for (const ObstacleId o : moved) {
    added.push_back(obstacles[o]);
    for (Vec2& p : added.back().outer) p += Vec2(0.25, 0.125);
  }
  const PlannerOptions options{.graph_mode = mode};
  const MapFile after = to_map_file(world.changed(moved, added));
  const auto change_once = [&](const PlannerOptions& o) {
    return change(before, world.changed(moved, added), moved, o);
  };
  const auto build_once = [&](const PlannerOptions& o) { return build(World(after.obstacles, after.bounds), o); };
  const std::vector<PlanRequest> requests = catalog_queries(name, kPlans, 1);
  const auto right = [&] {
    const Planner anew = build_once({});
    return same(change_once({}), anew) &&
           times(plan_all(change_once(options), requests)) == times(plan_all(anew, requests));
  };
  const std::string key =
      "Change/" + name + "/" + std::to_string(count) + (mode == GraphMode::kLazy ? "/lazy" : "/eager");
  if (!require_once(state, key, right, "graphs or plans differ from those built anew")) return;
  const auto seconds_of = [](const auto& make) {
    const CpuClock making(CpuClock::Of::kProcess);
    benchmark::DoNotOptimize(make());
    return making.seconds();
  };
  std::vector<double> changes, rebuilds, lazy_changes, lazy_rebuilds;
  for ([[maybe_unused]] auto _ : state) {
    changes.push_back(seconds_of([&] { return change_once(options); }));
    state.PauseTiming();
    rebuilds.push_back(seconds_of([&] { return build_once({}); }));
    if (mode == GraphMode::kLazy) {
      lazy_changes.push_back(seconds_of([&] { return plan_all(change_once(options), requests); }));
      lazy_rebuilds.push_back(seconds_of([&] { return plan_all(build_once(options), requests); }));
    }
    state.ResumeTiming();
  }
  state.counters["vertices"] = static_cast<double>(world.vertices().size());
  state.counters["of_rebuild"] = median(changes) / median(rebuilds);
  if (mode == GraphMode::kLazy) state.counters["of_lazy_with_plans"] = median(lazy_changes) / median(lazy_rebuilds);
}

// One obstacle moves, and a lazy planner that has planned before changes with it: Planner::with_obstacles.
void time_one_moved(benchmark::State& state, const std::string& name) {
  const World& world = shared_world(name);
  const std::vector<PlanRequest> requests = catalog_queries(name, kFewPlans, 1);
  const Planner before(world, Vehicle(), accel_backend(world, kSerialExecutor));
  static_cast<void>(plan_all(before, requests));
  const ObstacleKey moved = world.obstacle_count() / 2;
  MapFile after = to_map_file(world);
  std::vector<Polygon> added{after.obstacles[moved]};
  for (Vec2& p : added[0].outer) p += Vec2(0.25, 0.125);
  after.obstacles[moved] = added[0];
  const auto right = [&] {
    const World anew(after.obstacles, after.bounds);
    std::vector<double> changed = times(plan_all(before.with_obstacles({&moved, 1}, added), requests));
    if (corrupting()) changed.back() += 1.0;
    return changed == times(plan_all(Planner(anew, Vehicle(), accel_backend(anew, kSerialExecutor)), requests));
  };
  if (!require_once(state, "OneMoved/" + name, right, "plans differ from those of a planner built anew")) return;
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(before.with_obstacles({&moved, 1}, added));
  state.counters["vertices"] = static_cast<double>(world.vertices().size());
}

void add(Study study) {
  Series one_moved(study, "Change/one", "obstacles", "what is near the change", 0.2);
  one_moved.allow(600.0);
  for (const std::size_t n : sizes(study, {30, 157, 1000, 10000, 100000}, 30, 1000)) {
    if (study != Study::kCheck && n == 30) continue;
    one_moved.add(static_cast<double>(n),
                  [name = clutter_name("convex", n, 10, 30)](benchmark::State& state) { time_one_moved(state, name); });
  }
  for (const std::size_t n : sizes(study, {30, 1000, 10000}, 30, 1000)) {
    if (study != Study::kCheck && n == 30) continue;
    const std::string name = clutter_name("convex", n, 10, 30);
    for (const auto& [mode, label] : {std::pair(GraphMode::kEager, "eager"), std::pair(GraphMode::kLazy, "lazy")}) {
      Series by_count(study, std::string("Change/") + label + "/n:" + std::to_string(n), "moved",
                      "O(n) and what is near the change", 0.3);
      by_count.allow(60.0);
      for (const std::size_t count : sizes(study, {1, 10, 100}, 1, 100))
        by_count.add(static_cast<double>(count),
                     [name, count, mode = mode](benchmark::State& state) { time_change(state, name, count, mode); });
    }
  }
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::accel_change_suite

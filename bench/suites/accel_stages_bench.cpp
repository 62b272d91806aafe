#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "accel/triangulation/free_space_sweep.h"
#include "accel/triangulation/planar_map.h"
#include "accel/triangulation/short_diagonals.h"
#include "accel/wedge/edge_list.h"
#include "accel/wedge/edge_walks.h"
#include "accel/wedge/sight_map.h"
#include "bench/suites/backends.h"
#include "bench/suites/corruption.h"
#include "bench/suites/graph_check.h"
#include "bench/suites/suite.h"

// The wedge builder's stages one by one, over the size of the map: each begins with what the one before it left.
namespace arcway::bench {
namespace {

std::vector<EdgeList> walk_all(const SightMap& map, const Executor& executor) {
  return walk_right(map, 0, map.nodes().size(), executor);
}

bool is_right(benchmark::State& state, const World& world, const std::string& name, const Executor& executor) {
  const auto right = [&] {
    const SightMap map(world, executor, Diagonals::kLong);
    const VisibilityGraph graph = graph_of(world.vertices().size(), walk_all(map, executor), executor);
    return is_reduced_graph(world, corrupting() ? corrupted(graph) : graph);
  };
  return require_once(state, "WedgeStages/" + name, right, "edges differ from the reference");
}

using Stage = std::function<void(benchmark::State&, const World&, const Executor&)>;

void sort_vertices(benchmark::State& state, const World& world, const Executor& /*executor*/) {
  PlanarMap map;
  for (auto _ : state) benchmark::DoNotOptimize(make_plain_map(world, map));
}

void sweep(benchmark::State& state, const World& world, const Executor& /*executor*/) {
  PlanarMap map;
  make_plain_map(world, map);
  for (auto _ : state) benchmark::DoNotOptimize(triangulate_free_space(map));
}

void flip(benchmark::State& state, const World& world, const Executor& executor) {
  PlanarMap map;
  make_plain_map(world, map);
  const Triangulation before = triangulate_free_space(map)->triangulation;
  for (auto _ : state) {
    state.PauseTiming();
    Triangulation triangulation = before;
    state.ResumeTiming();
    shorten_diagonals(map.sites, triangulation, Diagonals::kLong, executor);
    benchmark::DoNotOptimize(triangulation);
  }
}

void make_sight_map(benchmark::State& state, const World& world, const Executor& executor) {
  for (auto _ : state) benchmark::DoNotOptimize(SightMap(world, executor, Diagonals::kLong));
}

void walk(benchmark::State& state, const World& world, const Executor& executor) {
  const SightMap map(world, executor, Diagonals::kLong);
  for (auto _ : state) benchmark::DoNotOptimize(walk_all(map, executor));
}

void gather_rows(benchmark::State& state, const World& world, const Executor& executor) {
  const SightMap map(world, executor, Diagonals::kLong);
  const std::vector<EdgeList> parts = walk_all(map, executor);
  for (auto _ : state) benchmark::DoNotOptimize(graph_of(world.vertices().size(), parts, executor));
}

void run(benchmark::State& state, const std::string& name, std::size_t threads, const Stage& stage) {
  const World& world = shared_world(name);
  const std::unique_ptr<Executor> executor = make_executor(threads);
  if (is_right(state, world, name, *executor)) stage(state, world, *executor);
}

void add_series(Study study, const char* stage_name, std::size_t threads, const Stage& stage) {
  Series series(study, std::string("WedgeStages/") + stage_name + "/threads:" + std::to_string(threads), "obstacles",
                "O(n log n)", 1.1);
  const auto obstacles = study == Study::kCheck ? std::vector<std::size_t>{100}
                                                : sizes(study, {1000, 3162, 10000, 31623, 100000}, 0, 10000);
  for (const std::size_t n : obstacles)
    series.add(static_cast<double>(n),
               [=](benchmark::State& state) { run(state, clutter_name("convex", n, 10, 30), threads, stage); });
}

// Walks among 1,000 obstacles that have more and more vertices each.
void add_walks_by_vertices(Study study) {
  const std::size_t obstacles = study == Study::kCheck ? 20 : 1000;
  Series series(study, "WedgeStages/walks/n:" + std::to_string(obstacles), "vertices_of_each",
                "O(m): what is seen of other obstacles", 1.0);
  for (const std::size_t m : sizes(study, {4, 8, 16, 32, 64, 128, 256}, 16, 256))
    series.add(static_cast<double>(m),
               [=](benchmark::State& state) { run(state, clutter_name("convex", obstacles, m, 30), 1, walk); });
}

void add(Study study) {
  add_series(study, "sorting", 1, sort_vertices);
  add_series(study, "sweep", 1, sweep);
  for (const std::size_t threads : thread_counts()) {
    add_series(study, "flips", threads, flip);
    add_series(study, "sight_map", threads, make_sight_map);
    add_series(study, "walks", threads, walk);
    add_series(study, "rows", threads, gather_rows);
  }
  add_walks_by_vertices(study);
}

const Suite suite(add);

}  // namespace
}  // namespace arcway::bench

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "accel/base/big_vector.h"
#include "accel/expansion/edge_list.h"
#include "accel/expansion/free_space_triangulation.h"
#include "accel/expansion/sleeves.h"
#include "accel/graphs/cone_edges.h"
#include "accel/triangulation/free_space_sweep.h"
#include "accel/triangulation/planar_map.h"
#include "accel/triangulation/short_diagonals.h"
#include "bench/suites/backends.h"
#include "bench/suites/corruption.h"
#include "bench/suites/graph_check.h"
#include "bench/suites/suite.h"

// The tangent-cone builder's stages one by one, over the size of the map. Each stage begins with the result of the one
// before it.
//
// The processor's branch prediction would learn a small world that is repeated, and its caches would hold it, so that
// larger worlds seemed to cost more. Hence different worlds take turns: at every size as many vertices in all as the
// largest world has.
namespace arcway::internal::bench::accel_stages_suite {
namespace {

using Worlds = std::vector<const World*>;

// Sleeves are included, as only the expansion needs them.
std::vector<EdgeList> expand_all(const World& world, const FreeSpaceTriangulation& triangulation,
                                 const Executor& executor) {
  const Sleeves sleeves = worthwhile_sleeves(world, triangulation, executor);
  return cone_edges({triangulation, sleeves, LongFans()}, {0, triangulation.nodes().size()}, executor);
}

bool is_right(benchmark::State& state, const World& world, const std::string& name, std::size_t threads,
              const Executor& executor) {
  const auto right = [&] {
    const FreeSpaceTriangulation triangulation(world, executor, Diagonals::kLong);
    const VisibilityGraph graph =
        graph_of(world.vertices().size(), expand_all(world, triangulation, executor), executor);
    return is_reduced_graph(world, corrupting() ? corrupted(graph) : graph);
  };
  return require_once(state, "TangentConeStages/" + name + "/" + std::to_string(threads), right,
                      "edges differ from the reference");
}

/// Input of a stage, made for each world.
template <class Make>
auto make_of_each(const Worlds& worlds, const Make& make) {
  std::vector<decltype(make(*worlds[0]))> made;
  made.reserve(worlds.size());
  for (const World* world : worlds) made.push_back(make(*world));
  return made;
}

template <class Item, class Run>
void time_in_turn(benchmark::State& state, const std::vector<Item>& items, const Run& run) {
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(run(items[next]));
    next = (next + 1) % items.size();
  }
}

using Stage = std::function<void(benchmark::State&, const Worlds&, const Executor&)>;

PlanarMap uncut_map(const World& world) {
  PlanarMap map;
  make_uncut_map(world, map);
  return map;
}

void sort_vertices(benchmark::State& state, const Worlds& worlds, const Executor& /*executor*/) {
  PlanarMap map;
  time_in_turn(state, worlds, [&](const World* world) { return make_uncut_map(*world, map); });
}

void sweep(benchmark::State& state, const Worlds& worlds, const Executor& /*executor*/) {
  time_in_turn(state, make_of_each(worlds, uncut_map),
               [](const PlanarMap& map) { return triangulate_free_space(map, SerialExecutor()); });
}

void flip(benchmark::State& state, const Worlds& worlds, const Executor& executor) {
  struct Swept {
    BigVector<Vec2> points;
    Triangulation triangulation;
  };
  const auto swept = [](const World& world) {
    const PlanarMap map = uncut_map(world);
    return Swept{map.points, triangulate_free_space(map, SerialExecutor())->triangulation};
  };
  time_in_turn(state, make_of_each(worlds, swept), [&](const Swept& before) {
    state.PauseTiming();
    Triangulation triangulation = before.triangulation;
    state.ResumeTiming();
    shorten_diagonals(before.points, triangulation, Diagonals::kLong, executor);
    return triangulation;
  });
}

void lay_out(benchmark::State& state, const Worlds& worlds, const Executor& executor) {
  time_in_turn(state, worlds,
               [&](const World* world) { return FreeSpaceTriangulation(*world, executor, Diagonals::kLong); });
}

void expand(benchmark::State& state, const Worlds& worlds, const Executor& executor) {
  struct Triangulated {
    const World* world;
    FreeSpaceTriangulation triangulation;
  };
  const auto triangulated = [&](const World& world) {
    return Triangulated{&world, FreeSpaceTriangulation(world, executor, Diagonals::kLong)};
  };
  time_in_turn(state, make_of_each(worlds, triangulated),
               [&](const Triangulated& before) { return expand_all(*before.world, before.triangulation, executor); });
}

void gather_rows(benchmark::State& state, const Worlds& worlds, const Executor& executor) {
  struct Expanded {
    std::size_t vertices;
    std::vector<EdgeList> parts;
  };
  const auto expanded = [&](const World& world) {
    return Expanded{world.vertices().size(),
                    expand_all(world, FreeSpaceTriangulation(world, executor, Diagonals::kLong), executor)};
  };
  time_in_turn(state, make_of_each(worlds, expanded),
               [&](const Expanded& before) { return graph_of(before.vertices, before.parts, executor); });
}

struct Clutter {
  std::size_t obstacles, vertices;  // vertices of each
};

// Runs a stage on up to `most_worlds` worlds in turn, at most one an iteration.
void run(benchmark::State& state, Clutter clutter, std::size_t most_worlds, std::size_t threads, const Stage& stage) {
  const std::size_t count = std::min(most_worlds, static_cast<std::size_t>(state.max_iterations));
  const std::unique_ptr<Executor> executor = make_executor(threads);
  Worlds worlds;
  for (std::size_t seed = 1; seed <= count; ++seed) {
    const std::string name = clutter_name("convex", clutter.obstacles, clutter.vertices, 30, seed);
    worlds.push_back(&shared_world(name));
    if (!is_right(state, *worlds.back(), name, threads, *executor)) return;
  }
  stage(state, worlds, *executor);
}

void add_series(Study study, const char* stage_name, std::size_t threads, const Stage& stage) {
  Series series(study, std::string("TangentConeStages/") + stage_name + "/threads:" + std::to_string(threads),
                "obstacles", "O(n log n)", 1.1);
  const auto obstacles = study == Study::kCheck ? std::vector<std::size_t>{100}
                                                : sizes(study, {1000, 3162, 10000, 31623, 100000}, 0, 10000);
  for (const std::size_t n : obstacles)
    series.add(static_cast<double>(n), [=, worlds = obstacles.back() / n](benchmark::State& state) {
      run(state, {n, 10}, worlds, threads, stage);
    });
}

// The expansion among 1,000 obstacles, over the vertices of each.
void add_expansion_by_vertices(Study study) {
  const std::size_t obstacles = study == Study::kCheck ? 20 : 1000;
  Series series(study, "TangentConeStages/expansion/n:" + std::to_string(obstacles), "vertices_of_each",
                "O(m): what is seen of other obstacles", 1.0);
  const auto vertices = sizes(study, {4, 8, 16, 32, 64, 128, 256}, 16, 256);
  for (const std::size_t m : vertices)
    series.add(static_cast<double>(m), [=, worlds = vertices.back() / m](benchmark::State& state) {
      run(state, {obstacles, m}, worlds, 1, expand);
    });
}

void add(Study study) {
  add_series(study, "sorting", 1, sort_vertices);
  add_series(study, "sweep", 1, sweep);
  for (const std::size_t threads : thread_counts()) {
    add_series(study, "flips", threads, flip);
    add_series(study, "layout", threads, lay_out);
    add_series(study, "expansion", threads, expand);
    add_series(study, "rows", threads, gather_rows);
  }
  add_expansion_by_vertices(study);
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::accel_stages_suite

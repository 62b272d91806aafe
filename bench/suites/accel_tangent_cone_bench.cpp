#include <memory>
#include <string>

#include "arcway/accel/tangent_cone_graph.h"
#include "bench/suites/backends.h"
#include "bench/suites/corruption.h"
#include "bench/suites/graph_check.h"
#include "bench/suites/suite.h"

// The tangent-cone builder's time over threads, vertices of each obstacle, and the shape of the map.
namespace arcway::internal::bench::accel_tangent_cone_suite {
namespace {

bool is_right(benchmark::State& state, const std::string& name, std::size_t threads, const VisibilityGraph& graph) {
  const auto right = [&] { return is_reduced_graph(shared_world(name), corrupting() ? corrupted(graph) : graph); };
  return require_once(state, "TangentConeGraph/" + name + "/" + std::to_string(threads), right,
                      "edges differ from the reference");
}

void build(benchmark::State& state, const std::string& name, std::size_t threads) {
  const World& world = shared_world(name);
  const std::unique_ptr<Executor> executor = make_executor(threads);
  TangentConeStatistics statistics;
  VisibilityGraph graph = build_reduced_visibility_graph_by_tangent_cones(world, *executor, &statistics);
  if (!is_right(state, name, threads, graph)) return;
  for ([[maybe_unused]] auto _ : state) graph = build_reduced_visibility_graph_by_tangent_cones(world, *executor);
  const auto steps = static_cast<double>(statistics.steps);
  state.counters["vertices"] = static_cast<double>(world.vertices().size());
  state.counters["edges"] = static_cast<double>(graph.edge_count());
  state.counters["steps_per_vertex"] = steps / static_cast<double>(world.vertices().size());
  state.counters["steps_per_edge"] = steps / static_cast<double>(graph.edge_count());
  state.counters["invalid_regions"] = static_cast<double>(statistics.invalid_regions);
}

void add(Study study) {
  for (const std::size_t threads : thread_counts()) {
    const std::string suffix = "/threads:" + std::to_string(threads);
    for (const char* kind : {"convex", "star", "mixed"}) {
      Series by_vertices(study, std::string("TangentConeGraph/") + kind + suffix, "obstacles", "O(n log n + steps)",
                         1.1);
      for (const std::size_t n : sizes(study, {10, 100, 1000, 3162, 10000, 31623, 100000}, 100, 10000))
        by_vertices.add(static_cast<double>(n),
                        [=](benchmark::State& state) { build(state, clutter_name(kind, n, 10, 30), threads); });
    }
  }
  const std::size_t obstacles = study == Study::kCheck ? 20 : 1000;
  Series by_each(study, "TangentConeGraph/convex_of/obstacles:" + std::to_string(obstacles), "vertices_of_each",
                 "O(m): what is seen of other obstacles", 1.0);
  for (const std::size_t m : sizes(study, {4, 8, 16, 32, 64, 128, 256}, 16, 256))
    by_each.add(static_cast<double>(m),
                [=](benchmark::State& state) { build(state, clutter_name("convex", obstacles, m, 30), 1); });

  // Worlds with long fans, and those in which World sweeps.
  for (const char* kind : {"saw", "spikes", "rings"}) {
    Series by_size(study, std::string("TangentConeGraph/adversarial/") + kind, "vertices", "O(n log n)", 1.1);
    for (const std::size_t n : sizes(study, {400, 4000, 12649, 40000, 126491, 400000}, 400, 40000))
      by_size.add(static_cast<double>(n), [=](benchmark::State& state) {
        build(state, std::string("adversarial/") + kind + "/v" + std::to_string(n) + "/s1", 1);
      });
  }

  const std::string size = study == Study::kCheck ? "v400" : "v100000";
  const std::size_t cells = study == Study::kCheck ? 40 : 10000;
  std::vector<std::string> shapes = {clutter_name("convex", cells, 10, 2), clutter_name("convex", cells, 10, 50)};
  for (const char* family : {"corridor", "city", "coastline", "islands", "maze", "rooms", "warehouse",
                             "adversarial/shared", "adversarial/contacts", "adversarial/collinear",
                             "adversarial/nested", "adversarial/overlapping", "adversarial/holes"})
    shapes.push_back(std::string(family) + "/" + size + "/s1");
  for (const std::string& shape : shapes)
    add_benchmark("TangentConeGraph/shape/" + shape, [=](benchmark::State& state) { build(state, shape, 1); });
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::accel_tangent_cone_suite

#include <memory>
#include <string>

#include "bench/suites/backends.h"
#include "bench/suites/graph_check.h"
#include "bench/suites/suite.h"
#include "core/graph/visibility_graph.h"

namespace arcway::bench {
namespace {

void count_graph(benchmark::State& state, const World& world, const VisibilityGraph& graph) {
  const auto vertices = static_cast<double>(world.vertices().size());
  state.counters["vertices"] = vertices;
  state.counters["edges"] = static_cast<double>(graph.edge_count());
  state.counters["edges_per_vertex"] = static_cast<double>(graph.edge_count()) / vertices;
}

void build(benchmark::State& state, const GraphBuilder& builder, const std::string& world_name, std::size_t threads) {
  const World& world = shared_world(world_name);
  const std::unique_ptr<Executor> executor = make_executor(threads);
  VisibilityGraph graph = builder.graph(world, *executor);
  const auto right = [&] { return is_reduced_graph(world, graph); };
  if (!require_once(state, "ReducedGraph/" + builder.name + "/" + world_name, right, "edges differ from the reference"))
    return;
  for (auto _ : state) graph = builder.graph(world, *executor);
  count_graph(state, world, graph);
}

void add(Study study) {
  for (const GraphBuilder& builder : graph_builders()) {
    Series by_obstacles(study, "ReducedGraph/" + builder.name, "obstacles", builder.law, builder.exponent);
    for (const std::size_t n : sizes(study, {10, 32, 100, 316, 1000, 3162, 10000, 31623, 100000}, 32, 10000)) {
      by_obstacles.add(static_cast<double>(n), [&builder, n](benchmark::State& state) {
        build(state, builder, clutter_name("convex", n, 10, 30), 1);
      });
    }
  }
}

const Suite suite(add);

}  // namespace
}  // namespace arcway::bench

#include <algorithm>
#include <memory>
#include <string>

#include "arcway/visibility_graph.h"
#include "bench/suites/allocations.h"
#include "bench/suites/backends.h"
#include "bench/suites/graph_check.h"
#include "bench/suites/suite.h"
#include "bench/suites/work.h"

namespace arcway::internal::bench::reduced_graph_suite {
namespace {

void count_graph(benchmark::State& state, const World& world, const VisibilityGraph& graph) {
  const auto vertices = static_cast<double>(world.vertices().size());
  state.counters["vertices"] = vertices;
  state.counters["edges"] = static_cast<double>(graph.edge_count());
  state.counters["edges_per_vertex"] = static_cast<double>(graph.edge_count()) / vertices;
}

void build(benchmark::State& state, const MeasuredBuilder& builder, const std::string& world_name,
           std::size_t threads) {
  const World& world = shared_world(world_name);
  const std::unique_ptr<Executor> executor = make_executor(threads);
  reset_heap_peak();
  const HeapUse before = heap_use();
  VisibilityGraph graph = builder.graph(world, *executor);
  const HeapUse after = heap_use();
  const auto right = [&] { return is_reduced_graph(world, graph); };
  const std::string key = "ReducedGraph/" + builder.name + "/" + world_name + "/" + std::to_string(threads);
  if (!require_once(state, key, right, "edges differ from the reference")) return;
  const LoopWork work;
  for ([[maybe_unused]] auto _ : state) graph = builder.graph(world, *executor);
  if (threads == 1) work.count(state, "graph");  // several threads share the work out as they come
  count_graph(state, world, graph);
  const auto vertices = static_cast<double>(world.vertices().size());
  state.counters["bytes_per_vertex"] = static_cast<double>(after.live_bytes - before.live_bytes) / vertices;
  state.counters["peak_bytes_per_vertex"] = static_cast<double>(after.peak_bytes - before.live_bytes) / vertices;
}

void add_full_graph(Study study) {
  if (study == Study::kQuick) return;
  for (const MeasuredBuilder& builder : full_graph_builders()) {
    Series series(study, "FullGraph/" + builder.name, "obstacles", builder.law, builder.exponent);
    const std::size_t largest = builder.exponent > 2.0 ? 100 : 10000;
    for (const std::size_t n :
         sizes(study, {10, 18, 32, 56, 100, 1000, 10000}, 10, std::min<std::size_t>(largest, 1000)))
      if (n <= largest)
        series.add(static_cast<double>(n), [&builder, n](benchmark::State& state) {
          const World& world = shared_world(clutter_name("convex", n, 10, 30));
          const SerialExecutor executor;
          VisibilityGraph graph = builder.graph(world, executor);
          const auto right = [&] { return is_full_graph(world, graph); };
          const std::string key = "FullGraph/" + builder.name + std::to_string(n);
          if (!require_once(state, key, right, "edges differ from the reference")) return;
          for ([[maybe_unused]] auto _ : state) graph = builder.graph(world, executor);
          count_graph(state, world, graph);
        });
  }
}

void add(Study study) {
  add_full_graph(study);
  for (const MeasuredBuilder& builder : graph_builders()) {
    const std::string stage = "ReducedGraph/" + builder.name;
    const auto add_size = [&](Series& series, std::size_t size, const std::string& world, std::size_t threads = 1) {
      series.add(static_cast<double>(size),
                 [&builder, world, threads](benchmark::State& state) { build(state, builder, world, threads); });
    };
    Series by_obstacles(study, stage, "obstacles", builder.law, builder.exponent);
    for (const std::size_t n : sizes(study, {10, 32, 100, 316, 1000, 3162, 10000, 31623, 100000}, 32, 3162))
      add_size(by_obstacles, n, clutter_name("convex", n, 10, 30));
    if (study != Study::kFull) continue;
    Series by_vertices(study, stage + "/n:100", "vertices", "tangents: hardly in the vertices; pairs: squared", 1.5);
    for (const std::size_t m : sizes(study, {4, 8, 16, 32, 64, 128, 256}, 8, 128))
      add_size(by_vertices, m, clutter_name("convex", 100, m, 30));
    Series by_fill(study, stage + "/n:316", "fill_percent", "falls with what is seen", 0.0);
    for (const std::size_t fill : sizes(study, {5, 10, 20, 30, 40, 50}, 30, 50))
      add_size(by_fill, fill, clutter_name("convex", 316, 10, static_cast<int>(fill)));
    Series by_threads(study, stage + "/n:1000", "threads", "1 / threads", 0.0);
    for (const std::size_t t : thread_counts()) add_size(by_threads, t, clutter_name("convex", 1000, 10, 30), t);
  }
}

const Suite suite(add);

}  // namespace
}  // namespace arcway::internal::bench::reduced_graph_suite

#include <benchmark/benchmark.h>

#include "accel/make_queries.h"
#include "accel/pairwise_graph.h"
#include "accel/parallel.h"
#include "bench/suites/bench_worlds.h"
#include "core/graph/feasible_graph.h"
#include "core/vehicle.h"

// What the pairwise build costs for each tangent pair, and what a second thread brings to it and to the feasible graph.
namespace arcway {
namespace {

bool is_reference_graph(const std::string& world_name, const VisibilityGraph& graph) {
  static std::map<std::string, VisibilityGraph> graphs;
  const World& world = world_of(world_name);
  if (!graphs.contains(world_name))
    graphs[world_name] = build_reduced_visibility_graph(world, *make_embree_queries(world).visibility);
  return graphs[world_name] == graph;
}

std::string name_of_clutter(std::int64_t obstacles, std::int64_t vertices) {
  return "clutter/convex/n" + std::to_string(obstacles) + "/m" + std::to_string(vertices) + "/f30/s7";
}

void PairwiseBuild(benchmark::State& state) {
  const std::string name = name_of_clutter(state.range(0), state.range(1));
  const World& world = world_of(name);
  const TangentSearch search = state.range(2) == 1 ? TangentSearch::kBinary : TangentSearch::kAllPairs;
  const QuerySet queries = make_embree_queries(world);
  const TbbExecutor executor(static_cast<std::size_t>(state.range(3)));
  PairwiseCounts counts;
  VisibilityGraph graph = build_pairwise_visibility_graph(world, *queries.visibility, executor, search, &counts);
  if (!is_reference_graph(name, graph)) return state.SkipWithError("differs from core's builder");
  for (auto _ : state) graph = build_pairwise_visibility_graph(world, *queries.visibility, executor, search);
  state.counters["tangent_pairs"] = static_cast<double>(counts.tangent_pairs);
  state.counters["edges"] = static_cast<double>(graph.edge_count());
}

void FeasibleBuild(benchmark::State& state) {
  const World& world = world_of(name_of_clutter(state.range(0), 10));
  const Vehicle vehicle;
  const QuerySet queries = make_embree_queries(world);
  const TbbExecutor executor(static_cast<std::size_t>(state.range(1)));
  const VisibilityGraph graph = build_pairwise_visibility_graph(world, *queries.visibility, executor);
  const std::vector<double> radii = {vehicle.min_turning_radius()};
  std::uint64_t candidates = 0;
  for (auto _ : state) {
    const FeasibleGraph feasible(world, vehicle, graph, queries, radii, executor);
    candidates = feasible.counts().candidates;
  }
  state.counters["candidates"] = static_cast<double>(candidates);
}

// search:1 by binary search, 0 by trying all pairs.
BENCHMARK(PairwiseBuild)
    ->ArgNames({"obstacles", "vertices", "search", "threads"})
    ->ArgsProduct({{1000}, {10}, {1, 0}, {1, 2}})
    ->ArgsProduct({{300}, {50}, {1, 0}, {1}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK(FeasibleBuild)
    ->ArgNames({"obstacles", "threads"})
    ->ArgsProduct({{1000}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace arcway

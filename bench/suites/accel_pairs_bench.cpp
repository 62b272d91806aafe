#include <memory>
#include <string>
#include <tuple>

#include "accel/backend/make_queries.h"
#include "accel/graphs/pairwise_graph.h"
#include "bench/suites/backends.h"
#include "bench/suites/corruption.h"
#include "bench/suites/graph_check.h"
#include "bench/suites/suite.h"

// The pairwise build. It measures the cost of a tangent pair, tangents by binary search against trying all pairs of
// vertices, and the speedup by a second thread. The queries are made beforehand.
namespace arcway::internal::bench::accel_pairs_suite {
namespace {

struct Case {
  std::size_t obstacles, vertices;
  TangentSearch search;
  std::size_t threads;
};

void build(benchmark::State& state, const Case& c) {
  const std::string world_name = clutter_name("convex", c.obstacles, c.vertices, 30);
  const World& world = shared_world(world_name);
  const QuerySet queries = make_embree_queries(world);
  const std::unique_ptr<Executor> executor = make_executor(c.threads);
  PairwiseCounts counts;
  const auto build_once = [&] {
    return build_pairwise_visibility_graph(world, *queries.visibility, *executor, c.search, &counts);
  };
  VisibilityGraph graph = build_once();
  if (corrupting()) graph = corrupted(graph);
  const auto right = [&] { return is_reduced_graph(world, graph); };
  const std::string key = "Pairwise/" + world_name + std::to_string(static_cast<int>(c.search) * 10 + c.threads);
  if (!require_once(state, key, right, "edges differ from the reference")) return;
  for ([[maybe_unused]] auto _ : state) graph = build_once();
  state.counters["vertex_pairs"] = static_cast<double>(counts.vertex_pairs);
  state.counters["tangent_pairs"] = static_cast<double>(counts.tangent_pairs);
  state.counters["edges"] = static_cast<double>(graph.edge_count());
}

void add(Study study) {
  const std::size_t obstacles = study == Study::kCheck ? 20 : 1000;
  const std::string at = "/n:" + std::to_string(obstacles);
  Series by_threads(study, "PairwiseThreads" + at, "threads", "1 / threads", 0.0);
  for (const std::size_t t : thread_counts())
    by_threads.add(static_cast<double>(t), [=](benchmark::State& state) {
      build(state, {obstacles, 10, TangentSearch::kBinary, t});
    });
  const std::size_t fewer = study == Study::kCheck ? 10 : 200;
  for (const auto& [name, search, exponent] :
       {std::tuple("binary", TangentSearch::kBinary, 0.3), std::tuple("all_pairs", TangentSearch::kAllPairs, 2.0)}) {
    Series by_vertices(study, std::string("Tangents/") + name, "vertices", "O(log m) or O(m^2) a pair of obstacles",
                       exponent);
    for (const std::size_t m : sizes(study, {5, 10, 20, 50, 100}, 10, 100))
      by_vertices.add(static_cast<double>(m), [=, search = search](benchmark::State& state) {
        build(state, {fewer, m, search, 1});
      });
  }
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::accel_pairs_suite

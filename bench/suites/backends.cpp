#include "bench/suites/backends.h"

#include "bench/suites/corruption.h"

#ifdef ARCWAY_BENCH_ACCEL
#include "accel/backend/make_queries.h"
#include "accel/graphs/pairwise_graph.h"
#include "arcway/accel/parallel.h"
#include "arcway/accel/tangent_cone_graph.h"
#include "arcway/accel/visibility_map.h"
#endif

namespace arcway::internal::bench {

QuerySet QueryBackend::queries(const World& world) const {
  return corrupting() ? corrupted(make(world, {})) : make(world, {});
}

VisibilityGraph MeasuredBuilder::graph(const World& world, const Executor& executor) const {
  return corrupting() ? corrupted(build(world, executor)) : build(world, executor);
}

const std::vector<QueryBackend>& query_backends() {
  static const std::vector<QueryBackend> backends = {
      {"reference", [](const World& world, const StopClock& /*clock*/) { return make_reference_queries(world); }},
#ifdef ARCWAY_BENCH_ACCEL
      {"embree",
       [](const World& world, const StopClock& clock) { return make_embree_queries(world, {.clock = clock}); }},
#endif
  };
  return backends;
}

const std::vector<MeasuredBuilder>& graph_builders() {
  static const std::vector<MeasuredBuilder> builders = {
      {"reference",
       [](const World& world, const Executor& executor) {
         return build_reduced_visibility_graph(world, *make_reference_queries(world).visibility, executor);
       },
       "n^2 pairs, the tangent ones against all edges: at most O(n^3)", 2.5},
#ifdef ARCWAY_BENCH_ACCEL
      {"pairwise",
       [](const World& world, const Executor& executor) {
         return build_pairwise_visibility_graph(world, *make_embree_queries(world).visibility, executor);
       },
       "a ray for each tangent pair: O(k^2 log n) for k obstacles", 2.0},
      {"tangent-cones",
       [](const World& world, const Executor& executor) {
         return build_reduced_visibility_graph_by_tangent_cones(world, executor);
       },
       "O(n log n + triangles crossed); Rohnert: O(nk + n log n)", 1.2},
#endif
  };
  return builders;
}

const std::vector<MeasuredBuilder>& full_graph_builders() {
  static const std::vector<MeasuredBuilder> builders = {
      {"reference",
       [](const World& world, const Executor& executor) {
         return build_full_visibility_graph(world, *make_reference_queries(world).visibility, executor);
       },
       "n^2 pairs against n edges: O(n^3)", 3.0},
#ifdef ARCWAY_BENCH_ACCEL
      {"embree",
       [](const World& world, const Executor& executor) {
         return build_full_visibility_graph(world, *make_embree_queries(world).visibility, executor);
       },
       "a ray for each of n^2 pairs", 2.1},
      {"expansion",
       [](const World& world, const Executor& executor) {
         return build_full_visibility_graph_by_expansion(world, executor);
       },
       "O(n log n + triangles seen)", 1.2},
#endif
  };
  return builders;
}

std::unique_ptr<Executor> make_executor(std::size_t threads) {
#ifdef ARCWAY_BENCH_ACCEL
  if (threads > 1) return std::make_unique<TbbExecutor>(threads);
#endif
  (void)threads;
  return std::make_unique<SerialExecutor>();
}

std::vector<std::size_t> thread_counts() {
#ifdef ARCWAY_BENCH_ACCEL
  return {1, 2};
#else
  return {1};
#endif
}

}  // namespace arcway::internal::bench

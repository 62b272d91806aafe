#include "bench/suites/graph_check.h"

#include <algorithm>
#include <vector>

#include "core/query/query_set.h"
#include "datasets/random.h"

#ifdef ARCWAY_BENCH_ACCEL
#include "accel/make_queries.h"
#endif

namespace arcway::bench {
namespace {

constexpr std::size_t kWholeUpTo = 4'000;

QuerySet check_queries(const World& world) {
#ifdef ARCWAY_BENCH_ACCEL
  constexpr std::size_t kBruteForceUpTo = 100'000;
  if (world.vertices().size() > kBruteForceUpTo) return make_embree_queries(world);
#endif
  return make_reference_queries(world);
}

std::vector<VertexId> row_by_definition(const World& world, const VisibilityQuery& visibility, VertexId u) {
  const Vec2& p = world.vertex(u);
  std::vector<VertexId> row;
  for (const VertexId v : world.convex_vertices()) {
    const Vec2& q = world.vertex(v);
    if (v <= u || p == q || !is_tangent(world, u, q) || !is_tangent(world, v, p)) continue;
    const LineSegment line{p, q};
    if (!visibility.visible(line)) continue;
    const auto between = [&](VertexId w) { return on_open_segment(world.vertex(w), line); };
    if (std::ranges::none_of(world.convex_vertices(), between)) row.push_back(v);
  }
  return row;
}

}  // namespace

bool is_reduced_graph(const World& world, const VisibilityGraph& graph, std::size_t rows) {
  if (graph.vertex_count() != world.vertices().size()) return false;
  const QuerySet queries = check_queries(world);
  if (world.vertices().size() <= kWholeUpTo) return graph == build_reduced_visibility_graph(world, *queries.visibility);
  Random random(1);
  for (std::size_t i = 0; i < rows; ++i) {
    const VertexId u = world.convex_vertices()[random.below(world.convex_vertices().size())];
    if (!std::ranges::equal(graph.row(u), row_by_definition(world, *queries.visibility, u))) return false;
  }
  return true;
}

}  // namespace arcway::bench

#include "bench/suites/graph_check.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include "arcway/query_set.h"
#include "core/geometry/predicates.h"
#include "core/roadmap/tangent_edges.h"
#include "datasets/io/random.h"

#ifdef ARCWAY_BENCH_ACCEL
#include "accel/backend/make_queries.h"
#endif

namespace arcway::internal::bench {
namespace {

constexpr std::size_t kWholeUpTo = 4'000, kFullWholeUpTo = 1'100;

QuerySet check_queries(const World& world) {
#ifdef ARCWAY_BENCH_ACCEL
  constexpr std::size_t kBruteForceUpTo = 100'000;
  if (world.vertices().size() > kBruteForceUpTo) return make_embree_queries(world);
#endif
  return make_reference_queries(world);
}

std::vector<VertexId> reduced_row(const World& world, const VisibilityQuery& visibility, VertexId u) {
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

std::vector<VertexId> full_row(const World& world, const VisibilityQuery& visibility, VertexId u) {
  std::vector<VertexId> row;
  for (VertexId v = u + 1; v < world.vertices().size(); ++v) {
    const LineSegment line{world.vertex(u), world.vertex(v)};
    if (!world.is_covered(u) && !world.is_covered(v) && line.a != line.b && visibility.visible(line)) row.push_back(v);
  }
  return row;
}

// Whether some rows are right: those of vertices drawn at random. row_by_definition(u) gives a right one.
template <class Row>
bool has_rows(const VisibilityGraph& graph, std::span<const VertexId> vertices, std::size_t rows,
              const Row& row_by_definition) {
  Random random(1);
  for (std::size_t i = 0; i < rows; ++i) {
    const VertexId u = vertices[random.below(vertices.size())];
    if (!std::ranges::equal(graph.row(u), row_by_definition(u))) return false;
  }
  return true;
}

}  // namespace

bool is_reduced_graph(const World& world, const VisibilityGraph& graph, std::size_t rows) {
  if (graph.vertex_count() != world.vertices().size()) return false;
  const QuerySet queries = check_queries(world);
  if (world.vertices().size() <= kWholeUpTo) return graph == build_reduced_visibility_graph(world, *queries.visibility);
  return has_rows(graph, world.convex_vertices(), rows,
                  [&](VertexId u) { return reduced_row(world, *queries.visibility, u); });
}

bool is_full_graph(const World& world, const VisibilityGraph& graph, std::size_t rows) {
  if (graph.vertex_count() != world.vertices().size()) return false;
  const QuerySet queries = check_queries(world);
  if (world.vertices().size() <= kFullWholeUpTo)
    return graph == build_full_visibility_graph(world, *queries.visibility);
  std::vector<VertexId> all(world.vertices().size());
  std::iota(all.begin(), all.end(), 0u);
  return has_rows(graph, all, rows, [&](VertexId u) { return full_row(world, *queries.visibility, u); });
}

}  // namespace arcway::internal::bench

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/executor.h"
#include "core/collision/visibility_query.h"
#include "core/model/path.h"
#include "core/model/world.h"

namespace [[gnu::visibility("default")]] arcway {

/// An undirected graph on a world's vertices in compressed rows: each edge is stored once in the row of its lower
/// vertex, rows ascending.
class VisibilityGraph {
 public:
  VisibilityGraph() = default;
  /// @param row_starts  vertex count + 1 offsets into `targets`; targets of row u are > u and ascending.
  /// @throws TableError (std::invalid_argument) naming the first entry that breaks this.
  VisibilityGraph(std::vector<std::uint64_t> row_starts, std::vector<VertexId> targets);

  [[nodiscard]] std::size_t vertex_count() const { return row_starts_.empty() ? 0 : row_starts_.size() - 1; }
  [[nodiscard]] std::size_t edge_count() const { return targets_.size(); }
  /// Neighbours v > u of u.
  [[nodiscard]] std::span<const VertexId> row(VertexId u) const;
  [[nodiscard]] std::span<const std::uint64_t> row_starts() const { return row_starts_; }
  [[nodiscard]] std::span<const VertexId> targets() const { return targets_; }
  friend bool operator==(const VisibilityGraph&, const VisibilityGraph&) = default;

 private:
  std::vector<std::uint64_t> row_starts_;
  std::vector<VertexId> targets_;
};

/// Whether the line through the convex vertex v with the direction towards p is tangent at v: both
/// neighbours of v on one closed side of it. Exact. p != v; false if p == v.
bool is_tangent(const World& world, VertexId v, const Vec2& p);

/// The side of the obstacle at a tangent vertex, seen when travelling from `from` through v. Precondition:
/// is_tangent(world, v, from).
Side obstacle_side(const World& world, VertexId v, const Vec2& from);

/// All pairs of vertices that are not covered, convex and reflex ones, and see each other; the paper's figure 1, all
/// lines. A line may pass through other vertices. Coincident vertices are not joined. O(n^2) segments.
VisibilityGraph build_full_visibility_graph(const World& world, const VisibilityQuery& visibility,
                                            const Executor& executor = SerialExecutor());

/// Of the tangent edges at each vertex that lie on one ray, only the nearest: (iii) below, for a graph that has all
/// edges of (i) and (ii). Exact; O(e log e) for e edges.
VisibilityGraph without_carried_edges(const World& world, const VisibilityGraph& graph, const Executor& executor);

/// The reduced visibility graph [Rohnert 1986; the paper's section 2]: pairs of convex vertices
/// (World::convex_vertices) that (i) see each other, (ii) whose line is tangent at both, (iii) with no other convex
/// vertex on the open segment. Pairwise: a tangency test for each pair, a visibility query for the survivors. O(n^2 + s
/// q) for s tangent pairs and queries of cost q.
VisibilityGraph build_reduced_visibility_graph(const World& world, const VisibilityQuery& visibility,
                                               const Executor& executor = SerialExecutor());

}  // namespace arcway

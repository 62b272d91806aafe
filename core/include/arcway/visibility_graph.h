#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arcway/executor.h"
#include "arcway/export.h"
#include "arcway/path.h"
#include "arcway/visibility_query.h"
#include "arcway/world.h"

namespace arcway {

/// An undirected graph on a world's vertices in compressed rows: each edge is stored once in the row of its lower
/// vertex, rows ascending.
class ARCWAY_API VisibilityGraph {
 public:
  VisibilityGraph() = default;
  /// @param row_starts  vertex count + 1 offsets into `targets`; targets of row u are > u and ascending.
  /// @throws SnapshotError (std::invalid_argument) naming the first entry that breaks this.
  VisibilityGraph(std::vector<std::uint64_t> row_starts, std::vector<VertexId> targets);

  [[nodiscard]] std::size_t vertex_count() const { return row_starts_.empty() ? 0 : row_starts_.size() - 1; }
  [[nodiscard]] std::size_t edge_count() const { return targets_.size(); }
  /// Neighbors v > u of u.
  [[nodiscard]] std::span<const VertexId> row(VertexId u) const;
  [[nodiscard]] std::span<const std::uint64_t> row_starts() const { return row_starts_; }
  [[nodiscard]] std::span<const VertexId> targets() const { return targets_; }
  friend bool operator==(const VisibilityGraph&, const VisibilityGraph&) = default;

 private:
  std::vector<std::uint64_t> row_starts_;
  std::vector<VertexId> targets_;
};

/// All pairs of vertices that are not covered, convex and reflex ones, and see each other; the paper's figure 1, all
/// lines. A line may pass through other vertices. Coincident vertices are not joined. O(n^2) segments.
ARCWAY_API VisibilityGraph build_full_visibility_graph(const World& world, const VisibilityQuery& visibility,
                                                       const Executor& executor = SerialExecutor());

/// The reduced visibility graph [Rohnert 1986; the paper's section 2]: pairs of convex vertices
/// (World::convex_vertices) that (i) see each other, (ii) whose line is tangent at both, (iii) with no other convex
/// vertex on the open segment. Pairwise: a tangency test for each pair, a visibility query for the survivors. O(n^2 + s
/// q) for s tangent pairs and queries of cost q.
ARCWAY_API VisibilityGraph build_reduced_visibility_graph(const World& world, const VisibilityQuery& visibility,
                                                          const Executor& executor = SerialExecutor());

}  // namespace arcway

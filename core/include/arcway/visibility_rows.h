#pragma once

#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "arcway/executor.h"
#include "arcway/export.h"
#include "arcway/visibility_graph.h"

namespace arcway {

/// The reduced visibility graph as rows, each edge in those of both its ends: all of it at hand, or a row made when it
/// is first asked for. Thread-safe.
class ARCWAY_API VisibilityRows {
 public:
  virtual ~VisibilityRows() = default;

  /// All neighbors of a vertex, lower and higher, ascending; none unless it is one of World::convex_vertices. Valid as
  /// long as the rows are. Precondition: the world has the vertex.
  [[nodiscard]] virtual std::span<const VertexId> of(VertexId vertex) const = 0;

  /// Says that a row will be asked for soon.
  virtual void prefetch(VertexId /*vertex*/) const {}

  using Pair = std::pair<VertexId, VertexId>;
  /// All edges u < v up to a length [m] for which wanted(u, v), ascending: without making rows that have none. `wanted`
  /// may be asked of other pairs of convex vertices as well, by several threads, and is the same for (u, v) and (v, u).
  [[nodiscard]] virtual std::vector<Pair> pairs_within(double length,
                                                       const std::function<bool(VertexId, VertexId)>& wanted,
                                                       const Executor& executor) const = 0;
};

/// The rows of a graph of `world` that is all there: 8 bytes an edge and 8 a vertex, copied.
/// @throws SnapshotError (std::invalid_argument) if the graph has another number of vertices than the world, or an edge
///   to one that is not convex and free (World::is_graph_vertex).
ARCWAY_API std::shared_ptr<const VisibilityRows> rows_of(const World& world, const VisibilityGraph& graph);

}  // namespace arcway

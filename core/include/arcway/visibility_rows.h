#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "arcway/executor.h"
#include "arcway/export.h"
#include "arcway/visibility_graph.h"
#include "arcway/visibility_query.h"
#include "arcway/world.h"
#include "arcway/world_change.h"

namespace arcway {

/// The reduced visibility graph in rows, one a vertex, with each edge in the rows of both its ends. Implementations
/// have the whole graph, or compute each row when it is first asked for. Thread-safe.
class ARCWAY_API VisibilityRows {
 public:
  virtual ~VisibilityRows() = default;

  /// All neighbors of a vertex, ascending; none unless it is one of World::convex_vertices. The span is valid as long
  /// as this object. Precondition: the world has the vertex.
  [[nodiscard]] virtual std::span<const VertexId> of(VertexId vertex) const = 0;

  /// Hints that a row will be asked for soon.
  virtual void prefetch(VertexId /*vertex*/) const {}

  using Pair = std::pair<VertexId, VertexId>;
  /// All edges u < v of at most `length` [m] for which wanted(u, v), ascending. Rows without such edges are not
  /// computed. `wanted` must be symmetric and thread-safe; it may be asked about any pair of convex vertices.
  [[nodiscard]] virtual std::vector<Pair> pairs_within(double length,
                                                       const std::function<bool(VertexId, VertexId)>& wanted,
                                                       const Executor& executor) const = 0;

  /// Rows of the world after a change.
  struct Changed {
    std::shared_ptr<const VisibilityRows> rows;
    std::vector<VertexId> may_differ;  ///< all graph vertices that are new, or whose neighbors may be others; ascending
  };
  /// The rows after a change, in time that depends on what changed and what sees it; nothing if they are to be made
  /// anew.
  /// @param change  from the world of these rows to `after`.
  /// @param visibility  of `after`.
  [[nodiscard]] virtual std::optional<Changed> changed(
      [[maybe_unused]] const World& after, [[maybe_unused]] const WorldChange& change,
      // NOLINTNEXTLINE(performance-unnecessary-value-param): rows made from it keep it.
      [[maybe_unused]] std::shared_ptr<const VisibilityQuery> visibility) const {
    return std::nullopt;
  }
};

/// The rows of a graph that exists already. Memory: 8 bytes an edge and 8 a vertex; the graph is copied.
/// @throws SnapshotError (std::invalid_argument) if the graph has another number of vertices than the world, or an edge
///   to a vertex that is no graph vertex (World::is_graph_vertex).
ARCWAY_API std::shared_ptr<const VisibilityRows> rows_of(const World& world, const VisibilityGraph& graph);

}  // namespace arcway

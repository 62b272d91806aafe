#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "accel/expansion/opened_triangulation.h"
#include "arcway/executor.h"
#include "arcway/world.h"

namespace arcway::internal {

/// Rows of the reduced visibility graph, one vertex at a time. Lazy planning on large maps needs only some of them.
///
///     const TangentNeighbors neighbors(world);
///     for (const VertexId v : neighbors.of(u)) ...
///
/// Immutable and thread-safe; the world need not outlive it.
class TangentNeighbors {
 public:
  /// Triangulates free space; see tangent_cone_graph.h for its cost.
  explicit TangentNeighbors(const World& world, const Executor& executor = SerialExecutor());
  ~TangentNeighbors();
  TangentNeighbors(TangentNeighbors&&) noexcept;
  TangentNeighbors& operator=(TangentNeighbors&&) noexcept;

  /// All neighbors of a vertex in the reduced visibility graph, ascending. None unless it is one of
  /// World::convex_vertices. Exact. O(triangles seen in its tangent cones).
  /// @throws std::out_of_range if the world has no such vertex.
  [[nodiscard]] std::vector<VertexId> of(VertexId vertex) const;

  /// The triangles, none of whose obstacles is opened yet. They must not outlive this.
  [[nodiscard]] OpenedTriangulation opened() const;
  /// Whether triangles and obstacles cover all places: the frame around all vertices does.
  [[nodiscard]] bool cover(std::span<const Box> places) const;
  /// The node at a vertex; kNone if it is no graph vertex. Precondition: the world has the vertex.
  [[nodiscard]] std::uint32_t node_of(VertexId vertex) const;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

}  // namespace arcway::internal

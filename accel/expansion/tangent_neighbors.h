#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "arcway/executor.h"
#include "arcway/world.h"

namespace arcway::internal {

/// Rows of the reduced visibility graph, one vertex at a time: what lazy planning needs of a large map.
///
///     const TangentNeighbors neighbors(world);
///     for (const VertexId v : neighbors.of(u)) ...
///
/// Immutable and thread-safe; the world need not outlive it.
class TangentNeighbors {
 public:
  /// Triangulates free space; see wedge_graph.h for cost and limits.
  explicit TangentNeighbors(const World& world, const Executor& executor = SerialExecutor());
  ~TangentNeighbors();
  TangentNeighbors(TangentNeighbors&&) noexcept;
  TangentNeighbors& operator=(TangentNeighbors&&) noexcept;

  /// All vertices, lower and higher, that share an edge of the reduced visibility graph with a vertex, ascending: none
  /// unless it is one of World::convex_vertices. Exact. O(triangles seen in its tangent cones).
  /// @throws std::out_of_range if the world has no such vertex.
  [[nodiscard]] std::vector<VertexId> of(VertexId vertex) const;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

}  // namespace arcway::internal

#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/executor.h"
#include "core/model/world.h"

namespace [[gnu::visibility("default")]] arcway {

/// Rows of the reduced visibility graph, one vertex at a time: what lazy planning needs of a large map.
///
///     const TangentNeighbours neighbours(world);
///     for (const VertexId v : neighbours.of(u)) ...
///
/// Immutable and thread-safe; the world need not outlive it.
class TangentNeighbours {
 public:
  /// Triangulates free space; see wedge_graph.h for cost and limits.
  explicit TangentNeighbours(const World& world, const Executor& executor = SerialExecutor());
  ~TangentNeighbours();
  TangentNeighbours(TangentNeighbours&&) noexcept;
  TangentNeighbours& operator=(TangentNeighbours&&) noexcept;

  /// All vertices, lower and higher, that share an edge of the reduced visibility graph with a vertex, ascending: none
  /// unless it is one of World::convex_vertices. Exact. O(triangles seen in its tangent wedges).
  /// @throws std::out_of_range if the world has no such vertex.
  [[nodiscard]] std::vector<VertexId> of(VertexId vertex) const;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

}  // namespace arcway

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

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

  /// All convex vertices with a line of sight to one of the places, and some others; in no useful order. See
  /// ChangeVisibility. Nothing if a place reaches beyond the convex hull of the vertices, where there are no triangles.
  [[nodiscard]] std::optional<std::vector<VertexId>> viewers_of(std::span<const Box> places) const;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

}  // namespace arcway::internal

#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/vec2.h"
#include "core/graph/visibility_graph.h"
#include "core/query/visibility_query.h"
#include "core/world.h"

namespace [[gnu::visibility("default")]] arcway {

/// Shortest paths of a point among the obstacles: how far at least the reference point of any body drives that covers
/// it. A point may touch obstacles and pass between two that touch.
///
///     const PointDistance distance(world, build_reduced_visibility_graph(world, visibility));
///     distance(start, goal, visibility);
///
/// Immutable, thread-safe.
class PointDistance {
 public:
  /// @param graph  the reduced visibility graph of `world`. Its edges are copied in both directions.
  PointDistance(const World& world, const VisibilityGraph& graph);

  /// Length of the shortest path, up to the rounding of its sum [m]; infinity if there is none. Neither point may lie
  /// inside an obstacle. A* over the graph with the distance to the goal; segments from the start and to the goal are
  /// asked of `visibility` when their turn comes, so that mostly vertices near the straight line are asked for.
  [[nodiscard]] double operator()(const Vec2& start, const Vec2& goal, const VisibilityQuery& visibility) const;

 private:
  World world_;
  std::vector<std::uint64_t> row_starts_;
  std::vector<VertexId> neighbors_;
};

}  // namespace arcway

#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "arcway/world.h"

namespace arcway::internal {

/// Common tangents of convex obstacles by binary search over the directions of their edges [Rohnert 1986]. Immutable
/// and thread-safe.
class ConvexTangents {
 public:
  explicit ConvexTangents(const World& world);

  /// Whether an obstacle is one strictly convex ring that nowhere touches itself.
  [[nodiscard]] bool is_convex(ObstacleId obstacle) const { return convex_[obstacle]; }

  using VertexPair = std::pair<VertexId, VertexId>;
  /// The four common tangents of two convex obstacles, each as a vertex of `a` and a vertex of `b`. Exact.
  ///
  /// Returns nothing if the obstacles' boxes overlap or a tangent runs along an edge; then all pairs must be tried.
  /// O(log n) a step, two or three steps as a rule, and bounded.
  [[nodiscard]] std::optional<std::array<VertexPair, 4>> between(ObstacleId a, ObstacleId b) const;

 private:
  /// The vertex furthest in a direction, with rounding: perhaps a neighbor of it.
  [[nodiscard]] VertexId furthest(ObstacleId obstacle, const Vec2& direction) const;
  [[nodiscard]] std::optional<VertexPair> tangent(ObstacleId a, ObstacleId b, int side_a, int side_b) const;
  /// Whether both neighbors of v lie strictly on one side of the line from p to q, which passes through v.
  [[nodiscard]] bool is_touched(VertexId v, const Vec2& p, const Vec2& q, int side) const;

  World world_;
  std::vector<bool> convex_;
  // For the edge that ends at a vertex, in ring order from the smallest angle: its pseudo-angle, and the vertex.
  std::vector<double> angles_;
  std::vector<VertexId> ends_;
};

}  // namespace arcway::internal

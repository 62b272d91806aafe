#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "arcway/world.h"

namespace arcway::internal {

/// Common tangents of convex obstacles by binary search over the directions of their edges [Rohnert 1986].
/// Immutable and thread-safe.
class ConvexTangents {
 public:
  explicit ConvexTangents(const World& world);

  /// Whether an obstacle is one ring, strictly convex, that nowhere touches itself.
  [[nodiscard]] bool is_convex(ObstacleId obstacle) const { return convex_[obstacle]; }

  using VertexPair = std::pair<VertexId, VertexId>;
  /// The four lines that touch both obstacles, as a vertex of `a` and one of `b` each: all pairs whose line is tangent
  /// at both. Exact. Nothing where that is not found, so that all pairs must be tried: if the obstacles' boxes meet, or
  /// a tangent runs along an edge. Both obstacles must be convex. O(log n) a step; the steps are two or three as a rule
  /// and bounded.
  [[nodiscard]] std::optional<std::array<VertexPair, 4>> between(ObstacleId a, ObstacleId b) const;

 private:
  /// The vertex furthest in a direction, rounded: perhaps a neighbor of it.
  [[nodiscard]] VertexId furthest(ObstacleId obstacle, const Vec2& direction) const;
  [[nodiscard]] std::optional<VertexPair> tangent(ObstacleId a, ObstacleId b, int side_a, int side_b) const;
  /// Whether both neighbors of v lie strictly on one side of the line from p to q, which passes through v.
  [[nodiscard]] bool is_touched(VertexId v, const Vec2& p, const Vec2& q, int side) const;

  World world_;
  std::vector<bool> convex_;
  // For the edge that ends at a vertex, in ring order from the one of smallest angle: pseudo-angle, and the vertex.
  std::vector<double> angles_;
  std::vector<VertexId> ends_;
};

}  // namespace arcway::internal

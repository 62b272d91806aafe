#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "arcway/executor.h"
#include "arcway/export.h"
#include "arcway/visibility_graph.h"
#include "arcway/world.h"

namespace arcway {

/// What is seen from where in a world: lines of sight, rays, tangents, visibility polygons, all from one triangulation
/// of free space. Every decision is exact and follows World's rule of touching; only coordinates of points that are no
/// vertices are rounded.
///
///     const VisibilityMap map(world);
///     if (map.visible({a, b})) ...
///     for (const VisibleEdge& piece : map.visibility_polygon(p)) draw_triangle(p, piece.right, piece.left);
///
/// Points must be finite and in the range of predicates.h: std::invalid_argument otherwise. Immutable and thread-safe;
/// the world need not outlive it.
class ARCWAY_API VisibilityMap {
 public:
  /// Triangulates free space, see wedge_graph.h, and sorts the triangles into a tree: O(n log n), about 600 bytes a
  /// vertex.
  /// @throws std::length_error beyond 2^28 vertices.
  explicit VisibilityMap(const World& world, const Executor& executor = SerialExecutor());
  ~VisibilityMap();
  VisibilityMap(VisibilityMap&&) noexcept;
  VisibilityMap& operator=(VisibilityMap&&) noexcept;

  /// Whether a segment is a line of sight: the same answer as VisibilityQuery's. O(log n + triangles on the way); O(n)
  /// if both ends lie further from the map than its size or on edges with obstacles on both sides.
  [[nodiscard]] bool visible(const LineSegment& segment) const;

  /// Where a ray enters the inside of an obstacle.
  struct RayHit {
    Vec2 point;        ///< on the wall, rounded; a vertex exactly
    LineSegment edge;  ///< the piece of an obstacle's edge between two neighboring vertices on it that the ray
                       ///< crosses, obstacle on the right of a -> b; the vertex twice if the ray enters at one
  };
  /// Of the ray from `from` through `towards`, different points; nothing if it meets none. A start inside an obstacle
  /// is the hit itself, and its wall. O(log n + triangles on the way); O(n) from an edge with obstacles on both sides.
  /// @throws std::invalid_argument if the points are equal; std::domain_error if edges of the world cross, or the start
  ///   is further from the map than its size.
  [[nodiscard]] std::optional<RayHit> first_hit(const Vec2& from, const Vec2& towards) const;

  /// The vertices that are not covered (World::is_covered) and that a vertex sees: its neighbors in the full
  /// visibility graph, ascending; none if it is covered itself. Lines of sight may pass through other vertices. Those
  /// at the same place are no neighbors. O(log n + triangles seen).
  /// @throws std::out_of_range if the world has no such vertex.
  [[nodiscard]] std::vector<VertexId> visible_from(VertexId vertex) const;
  /// The same for a point, but O(n) lines of sight for one further from the map than its size or on an edge with
  /// obstacles on both sides.
  [[nodiscard]] std::vector<VertexId> visible_from(const Vec2& point) const;

  /// The convex vertices that share an edge of the reduced visibility graph with a vertex, ascending.
  /// O(triangles seen in its tangent cones).
  /// @throws std::out_of_range if the world has no such vertex.
  [[nodiscard]] std::vector<VertexId> tangents_from(VertexId vertex) const;
  /// The convex vertices (World::convex_vertices) that a point sees, at which its line is tangent, and with no other
  /// convex vertex in between; ascending. As dear as visible_from.
  [[nodiscard]] std::vector<VertexId> tangents_from(const Vec2& point) const;

  /// A piece of a wall that is seen.
  struct VisibleEdge {
    LineSegment edge;       ///< as RayHit's
    Vec2 right, left;       ///< ends of the piece: vertices exactly, otherwise rounded
    Vec2 past_right;        ///< the vertex on the line of sight to `right`, exact
    Vec2 past_left;         ///< ... to `left`
    bool is_frame = false;  ///< no wall, but a box around the map, beyond which there is nothing
  };
  /// What a point sees, as the walls around it, counter-clockwise from +x; together with the point each is a triangle
  /// of the visibility polygon. None for a point inside an obstacle. O(log n + triangles seen).
  /// @throws std::domain_error if edges of the world cross, or the point is further from the map than its size.
  [[nodiscard]] std::vector<VisibleEdge> visibility_polygon(const Vec2& point) const;

 private:
  friend VisibilityGraph build_full_visibility_graph_by_expansion(const World& world, const Executor& executor);
  struct Data;
  std::unique_ptr<const Data> data_;
};

/// The same graph as core's build_full_visibility_graph, for any executor, without testing pairs: by triangular
/// expansion [Bungiu et al. 2014], VisibilityMap::visible_from each vertex. O(n log n + triangles seen from all
/// vertices). Exact for every world.
/// @throws std::length_error beyond 2^28 vertices.
ARCWAY_API VisibilityGraph build_full_visibility_graph_by_expansion(const World& world,
                                                                    const Executor& executor = SerialExecutor());

}  // namespace arcway

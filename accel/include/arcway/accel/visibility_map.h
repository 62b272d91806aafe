#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "arcway/executor.h"
#include "arcway/export.h"
#include "arcway/visibility_graph.h"
#include "arcway/world.h"

namespace arcway {

/// Answers visibility queries about a world from one triangulation of free space: lines of sight, rays, tangents,
/// visibility polygons. Every decision is exact and follows World's rule of touching. Only coordinates of points that
/// are no vertices are rounded.
///
///     const VisibilityMap map(world);
///     if (map.visible({a, b})) ...
///     for (const VisibleEdge& piece : map.visibility_polygon(p)) draw_triangle(p, piece.right, piece.left);
///
/// Points must be in the exact range of vec2.h: std::invalid_argument otherwise. Immutable and thread-safe;
/// the world need not outlive it.
class ARCWAY_API VisibilityMap {
 public:
  /// Triangulates free space, see tangent_cone_graph.h, and sorts the triangles into a tree. O(n log n), about 600
  /// bytes a vertex.
  /// @throws std::length_error beyond 2^28 vertices.
  explicit VisibilityMap(const World& world, const Executor& executor = SerialExecutor());
  ~VisibilityMap();
  VisibilityMap(VisibilityMap&&) noexcept;
  VisibilityMap& operator=(VisibilityMap&&) noexcept;

  /// Whether a segment is a line of sight: the answer of VisibilityQuery. O(log n + triangles on the way). O(n) if both
  /// ends lie further from the map than its size, or on edges with obstacles on both sides.
  [[nodiscard]] bool visible(const LineSegment& segment) const;

  /// The point where a ray enters the inside of an obstacle.
  struct RayHit {
    Vec2 point;        ///< on the edge, rounded; exact at a vertex
    LineSegment edge;  ///< the piece of an obstacle's edge that the ray crosses, between two neighboring vertices on
                       ///< it, obstacle on the right of a -> b; the vertex twice if the ray enters at one
  };
  /// First hit of the ray from `from` through `towards`; nothing if it meets no obstacle. A start inside an obstacle is
  /// itself the hit, and its edge. O(log n + triangles on the way); O(n) from an edge with obstacles on both sides.
  /// @throws std::invalid_argument if the points are equal.
  /// @throws std::domain_error if edges of the world cross, or the start is further from the map than its size.
  [[nodiscard]] std::optional<RayHit> first_hit(const Vec2& from, const Vec2& towards) const;

  /// Uncovered vertices (World::is_covered) that a vertex sees: its neighbors in the full visibility graph, ascending.
  /// None if it is covered itself. Lines of sight may pass through other vertices. Vertices at the same position are no
  /// neighbors. O(log n + triangles seen).
  /// @throws std::out_of_range if the world has no such vertex.
  [[nodiscard]] std::vector<VertexId> visible_from(VertexId vertex) const;
  /// Uncovered vertices that a point sees, ascending. O(log n + triangles seen). Takes O(n) lines of sight for a point
  /// further from the map than its size, or on an edge with obstacles on both sides.
  [[nodiscard]] std::vector<VertexId> visible_from(const Vec2& point) const;

  /// Neighbors of a vertex in the reduced visibility graph, ascending. O(triangles seen in its tangent cones).
  /// @throws std::out_of_range if the world has no such vertex.
  [[nodiscard]] std::vector<VertexId> tangents_from(VertexId vertex) const;
  /// Convex vertices (World::convex_vertices) that a point sees along a tangent, with no other convex vertex in
  /// between; ascending. Costs as much as visible_from.
  [[nodiscard]] std::vector<VertexId> tangents_from(const Vec2& point) const;

  /// A visible piece of an obstacle's edge.
  struct VisibleEdge {
    LineSegment edge;       ///< as in RayHit
    Vec2 right, left;       ///< ends of the piece: exact at vertices, otherwise rounded
    Vec2 past_right;        ///< the vertex on the line of sight to `right`, exact
    Vec2 past_left;         ///< the vertex on the line of sight to `left`, exact
    bool is_frame = false;  ///< an edge of the frame around the map, beyond which there is nothing
  };
  /// The visibility polygon of a point, as the visible edges around it, counter-clockwise from +x. Each edge and the
  /// point form a triangle of the polygon. None for a point inside an obstacle. O(log n + triangles seen).
  /// @throws std::domain_error if edges of the world cross, or the point is further from the map than its size.
  [[nodiscard]] std::vector<VisibleEdge> visibility_polygon(const Vec2& point) const;

 private:
  friend VisibilityGraph build_full_visibility_graph_by_expansion(const World& world, const Executor& executor);
  struct Data;
  std::unique_ptr<const Data> data_;
};

/// The full visibility graph without testing pairs: VisibilityMap::visible_from each vertex, by triangular expansion
/// [Bungiu et al. 2014]. Equals core's build_full_visibility_graph, for any executor. O(n log n + triangles seen from
/// all vertices). Exact for every world.
/// @throws std::length_error beyond 2^28 vertices.
ARCWAY_API VisibilityGraph build_full_visibility_graph_by_expansion(const World& world,
                                                                    const Executor& executor = SerialExecutor());

}  // namespace arcway

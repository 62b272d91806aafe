#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "arcway/export.h"
#include "arcway/polygon.h"
#include "arcway/snapshot.h"
#include "arcway/vec2.h"

namespace arcway {

/// Index of a vertex: obstacles in input order, in each its outer ring and then its holes in input
/// order, vertices as given; the bounds' vertices last. The edge that starts at vertex v has the
/// same index.
using VertexId = std::uint32_t;
/// Index of an obstacle in input order; the bounds, if any, count as the last one.
using ObstacleId = std::uint32_t;

inline constexpr std::uint32_t kNone = 0xFFFFFFFFu;

/// A polygon that World refuses.
class ARCWAY_API WorldError : public std::invalid_argument {
 public:
  WorldError(const std::string& message, ObstacleId obstacle) : std::invalid_argument(message), obstacle_(obstacle) {}
  /// The offending obstacle; the number of obstacles if it is the bounds.
  [[nodiscard]] ObstacleId obstacle() const { return obstacle_; }

 private:
  ObstacleId obstacle_;
};

/// The map: polygonal obstacles, and optionally bounds that the robot may not leave. Immutable;
/// copies share the data, so that a copy is O(1) and safe to hand to any thread.
///
/// **Touching.** Every obstacle is an *open* set: its boundary belongs to free space. A line of
/// sight may touch a vertex, run along an edge, pass between two obstacles that touch, and run
/// along the common edge of two obstacles; it is blocked only by a point strictly inside some
/// obstacle. Obstacles may touch, overlap, share vertices and lie inside one another; a vertex
/// strictly inside another obstacle takes no part in any graph. (A robot with a safety margin never gets that
/// near: sweep checks treat obstacles as closed.) The bounds act as one more obstacle that is
/// everything strictly outside of them. A hole is free space inside its obstacle.
///
/// Rings are stored in the order given, and seen through `next` and `previous` always with the
/// obstacle's interior on the left of vertex -> next(vertex): outer rings counter-clockwise, holes
/// clockwise, the bounds clockwise. Where rings of one region touch in a common vertex, each of the coincident vertices
/// has one wedge of the interior there, so that `next` may lead from one ring to another.
///
/// **Contacts within a region.** A vertex may lie inside an edge of its own region: a hole touches the outer ring, two
/// holes touch, or a ring touches itself. Both keep their ids. The interior at such a point is what lies in the
/// vertex's wedge *and* on the left of the edge; `self_contacts` lists where the two differ. No way of positive width
/// leads through the point, so the vertex is convex only if its ring is.
class ARCWAY_API World {
 public:
  /// Checks and takes the map.
  /// @throws WorldError naming obstacle, ring, vertex and value: a coordinate that is not finite or
  ///   outside the range of predicates.h, fewer than 3 vertices, repeated consecutive vertices, zero
  ///   area, crossing or overlapping edges (both named), a hole that leaves its outer ring.
  /// Time O(n log n), nested and long obstacles included, where few obstacles cross. O(n k) for k obstacles that cross
  /// others and whose boxes hold most of the map. An error among edges with common boxes may take O(n^2) to be named.
  /// Memory about 120 bytes a vertex; where boxes nest or overlap all over, up to 250 while it is made.
  explicit World(std::vector<Polygon> obstacles, std::optional<Ring> bounds = std::nullopt);

  /// The world that `snapshot()` of another one are of, in O(n) and without the checks and searches that took the other
  /// one longest: whether rings cross, and which vertices are covered, is taken from the snapshot.
  /// @throws SnapshotError if the snapshot is that of no world: a value out of range or order.
  static World from_snapshot(WorldSnapshot snapshot);
  [[nodiscard]] WorldSnapshot snapshot() const;

  /// The world without some of the obstacles and with others after its last one. Those that stay keep their order.
  /// Checks what is new, and looks again at what is covered near what changed: O(n + m log m) for m vertices that come
  /// or go, and O(k) for each of them for k obstacles.
  /// @param removed  obstacles, ascending.
  /// @throws std::invalid_argument if `removed` does not ascend or names no obstacle; WorldError, with the index that
  ///   an obstacle has in the new world.
  [[nodiscard]] World changed(std::span<const ObstacleId> removed, const std::vector<Polygon>& added) const;

  /// All vertices, the bounds' last.
  [[nodiscard]] std::span<const Vec2> vertices() const;
  [[nodiscard]] const Vec2& vertex(VertexId v) const { return vertices()[v]; }
  /// All edges; edge v runs from vertex v to vertex next(v), obstacle on its left.
  [[nodiscard]] std::span<const LineSegment> edges() const;
  [[nodiscard]] VertexId next(VertexId v) const;
  [[nodiscard]] VertexId previous(VertexId v) const;
  [[nodiscard]] ObstacleId obstacle_of(VertexId v) const;

  /// All vertices inside an edge of their own region whose ring lies on the edge's left, where the interior is;
  /// ascending by edge, then vertex. A vertex that touches an edge from its free side limits the interior by its own
  /// wedge alone, and is not listed.
  [[nodiscard]] std::span<const SelfContact> self_contacts() const;
  /// Those on one edge. O(log n).
  [[nodiscard]] std::span<const SelfContact> self_contacts_on(VertexId edge) const;
  /// The edge that a vertex touches like this, or kNone. O(log n).
  [[nodiscard]] VertexId edge_touched_by(VertexId v) const;

  /// Whether the interior angle at v is less than pi (exact). Collinear vertices are not convex.
  [[nodiscard]] bool is_convex(VertexId v) const;
  /// Whether v lies strictly inside another obstacle or strictly outside the bounds.
  [[nodiscard]] bool is_covered(VertexId v) const;
  /// Whether v may be a vertex of the reduced visibility graph: convex and not covered. A shortest path turns at no
  /// other.
  [[nodiscard]] bool is_graph_vertex(VertexId v) const;
  /// All graph vertices, ascending.
  [[nodiscard]] std::span<const VertexId> convex_vertices() const;

  /// Number of obstacles without the bounds.
  [[nodiscard]] std::size_t obstacle_count() const;
  [[nodiscard]] bool has_bounds() const;
  /// Number of obstacles, the bounds included if there are any.
  [[nodiscard]] std::size_t region_count() const { return obstacle_count() + (has_bounds() ? 1 : 0); }
  /// Vertices [first, last) of a region; ring_starts gives the first vertex of each of its rings.
  struct VertexRange {
    VertexId first, last;
  };
  [[nodiscard]] VertexRange vertices_of(ObstacleId o) const;
  [[nodiscard]] std::span<const VertexId> ring_starts(ObstacleId o) const;
  /// Box of a region's vertices.
  [[nodiscard]] const Box& box_of(ObstacleId o) const;
  /// Box of all vertices; empty for a world without any.
  [[nodiscard]] const Box& box() const;

  /// Exact place of a point in one region (obstacle, or the outside of the bounds). O(vertices of it).
  [[nodiscard]] PointLocation locate(const Vec2& p, ObstacleId o) const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace arcway

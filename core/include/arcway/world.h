#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "arcway/export.h"
#include "arcway/polygon.h"
#include "arcway/snapshot.h"
#include "arcway/text.h"
#include "arcway/vec2.h"
#include "arcway/zone.h"

namespace arcway {

namespace internal {
class WorldHistory;
}
class Vehicle;

/// Index of a vertex. Vertices are numbered in the order of the input: obstacle by obstacle, the outer ring before its
/// holes, and the bounds last. The edge that starts at a vertex has the vertex's index.
using VertexId = std::uint32_t;
/// Index of an obstacle in the order of the input. The bounds, if any, count as the last one.
using ObstacleId = std::uint32_t;

/// Names an obstacle as long as the map has it, whatever else is removed or added. An ObstacleId is only its place.
using ObstacleKey = std::uint64_t;

/// No vertex, edge or obstacle.
inline constexpr std::uint32_t kNone = 0xFFFFFFFFu;

/// Thrown for a polygon that World refuses.
class ARCWAY_API WorldError : public std::invalid_argument {
 public:
  WorldError(const std::string& message, ObstacleId obstacle) : std::invalid_argument(message), obstacle_(obstacle) {}
  /// The obstacle at fault; the number of obstacles if it is the bounds.
  [[nodiscard]] ObstacleId obstacle() const { return obstacle_; }

 private:
  ObstacleId obstacle_;
};

/// A map: polygonal obstacles, and optionally bounds that the robot may not leave. Immutable and thread-safe. Copies
/// share the data, so that a copy is O(1).
///
/// **Touching.** Every obstacle is an *open* set: its boundary belongs to free space. Only a point strictly inside some
/// obstacle blocks a line of sight. A line of sight may therefore
/// - touch a vertex, or run along an edge;
/// - pass between two obstacles that touch, or run along their common edge.
///
/// Obstacles may touch, overlap, share vertices and lie inside one another. A vertex strictly inside another obstacle
/// takes no part in any graph. The bounds act as one more obstacle: everything strictly outside of them. A hole is free
/// space inside its obstacle. For the swept body, obstacles are *closed* sets: see SweepQuery.
///
/// **Orientation.** Rings are stored in the order given. `next` and `previous` go around each ring with the obstacle's
/// interior on the left: outer rings counter-clockwise, holes and bounds clockwise. Rings of one region may touch in a
/// common vertex. Each of the coincident vertices then bounds one wedge of the interior there, so that `next` may lead
/// from one ring to another.
///
/// **Contacts within a region.** A vertex may lie inside an edge of its own region: a hole touches another ring, or a
/// ring touches itself. Vertex and edge keep their ids. The interior at such a point is what lies in the vertex's wedge
/// *and* on the left of the edge; `self_contacts` lists where the two differ. No path of positive width leads through
/// the point, so that the vertex is convex only if its ring is.
class ARCWAY_API World {
 public:
  /// Checks the map and takes it.
  ///
  /// | refused | named in the error |
  /// |---|---|
  /// | a coordinate that is not finite, or out of the exact range of vec2.h | ring, vertex, value |
  /// | fewer than 3 vertices, repeated consecutive vertices, area 0 | ring, vertex |
  /// | edges of one polygon that cross or overlap | both edges, the place |
  /// | a hole outside of its outer ring | ring |
  ///
  /// Time: O(n log n), or O(n k) for k obstacles that cross others and whose boxes hold most of the map. To name an
  /// error among edges with overlapping boxes may take O(n^2). Memory: about 120 bytes a vertex; while it is made, up
  /// to 250 where boxes nest or overlap all over.
  /// @throws WorldError for the first obstacle that is refused.
  explicit World(std::vector<Polygon> obstacles, std::optional<Ring> bounds = std::nullopt);
  /// Bounds as a polygon, as Polygon::rectangle makes it.
  /// @throws WorldError as above, or for bounds with holes.
  template <std::same_as<Polygon> Bounds>
  World(std::vector<Polygon> obstacles, const Bounds& bounds) : World(from_polygons(std::move(obstacles), bounds)) {}

  /// The world of these obstacles, checked as the constructor does.
  /// @param bounds  without holes.
  /// @throws WorldError for the first obstacle that is refused, or for bounds with holes.
  static World from_polygons(std::vector<Polygon> obstacles, std::optional<Ring> bounds = std::nullopt);
  static World from_polygons(std::vector<Polygon> obstacles, const Polygon& bounds);
  /// Obstacles without holes.
  static World from_polygons(const std::vector<Ring>& obstacles, std::optional<Ring> bounds = std::nullopt);

  /// The world of a snapshot, in O(n). Whether rings cross and which vertices are covered, which take longest to find
  /// out, is taken from the snapshot unchecked.
  /// @throws SnapshotError if a value of the snapshot is out of range or order.
  static World from_snapshot(WorldSnapshot snapshot);
  /// The world as flat arrays. O(n).
  [[nodiscard]] WorldSnapshot snapshot() const;

  /// The world without some of the obstacles, and with others. An added obstacle takes the place of a removed one that
  /// has as many vertices in each ring, as one that has moved: its id, those of its vertices, and its key. All others
  /// follow the last obstacle, in their order, with new keys. The remaining ones keep their order and their keys; they
  /// keep their ids unless an obstacle in front of them has left and none has taken its place.
  ///
  /// Only what is new is checked, and coverage is updated near the change. Arrays of a world of the same origin
  /// that is gone are used again: what differs is written, and what follows the first vertex whose id differs is
  /// copied. O(m log n) then for m vertices that differ, and what is near them. O(n) otherwise.
  /// @param removed  obstacles, ascending.
  /// @param added  of several that may take a place, the first one here takes it; each takes the first place that it
  ///   may. None takes that of a keep-out.
  /// @throws std::invalid_argument if `removed` does not ascend or names no obstacle.
  /// @throws WorldError with the index that a refused obstacle has in the new world.
  [[nodiscard]] World changed(std::span<const ObstacleId> removed, const std::vector<Polygon>& added) const;

  /// The world with these zones in place of its own. Obstacles that stood for keep-outs are left out. O(vertices of
  /// zones) where there are none of these.
  /// @throws ZoneError for the first zone whose area or numbers are refused.
  [[nodiscard]] World with_zones(std::vector<Zone> zones) const;
  /// The zones, in the order given. Zones stay through `changed`; one whose obstacle is removed goes with it.
  [[nodiscard]] std::span<const Zone> zones() const;
  /// The world as a vehicle meets it: each keep-out for it is an obstacle, behind all others, in the order of the
  /// zones. Planner and validator do this by themselves; a backend made of this world saves the planner the change.
  /// Keep-outs that are obstacles already stay so, and those of other vehicles are left out. O(1) if nothing is to do.
  [[nodiscard]] World for_vehicle(const Vehicle& vehicle) const;
  /// The index among `zones` of the keep-out that an obstacle stands for; kNone for an obstacle of the map. O(log
  /// zones).
  [[nodiscard]] std::uint32_t keep_out_of(ObstacleId o) const;

  /// The positions of all vertices [m], the bounds' last.
  [[nodiscard]] std::span<const Vec2> vertices() const;
  [[nodiscard]] const Vec2& vertex(VertexId v) const { return vertices()[v]; }
  /// All edges [m]. Edge v runs from vertex v to next(v), with the obstacle on its left.
  [[nodiscard]] std::span<const LineSegment> edges() const;
  /// The neighbors of v on its ring, and its obstacle. O(1).
  [[nodiscard]] VertexId next(VertexId v) const;
  [[nodiscard]] VertexId previous(VertexId v) const;
  [[nodiscard]] ObstacleId obstacle_of(VertexId v) const;

  /// All vertices inside an edge of their own region whose ring lies on the edge's left, where the interior is.
  /// Ascending by edge, then vertex. A vertex that touches an edge from its free side is not listed, as its wedge alone
  /// bounds the interior.
  [[nodiscard]] std::span<const SelfContact> self_contacts() const;
  /// The self-contacts on one edge. O(log n).
  [[nodiscard]] std::span<const SelfContact> self_contacts_on(VertexId edge) const;
  /// The edge of which v is a self-contact, or kNone. O(log n).
  [[nodiscard]] VertexId edge_touched_by(VertexId v) const;

  /// Whether the interior angle at v is less than pi. Exact: a vertex on the line of its neighbors is not convex.
  [[nodiscard]] bool is_convex(VertexId v) const;
  /// Whether v lies strictly inside another obstacle, or strictly outside the bounds.
  [[nodiscard]] bool is_covered(VertexId v) const;
  /// Whether v is a vertex of the reduced visibility graph: convex and not covered. Shortest paths turn at such
  /// vertices only.
  [[nodiscard]] bool is_graph_vertex(VertexId v) const;
  /// All graph vertices, ascending. They are listed when this is first asked for: O(vertices), then O(1).
  [[nodiscard]] std::span<const VertexId> convex_vertices() const;
  /// The number of graph vertices. O(1).
  [[nodiscard]] std::size_t graph_vertex_count() const;

  /// The number of obstacles without the bounds.
  [[nodiscard]] std::size_t obstacle_count() const;
  [[nodiscard]] bool has_bounds() const;
  /// The number of obstacles, with the bounds if there are any.
  [[nodiscard]] std::size_t region_count() const { return obstacle_count() + (has_bounds() ? 1 : 0); }
  /// The key of an obstacle. A new world numbers its obstacles from 0, as their ids. `changed` gives an added obstacle
  /// the key of the one whose place it takes, or the next number that neither this world nor one that it came from has
  /// used. Keys therefore ascend by id. Snapshots do not have them: the world of a snapshot is a new one. O(1).
  /// Precondition: not the bounds.
  [[nodiscard]] ObstacleKey key_of(ObstacleId o) const;
  /// The id of the obstacle with a key; kNone if there is none, or no longer. O(log obstacles).
  [[nodiscard]] ObstacleId obstacle_with(ObstacleKey key) const;
  /// The vertices [first, last) of a region.
  struct VertexRange {
    VertexId first, last;
  };
  [[nodiscard]] VertexRange vertices_of(ObstacleId o) const;
  [[nodiscard]] std::span<const VertexId> ring_starts(ObstacleId o) const;
  /// A region's rings [m] as they were given: `World` takes them again. The bounds are a polygon whose interior is
  /// free. O(vertices of the region).
  [[nodiscard]] Polygon polygon_of(ObstacleId o) const;
  /// The box of a region's vertices [m].
  [[nodiscard]] const Box& box_of(ObstacleId o) const;
  /// The box of all vertices [m]; empty for a world without any.
  [[nodiscard]] const Box& box() const;

  /// The regions whose boxes meet one of some boxes, ascending. The first call takes O(n log n) for all worlds that
  /// come from one by changes; O((log n + k) m) then for m boxes, k regions found for each, and added obstacles.
  [[nodiscard]] std::vector<ObstacleId> regions_meeting(std::span<const Box> boxes) const;

  /// Where a point lies relative to one region: an obstacle, or the outside of the bounds. Exact. O(vertices of the
  /// region).
  [[nodiscard]] PointLocation locate(const Vec2& p, ObstacleId o) const;

  /// The changes that led here.
  [[nodiscard]] const internal::WorldHistory& history() const;

 private:
  struct Data;
  struct Zones;
  // The world after a change of its obstacles, with the same zones.
  [[nodiscard]] World with_obstacles_changed(std::span<const ObstacleId> removed,
                                             const std::vector<Polygon>& added) const;
  void add_zones(WorldSnapshot& snapshot) const;

  std::shared_ptr<const Data> data_;
  std::shared_ptr<const Zones> zones_;  // null: no zones
};

/// "8 obstacles of 45 vertices", "8 obstacles of 45 vertices within bounds": bounds count as vertices, too.
ARCWAY_API std::string to_string(const World& world);

}  // namespace arcway

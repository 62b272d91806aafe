#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "accel/base/big_vector.h"
#include "accel/expansion/bucket_index.h"
#include "accel/triangulation/free_space_sweep.h"
#include "accel/triangulation/planar_map.h"
#include "accel/triangulation/short_diagonals.h"
#include "accel/triangulation/triangulation.h"
#include "arcway/executor.h"
#include "arcway/world.h"
#include "core/geometry/box_tree.h"

namespace arcway::internal {

/// The triangulated free space of a world, laid out for lines of sight that start at its vertices: small records, what
/// is near in the plane near in memory. Immutable and thread-safe.
class FreeSpaceTriangulation {
 public:
  /// A half-edge and the triangle behind it, for somebody who looks across it into the triangle.
  struct HalfEdge {
    Vec2 apex;            ///< the triangle's third corner
    std::uint32_t left;   ///< the half-edge from this triangle between its left end and the apex; kNone: a wall
    std::uint32_t right;  ///< the one between the apex and its right end
    std::uint32_t point;  ///< of the apex
    std::uint32_t node;   ///< first node at the apex, kNone if there is none
  };

  /// A graph vertex, and what tangency at it needs. Nodes of one ring follow each other, counter-clockwise around the
  /// obstacle from the ring's leftmost vertex.
  ///
  /// A node is *plain* if nothing but its ring meets its point: then the triangles around it are one fan, from its
  /// previous edge to its next one.
  struct Node {
    Vec2 at, previous, next;
    VertexId vertex;
    std::uint32_t point, previous_point, next_point;
    std::uint32_t sibling;  ///< the next node of the point, or kNone
    std::uint32_t before;   ///< the node at the previous vertex if both are plain, or kNone
    std::uint32_t after;    ///< the one at the next vertex
    std::uint32_t
        first_half_edge;           ///< if plain, the one through the previous edge, which has the point at its left end
    std::uint32_t last_half_edge;  ///< if plain, the one through the next edge, which has the point at its right end
    [[nodiscard]] bool is_simple() const { return first_half_edge != kNone; }
  };

  /// Triangles around a point, counter-clockwise from one wall to the next, or all around it if no wall ends there.
  /// Each is behind a half-edge whose left end is the point; a half-edge's left is the next one in the fan.
  struct Fan {
    std::uint32_t half_edge;
    std::uint32_t first_point;  ///< the other end of the first half-edge
  };

  /// Six half-edges a vertex, and one bit for marks, fit into 32 bits.
  static constexpr std::size_t kMostVertices = std::size_t{1} << 28;

  /// O(n log n). Throws std::length_error beyond kMostVertices. The same for any executor.
  explicit FreeSpaceTriangulation(const World& world, const Executor& executor = SerialExecutor(),
                                  Diagonals shortened = Diagonals::kAll);

  [[nodiscard]] std::span<const HalfEdge> half_edges() const { return half_edges_; }
  [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }
  /// Those of a node that is not plain.
  [[nodiscard]] std::span<const Fan> fans(std::uint32_t node) const {
    return std::span(fans_).subspan(first_fan_[node], first_fan_[node + 1] - first_fan_[node]);
  }
  /// Whether all nodes are plain.
  [[nodiscard]] bool is_simple() const { return first_fan_.empty(); }
  [[nodiscard]] std::span<const Vec2> points() const { return map_.points; }
  /// The point at a vertex of the world. O(log n).
  [[nodiscard]] std::uint32_t point_at(const Vec2& vertex) const;
  /// Cross products of differences of points within the frame have the right sign beyond this, however they are
  /// rounded.
  [[nodiscard]] double sure_cross_product() const;
  [[nodiscard]] std::uint32_t first_node_at(std::uint32_t point) const { return node_at_[point]; }

  /// The edges of the map that leave a point to the right.
  [[nodiscard]] std::span<const PlanarMap::Edge> edges_from(std::uint32_t point) const {
    return std::span(map_.edges).subspan(map_.first_edge[point], map_.first_edge[point + 1] - map_.first_edge[point]);
  }
  /// Those that reach it from the left, by index; needs list_left_edges.
  [[nodiscard]] std::span<const std::uint32_t> edges_to(std::uint32_t point) const { return left_edges_.of(point); }
  [[nodiscard]] const PlanarMap::Edge& edge(std::uint32_t index) const { return map_.edges[index]; }
  /// Makes `edges_to` possible.
  void list_left_edges();
  /// Whether an edge lies strictly inside a region that is whole.
  [[nodiscard]] bool is_covered(const PlanarMap::Edge& edge) const {
    return edge_is_covered_[static_cast<std::size_t>(&edge - map_.edges.data())] != 0;
  }

  /// Whether all regions are whole: then walls and triangles say all there is to say about lines of sight.
  [[nodiscard]] bool is_valid() const { return map_.invalid.empty(); }
  [[nodiscard]] std::size_t invalid_count() const { return map_.invalid.size(); }
  /// Whether an edge of a region that is not whole blocks the segment.
  [[nodiscard]] bool is_blocked_by_invalid(const LineSegment& segment) const;

 private:
  /// A ring of the world; all rings' nodes follow each other in the order of the tiles of their leftmost points.
  struct Ring {
    VertexId leftmost;
    std::uint32_t first_node, nodes;
  };
  struct NodeOrder {
    std::vector<Ring> rings;
    std::uint32_t node_count = 0;
    std::vector<std::uint32_t> shared_points;  ///< that have several nodes
  };
  /// Free space of the map, if it is one; and the order of nodes.
  std::optional<FreeSpace> sweep(const Executor& executor, NodeOrder& order);
  /// Sets `node_at_`.
  NodeOrder number_nodes();

  /// The half-edge that leads into free space through a wall, by the point at its left end.
  struct alignas(8) BoundaryHalfEdge {
    std::uint32_t half_edge;
    std::uint32_t right;  ///< point at its other end
  };
  static constexpr BoundaryHalfEdge kNoBoundary{kNone, kNone}, kSeveralBoundaries{0, kNone};
  /// Half-edges in the order of the tiles of their triangles.
  BigVector<BoundaryHalfEdge> lay_out_half_edges(Triangulation triangulation, const Executor& executor);
  void lay_out_nodes(const NodeOrder& order, BigVector<BoundaryHalfEdge> boundary, const Executor& executor);
  /// Returns whether all nodes are plain.
  bool lay_out_ring(const Ring& ring, std::span<const BoundaryHalfEdge> boundary);
  [[nodiscard]] std::uint32_t last_half_edge_of_fan(std::uint32_t half_edge, std::uint32_t next_point) const;
  /// Those of all nodes that are not plain.
  void find_fans();

  World world_;
  PlanarMap map_;  // without what only the sweep needs
  std::vector<std::uint8_t> edge_is_covered_;
  BigVector<HalfEdge> half_edges_;
  BigVector<Node> nodes_;
  BigVector<std::uint32_t> node_at_;  // by point
  std::vector<Fan> fans_;
  std::vector<std::uint32_t> first_fan_;  // by node, none of plain ones; empty if all are
  BucketIndex left_edges_;
  std::vector<VertexId> invalid_edges_;
  BoxTree invalid_tree_;
};

}  // namespace arcway::internal

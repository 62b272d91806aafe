#pragma once

#include <algorithm>
#include <cstddef>
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

/// The triangulated free space of a world, laid out for visibility computations that start at vertices.
///
/// Records are small, and triangles that are near each other in the plane are near each other in memory. Immutable and
/// thread-safe.
class FreeSpaceTriangulation {
 public:
  /// A directed edge, together with the triangle on its far side. A visibility computation crosses it into that
  /// triangle.
  struct HalfEdge {
    Vec2 apex;            ///< third corner of the triangle
    std::uint32_t left;   ///< half-edge out of the triangle, from the left end to the apex; kNone on the boundary
    std::uint32_t right;  ///< half-edge out of the triangle, from the apex to the right end; kNone on the boundary
    std::uint32_t point;  ///< point of the apex
    std::uint32_t node;   ///< first node at the apex, or kNone
  };

  /// A vertex of the reduced visibility graph, with its neighbors on the ring for tangency tests. Nodes of one ring
  /// have consecutive indices. They start at the ring's leftmost vertex and go counter-clockwise around the obstacle.
  ///
  /// A node is *simple* if no other ring meets its point. Then the triangles around it form one fan from its previous
  /// edge to its next edge.
  struct Node {
    Vec2 at, previous, next;
    VertexId vertex;
    std::uint32_t point, previous_point, next_point;
    std::uint32_t sibling;          ///< next node at the same point, or kNone
    std::uint32_t before;           ///< node at the previous vertex if both are simple, or kNone
    std::uint32_t after;            ///< node at the next vertex if both are simple, or kNone
    std::uint32_t first_half_edge;  ///< simple nodes: crosses the previous edge, left end here
    std::uint32_t last_half_edge;   ///< simple nodes: crosses the next edge, right end here
    [[nodiscard]] bool is_simple() const { return first_half_edge != kNone; }
  };

  /// A fan of triangles around a point, counter-clockwise between two boundary edges, or all around the point.
  ///
  /// Each triangle lies behind a half-edge whose left end is the point. The half-edge's `left` leads to the next
  /// triangle of the fan.
  struct Fan {
    std::uint32_t half_edge;
    std::uint32_t first_point;  ///< right end of the first half-edge
  };

  /// Six half-edges a vertex and one bit for marks fit into 32 bits.
  static constexpr std::size_t kMostVertices = std::size_t{1} << 28;

  /// O(n log n). The result does not depend on the executor.
  /// @throws std::length_error beyond kMostVertices.
  explicit FreeSpaceTriangulation(const World& world, const Executor& executor = SerialExecutor(),
                                  Diagonals shortened = Diagonals::kAll);

  [[nodiscard]] std::span<const HalfEdge> half_edges() const { return half_edges_; }
  [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }
  /// Fans of a node that is not simple.
  [[nodiscard]] std::span<const Fan> fans(std::uint32_t node) const {
    return std::span(fans_).subspan(first_fan_[node], first_fan_[node + 1] - first_fan_[node]);
  }
  /// Whether all nodes are simple.
  [[nodiscard]] bool is_simple() const { return first_fan_.empty(); }
  [[nodiscard]] std::span<const Vec2> points() const { return map_.points; }
  /// Index of the point at a vertex of the world. O(log n).
  [[nodiscard]] std::uint32_t point_at(const Vec2& vertex) const;
  /// Error bound [m²]: beyond it, a rounded cross product of differences of points within the frame has the exact sign.
  [[nodiscard]] double sure_cross_product() const;
  [[nodiscard]] std::uint32_t first_node_at(std::uint32_t point) const { return node_at_[point]; }

  /// Edges of the planar map that leave a point to the right.
  [[nodiscard]] std::span<const PlanarMap::Edge> edges_from(std::uint32_t point) const {
    return std::span(map_.edges).subspan(map_.first_edge[point], map_.first_edge[point + 1] - map_.first_edge[point]);
  }
  /// Indices of the edges that reach a point from the left. Needs list_left_edges.
  [[nodiscard]] std::span<const std::uint32_t> edges_to(std::uint32_t point) const { return left_edges_.of(point); }
  [[nodiscard]] const PlanarMap::Edge& edge(std::uint32_t index) const { return map_.edges[index]; }
  /// Prepares `edges_to`.
  void list_left_edges();
  /// Whether an edge lies strictly inside a valid region.
  [[nodiscard]] bool is_covered(const PlanarMap::Edge& edge) const {
    return edge_is_covered_[static_cast<std::size_t>(&edge - map_.edges.data())] != 0;
  }

  /// Whether a region is valid: see PlanarMap. O(log invalid ones).
  [[nodiscard]] bool is_valid(ObstacleId region) const { return !std::ranges::binary_search(map_.invalid, region); }
  /// Whether all regions are valid. Then the triangles and their boundary decide every line of sight.
  [[nodiscard]] bool is_valid() const { return map_.invalid.empty(); }
  [[nodiscard]] std::size_t invalid_count() const { return map_.invalid.size(); }
  /// Whether an edge of an invalid region blocks the segment.
  [[nodiscard]] bool is_blocked_by_invalid(const LineSegment& segment) const;

 private:
  /// A ring of the world. Rings are ordered by the tile of their leftmost point, and nodes follow that order.
  struct Ring {
    VertexId leftmost;
    std::uint32_t first_node, nodes;
  };
  struct NodeOrder {
    std::vector<Ring> rings;
    std::uint32_t node_count = 0;
    std::vector<std::uint32_t> shared_points;  ///< points with several nodes
  };
  /// Triangulates the free space and numbers the nodes. Empty if edges of the map meet within their interiors.
  std::optional<FreeSpace> sweep(const Executor& executor, NodeOrder& order);
  /// Numbers the nodes and sets `node_at_`.
  NodeOrder number_nodes();

  /// A half-edge that enters free space through the boundary, indexed by the point at its left end.
  struct alignas(8) BoundaryHalfEdge {
    std::uint32_t half_edge;
    std::uint32_t right;  ///< point at its right end
  };
  static constexpr BoundaryHalfEdge kNoBoundary{kNone, kNone}, kSeveralBoundaries{0, kNone};
  /// Writes the half-edges in the order of the tiles of their triangles.
  BigVector<BoundaryHalfEdge> lay_out_half_edges(Triangulation triangulation, const Executor& executor);
  void lay_out_nodes(const NodeOrder& order, BigVector<BoundaryHalfEdge> boundary, const Executor& executor);
  /// Returns whether all nodes of the ring are simple.
  bool lay_out_ring(const Ring& ring, std::span<const BoundaryHalfEdge> boundary);
  [[nodiscard]] std::uint32_t last_half_edge_of_fan(std::uint32_t half_edge, std::uint32_t next_point) const;
  /// Finds the fans of all nodes that are not simple.
  void find_fans();

  World world_;
  PlanarMap map_;  // without the arrays that only the sweep needs
  std::vector<std::uint8_t> edge_is_covered_;
  BigVector<HalfEdge> half_edges_;
  BigVector<Node> nodes_;
  BigVector<std::uint32_t> node_at_;  // by point
  std::vector<Fan> fans_;
  std::vector<std::uint32_t> first_fan_;  // offsets into fans_ by node; empty if all nodes are simple
  BucketIndex left_edges_;
  std::vector<VertexId> invalid_edges_;
  BoxTree invalid_tree_;
};

}  // namespace arcway::internal

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "accel/base/big_vector.h"
#include "accel/expansion/by_site.h"
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
class SightMap {
 public:
  /// A half-edge and the triangle behind it, for somebody who looks across it into the triangle.
  struct Door {
    Vec2 apex;            ///< the triangle's third corner
    std::uint32_t left;   ///< the door from this triangle between its left end and the apex; kNone: a wall
    std::uint32_t right;  ///< the one between the apex and its right end
    std::uint32_t site;   ///< of the apex
    std::uint32_t node;   ///< first node at the apex, kNone if there is none
  };

  /// A graph vertex, and what tangency at it needs. Nodes of one ring follow each other, counter-clockwise around the
  /// obstacle from the ring's leftmost vertex.
  ///
  /// A node is *plain* if nothing but its ring meets its site: then the triangles around it are one fan, from its
  /// previous edge to its next one.
  struct Node {
    Vec2 at, previous, next;
    VertexId vertex;
    std::uint32_t site, previous_site, next_site;
    std::uint32_t sibling;     ///< the next node of the site, or kNone
    std::uint32_t before;      ///< the node at the previous vertex if both are plain, or kNone
    std::uint32_t after;       ///< the one at the next vertex
    std::uint32_t first_door;  ///< if plain, the one through the previous edge, which has the site at its left end
    std::uint32_t last_door;   ///< if plain, the one through the next edge, which has the site at its right end
    [[nodiscard]] bool is_plain() const { return first_door != kNone; }
  };

  /// Triangles around a site, counter-clockwise from one wall to the next, or all around it if no wall ends there. Each
  /// is behind a door whose left end is the site; a door's left is the next one in the fan.
  struct Fan {
    std::uint32_t door;
    std::uint32_t first_site;  ///< the other end of the first door
  };

  /// Six half-edges a vertex, and one bit for marks, fit into 32 bits.
  static constexpr std::size_t kMostVertices = std::size_t{1} << 28;

  /// O(n log n). Throws std::length_error beyond kMostVertices. The same for any executor.
  explicit SightMap(const World& world, const Executor& executor = SerialExecutor(),
                    Diagonals shortened = Diagonals::kAll);

  [[nodiscard]] std::span<const Door> doors() const { return doors_; }
  [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }
  /// Those of a node that is not plain.
  [[nodiscard]] std::span<const Fan> fans(std::uint32_t node) const {
    return std::span(fans_).subspan(first_fan_[node], first_fan_[node + 1] - first_fan_[node]);
  }
  /// Whether all nodes are plain.
  [[nodiscard]] bool is_plain() const { return first_fan_.empty(); }
  [[nodiscard]] std::span<const Vec2> sites() const { return map_.sites; }
  /// The site at a vertex of the world. O(log n).
  [[nodiscard]] std::uint32_t site_at(const Vec2& vertex) const;
  /// Cross products of differences of points within the frame have the right sign beyond this, however they are
  /// rounded.
  [[nodiscard]] double sure_cross_product() const;
  [[nodiscard]] std::uint32_t first_node_at(std::uint32_t site) const { return node_at_[site]; }

  /// The edges of the map that leave a site to the right.
  [[nodiscard]] std::span<const PlanarMap::Edge> edges_from(std::uint32_t site) const {
    return std::span(map_.edges).subspan(map_.first_edge[site], map_.first_edge[site + 1] - map_.first_edge[site]);
  }
  /// Those that reach it from the left, by index; needs list_left_edges.
  [[nodiscard]] std::span<const std::uint32_t> edges_to(std::uint32_t site) const { return left_edges_.of(site); }
  [[nodiscard]] const PlanarMap::Edge& edge(std::uint32_t index) const { return map_.edges[index]; }
  /// Makes `edges_to` possible.
  void list_left_edges();
  /// Whether an edge lies strictly inside a region that is whole.
  [[nodiscard]] bool is_covered(const PlanarMap::Edge& edge) const {
    return edge_is_covered_[static_cast<std::size_t>(&edge - map_.edges.data())] != 0;
  }

  /// Whether all regions are whole: then walls and triangles say all there is to say about lines of sight.
  [[nodiscard]] bool is_whole() const { return map_.broken.empty(); }
  [[nodiscard]] std::size_t broken_count() const { return map_.broken.size(); }
  /// Whether an edge of a region that is not whole blocks the segment.
  [[nodiscard]] bool is_blocked_by_broken(const LineSegment& segment) const;

 private:
  /// A ring of the world; all rings' nodes follow each other in the order of the tiles of their leftmost sites.
  struct Ring {
    VertexId leftmost;
    std::uint32_t first_node, nodes;
  };
  struct NodeOrder {
    std::vector<Ring> rings;
    std::uint32_t node_count = 0;
    std::vector<std::uint32_t> shared_sites;  ///< that have several nodes
  };
  /// Free space of the map, if it is one; and the order of nodes.
  std::optional<FreeSpace> sweep(const Executor& executor, NodeOrder& order);
  /// Sets `node_at_`.
  NodeOrder number_nodes();

  /// The door that leads into free space through a wall, by the site at its left end.
  struct alignas(8) Wall {
    std::uint32_t door;
    std::uint32_t right;  ///< site at its other end
  };
  static constexpr Wall kNoWall{kNone, kNone}, kSeveralWalls{0, kNone};
  /// Doors in the order of the tiles of their triangles.
  BigVector<Wall> lay_out_doors(Triangulation triangulation, const Executor& executor);
  void lay_out_nodes(const NodeOrder& order, BigVector<Wall> walls, const Executor& executor);
  /// Returns whether all nodes are plain.
  bool lay_out_ring(const Ring& ring, std::span<const Wall> walls);
  [[nodiscard]] std::uint32_t last_door_of_fan(std::uint32_t door, std::uint32_t next_site) const;
  /// Those of all nodes that are not plain.
  void find_fans();

  World world_;
  PlanarMap map_;  // without what only the sweep needs
  std::vector<std::uint8_t> edge_is_covered_;
  BigVector<Door> doors_;
  BigVector<Node> nodes_;
  BigVector<std::uint32_t> node_at_;  // by site
  std::vector<Fan> fans_;
  std::vector<std::uint32_t> first_fan_;  // by node, none of plain ones; empty if all are
  BySite left_edges_;
  std::vector<VertexId> broken_edges_;
  BoxTree broken_tree_;
};

}  // namespace arcway::internal

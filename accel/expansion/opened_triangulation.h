#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "accel/base/shared_pages.h"
#include "accel/expansion/free_space_triangulation.h"
#include "accel/expansion/triangle_blocks.h"
#include "arcway/vec2.h"
#include "arcway/world.h"

namespace arcway::internal {

/// The triangulated free space of a world, and the insides of obstacles that have been removed since: lines of sight
/// pass them. Each inside has triangles of its own, which are joined to those around it. So a removed obstacle takes
/// time by its own size, wherever it lies. Copies share what they have in common.
///
/// A half-edge that crosses a side into its triangle has the number of that side; see FreeSpaceTriangulation. Those of
/// insides follow all others.
class OpenedTriangulation {
 public:
  using HalfEdge = FreeSpaceTriangulation::HalfEdge;
  using Corners = std::array<std::uint32_t, 3>;  ///< points of a triangle's corners

  /// Nothing is opened yet.
  /// @param triangulation  must have listed its left edges to be opened, and must outlive this and its copies.
  /// @param blocks  of the triangulation, to find triangles near a place without looking at all; may be null.
  explicit OpenedTriangulation(const FreeSpaceTriangulation& triangulation, const TriangleBlocks* blocks = nullptr);

  /// Opens an obstacle of the world. O(k log k + triangles near it) for k vertices, beside a test of each opened
  /// obstacle's box.
  /// @return false if it and another opened one lie across each other or in each other. Then lines of sight that cross
  ///   both might be missed, and this may no longer be used.
  [[nodiscard]] bool open(const World& world, ObstacleId obstacle);
  /// Number of vertices of all opened obstacles.
  [[nodiscard]] std::size_t opened_vertices() const { return opened_vertices_; }

  [[nodiscard]] const FreeSpaceTriangulation& triangulation() const { return triangulation_; }
  [[nodiscard]] const TriangleBlocks* blocks() const { return blocks_; }

  [[nodiscard]] const HalfEdge& half_edge(std::uint32_t h) const {
    return h < own_count_ ? triangulation_.half_edges()[h] : inside_half_edge(h);
  }
  /// The half-edge that leaves a triangle through a side; kNone on the boundary.
  [[nodiscard]] std::uint32_t beyond(std::uint32_t side) const {
    const std::uint32_t twin = half_edge(Triangulation::next(side)).left;
    return twin != kNone ? twin : joined_to(side);
  }
  /// As `left` and `right` of a half-edge, also out of insides and into them.
  [[nodiscard]] std::uint32_t left_of(std::uint32_t h) const {
    const std::uint32_t left = half_edge(h).left;
    return left != kNone ? left : joined_to(Triangulation::previous(h));
  }
  [[nodiscard]] std::uint32_t right_of(std::uint32_t h) const {
    const std::uint32_t right = half_edge(h).right;
    return right != kNone ? right : joined_to(Triangulation::next(h));
  }
  /// @param first  the first half-edge of the triangle.
  [[nodiscard]] Corners corners_of(std::uint32_t first) const {
    const HalfEdge* const half_edges = &half_edge(first);
    return {half_edges[1].point, half_edges[2].point, half_edges[0].point};
  }
  /// Where these corners are.
  [[nodiscard]] std::array<Vec2, 3> positions_of(std::uint32_t first) const {
    const HalfEdge* const half_edges = &half_edge(first);
    return {half_edges[1].apex, half_edges[2].apex, half_edges[0].apex};
  }
  [[nodiscard]] Box box_of(std::uint32_t first) const;
  /// Whether a box and a triangle may have a point in common. False only if they have none.
  [[nodiscard]] bool may_meet(std::uint32_t first, const Box& box) const;

  /// Calls visit(first half-edge) for all triangles that may meet one of some boxes, and others near by.
  template <class Visit>
  void visit_near(std::span<const Box> boxes, const Visit& visit) const {
    const auto own_triangles = static_cast<std::uint32_t>(own_count_ / 3);
    for (const auto& [first, last] :
         blocks_ ? blocks_->triangles_near(boxes) : TriangleBlocks::Ranges{{0, own_triangles}})
      for (std::uint32_t triangle = first; triangle < last; ++triangle) visit(3 * triangle);
    for (const Opened& opened : opened_) {
      if (!overlaps_any(opened.box, boxes)) continue;
      for (std::uint32_t i = 0; i < opened.inside->half_edges.size(); i += 3) visit(opened.first_half_edge + i);
    }
  }

  /// Calls visit(edge, its box) for all edges of the triangulation's map near some boxes, and others.
  template <class Visit>
  void visit_boundary_near(std::span<const Box> boxes, const Visit& visit) const {
    const std::span<const Vec2> points = triangulation_.points();
    const auto all = static_cast<std::uint32_t>(points.size());
    for (const auto& [first, last] : blocks_ ? blocks_->points_near(boxes) : TriangleBlocks::Ranges{{0, all}})
      for (std::uint32_t point = first; point < last; ++point)
        for (const PlanarMap::Edge& edge : triangulation_.edges_from(point))
          visit(edge, arcway::box_of(LineSegment{points[edge.low], points[edge.high]}));
  }

 private:
  // A side of a triangle on the boundary. It leads from one point to another, the triangle on its left.
  struct Side {
    std::uint32_t from, to, number;
    friend auto operator<=>(const Side&, const Side&) = default;  // NOLINT(modernize-use-nullptr): <compare> has it
  };
  struct Inside {
    std::vector<HalfEdge> half_edges;
    std::vector<Side> rim;  // ascending
  };
  struct Opened {
    ObstacleId obstacle;
    Box box;
    std::uint32_t first_half_edge;
    std::shared_ptr<const Inside> inside;
  };
  using Pieces = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // edges of the map, the obstacle on their left

  [[nodiscard]] static bool overlaps_any(const Box& box, std::span<const Box> boxes);
  [[nodiscard]] static const Side* find(const std::vector<Side>& sides, std::uint32_t from, std::uint32_t to);
  [[nodiscard]] std::uint32_t joined_to(std::uint32_t side) const {
    const auto other = joints_.of(side);
    return other.empty() ? kNone : other.front().number;
  }
  [[nodiscard]] const HalfEdge& inside_half_edge(std::uint32_t h) const;
  [[nodiscard]] Pieces pieces_of(const World& world, ObstacleId obstacle) const;
  [[nodiscard]] std::vector<Side> sides_around(const Pieces& pieces, const Box& box) const;
  [[nodiscard]] std::shared_ptr<const Inside> inside_of(const Pieces& pieces, std::uint32_t first_half_edge) const;
  void join(std::uint32_t side, std::uint32_t other);
  [[nodiscard]] bool join_both_sides(const Pieces& pieces, const std::vector<Side>& around);
  [[nodiscard]] bool join_rim(const Opened& opened, const std::vector<Side>& around);
  [[nodiscard]] bool is_apart(const World& world, const Opened& one, const Opened& other) const;

  const FreeSpaceTriangulation& triangulation_;
  const TriangleBlocks* blocks_;
  std::size_t own_count_;  // half-edges of the triangulation
  std::size_t opened_vertices_ = 0;
  std::uint32_t next_half_edge_;
  SharedTable joints_;          // by side: the one beyond it
  std::vector<Opened> opened_;  // ascending by half-edges
};

}  // namespace arcway::internal

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/expansion/free_space_triangulation.h"
#include "arcway/vec2.h"

namespace arcway::internal {

/// Boxes of triangles, and of boundary edges, that follow each other in memory: to find those near a place without
/// looking at all; and the convex hull, beyond which there are no triangles. Immutable. O(n) to build, half a byte a
/// vertex.
class TriangleBlocks {
 public:
  static constexpr std::size_t kInBlock = 64;
  explicit TriangleBlocks(const FreeSpaceTriangulation& triangulation);

  [[nodiscard]] const Box& of_triangle(std::size_t triangle) const { return triangles_[triangle / kInBlock]; }
  /// The box of all boundary edges that leave points of the same block.
  [[nodiscard]] const Box& of_point(std::size_t point) const { return points_[point / kInBlock]; }
  /// Whether a box lies within the convex hull of all points.
  [[nodiscard]] bool hull_contains(const Box& box) const;

 private:
  std::vector<Box> triangles_, points_;
  std::vector<Vec2> hull_;  // counter-clockwise
};

/// Conservative visibility of a change: marks all nodes with a line of sight to some place, and some others.
///
/// A line of sight leaves a triangle that meets the place through one of its sides, and then crosses half-edges. Which
/// triangle depends on its last point in the place:
/// 1. It lies in a triangle that is large beside the place. The line leaves that one; the box that it has within the
///    place stands for the point.
/// 2. Else it is the last triangle on the line that meets the place and is not large. All points of the triangle stand
///    for those of the place.
///
/// Each cone is bounded by the two vertices that split it last. A point beyond such a vertex, as seen from all corners
/// of the triangle or of the box, is hidden.
class ChangeVisibility {
 public:
  /// @param triangulation  must have listed its left edges.
  /// @param blocks  of the triangulation; may be null.
  explicit ChangeVisibility(const FreeSpaceTriangulation& triangulation, const TriangleBlocks* blocks = nullptr)
      : triangulation_(triangulation), blocks_(blocks), seen_(triangulation.nodes().size(), 0) {}

  /// Marks the nodes that may see a point of the places. O(triangles log places + triangles seen), with blocks a
  /// hundredth of the first; marks all nodes once several times as many triangles are seen as exist.
  void mark_viewers(std::span<const Box> places);
  /// By node: 1 if it may see one of the places.
  [[nodiscard]] const std::vector<std::uint8_t>& seen() const { return seen_; }

 private:
  struct Range {
    std::uint32_t half_edge;
    std::uint32_t low, high;  ///< points that all rays pass on their left and right; kNone: no bound
  };
  using Corners = std::array<std::uint32_t, 3>;  // points of a triangle's corners
  [[nodiscard]] Corners corners_of(std::size_t triangle) const;
  // Where rays begin: in a triangle; and in a box, if the triangle is large.
  struct Source {
    std::array<Vec2, 3> triangle;
    bool is_large;
    std::array<Vec2, 4> box;
  };
  [[nodiscard]] Box box_of(std::span<const std::uint32_t> points) const;
  [[nodiscard]] bool is_large(const Corners& corners, const Box& place) const;
  void expand_out_of(std::size_t triangle, const Corners& corners, const Box& place);
  void expand(const Source& source, Range range);
  void follow_boundary(const PlanarMap::Edge& boundary);
  void mark(std::uint32_t first_node);
  [[nodiscard]] bool meets(const Corners& corners, const Box& place) const;
  [[nodiscard]] bool all_pass(const Source& source, std::uint32_t through, std::uint32_t point, int side) const;

  const FreeSpaceTriangulation& triangulation_;
  const TriangleBlocks* blocks_;
  std::vector<std::uint8_t> seen_;
  std::vector<Range> stack_;
  std::size_t steps_ = 0;
  bool gives_up_ = false;  // all nodes have been marked
};

}  // namespace arcway::internal

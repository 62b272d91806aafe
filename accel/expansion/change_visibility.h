#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/expansion/free_space_triangulation.h"

namespace arcway::internal {

/// Conservative visibility of a change: marks all nodes with a line of sight to some place, and some others.
///
/// A line of sight leaves the last triangle that meets the place through one of its sides, and then crosses half-edges.
/// All points of that triangle stand for the points of the place. Each cone is bounded by the two vertices that split
/// it last. A point beyond such a vertex, as seen from all corners of the triangle, is hidden.
class ChangeVisibility {
 public:
  /// @param triangulation  must have listed its left edges.
  explicit ChangeVisibility(const FreeSpaceTriangulation& triangulation)
      : triangulation_(triangulation), seen_(triangulation.nodes().size(), 0) {}

  /// Marks the nodes that may see a point of the places. O(triangles log places + triangles seen); marks all nodes once
  /// more triangles are seen than exist.
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
  void expand_out_of(std::size_t triangle, const Corners& corners, const Box& place);
  void expand(const Corners& corners, Range range);
  void follow_boundary(const PlanarMap::Edge& boundary);
  void mark(std::uint32_t first_node);
  [[nodiscard]] bool meets(const Corners& corners, const Box& place) const;
  [[nodiscard]] bool all_pass(const Corners& corners, std::uint32_t through, std::uint32_t point, int side) const;

  const FreeSpaceTriangulation& triangulation_;
  std::vector<std::uint8_t> seen_;
  std::vector<Range> stack_;
  std::size_t steps_ = 0;
  bool gives_up_ = false;  // all nodes have been marked
};

}  // namespace arcway::internal

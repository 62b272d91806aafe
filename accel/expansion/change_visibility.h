#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/expansion/free_space_triangulation.h"

namespace arcway::internal {

/// Finds the nodes from which some point near a place may be seen: all that see one, and others.
///
/// A line of sight from the place leaves the last triangle that meets it through a side that leads away, and then
/// passes through half-edges. The points of that triangle stand for those of the place. Between half-edges, sights are
/// limited by the two vertices that they have last been split at: what lies beyond one as seen from all corners of the
/// triangle is in its shadow.
class ChangeVisibility {
 public:
  /// @param map  with its left edges listed.
  explicit ChangeVisibility(const FreeSpaceTriangulation& triangulation)
      : triangulation_(triangulation), seen_(triangulation.nodes().size(), 0) {}

  /// O(triangles log places), and what is seen; no more than looking from everywhere is worth.
  void mark_viewers(std::span<const Box> places);
  /// By node, 1 if it may see one of the places.
  [[nodiscard]] const std::vector<std::uint8_t>& seen() const { return seen_; }

 private:
  struct Range {
    std::uint32_t half_edge;
    std::uint32_t low, high;  ///< points that all rays pass on the left, on the right; kNone: none
  };
  using Corners = std::array<std::uint32_t, 3>;  // points of a triangle
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
  bool gives_up_ = false;  // all nodes are marked
};

}  // namespace arcway::internal

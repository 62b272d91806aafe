#pragma once

#include <cstdint>
#include <vector>

#include "accel/expansion/free_space_triangulation.h"
#include "accel/expansion/line_of_sight_trace.h"

namespace arcway::internal {

/// Visibility of a point in all directions by triangular expansion [Bungiu et al. 2014]. Every decision is exact.
/// Immutable and thread-safe.
class TriangularExpansion {
 public:
  /// An open cone of directions seen through an edge of a triangle, between two points.
  struct View {
    std::uint32_t right, left;  ///< ends of the edge
    std::uint32_t half_edge;    ///< kNone on the boundary
    std::uint32_t low, high;    ///< points on the two bounding rays
    Vec2 to_low, to_high;       ///< from the viewpoint, rounded
  };
  /// Memory of one call, kept for the next one.
  struct Scratch {
    std::vector<std::uint32_t> triangles;  ///< input: triangles at the viewpoint
    std::vector<std::uint32_t> points;
    std::vector<View> views, boundary;
    std::vector<View> postponed;
  };

  /// @param triangulation, trace  of the same world; must outlive this.
  TriangularExpansion(const FreeSpaceTriangulation& triangulation, const LineOfSightTrace& trace)
      : triangulation_(triangulation), trace_(trace), sure_(triangulation.sure_cross_product()) {}

  /// Sets `boundary` to the visible pieces of boundary edges and of the frame, counter-clockwise from +x, with
  /// `half_edge` kNone. Appends to `points` the points seen on the way. O(triangles seen).
  void find_boundary(const Vec2& p, Scratch& scratch) const;
  /// Sets `points` to all points that p sees except its own, in no order, some of them several times. O(triangles
  /// seen).
  /// @param own  index of the point at p, or kNone.
  void find_points(const Vec2& p, std::uint32_t own, Scratch& scratch) const;

 private:
  void find_views(const Vec2& p, Scratch& scratch) const;
  void expand(const Vec2& p, const View& view, Scratch& scratch) const;
  void follow_lines_between_pieces(const Vec2& p, Scratch& scratch) const;
  void follow_edges_between_obstacles(const Vec2& p, std::uint32_t own, Scratch& scratch) const;
  [[nodiscard]] int side(const Vec2& p, std::uint32_t point, const Vec2& to_point,
                         const FreeSpaceTriangulation::HalfEdge& triangle) const;
  [[nodiscard]] bool is_on(const Vec2& p, std::uint32_t point, std::uint32_t toward) const;
  [[nodiscard]] bool is_of_one_boundary(std::uint32_t point) const;

  const FreeSpaceTriangulation& triangulation_;
  const LineOfSightTrace& trace_;
  double sure_;  ///< FreeSpaceTriangulation::sure_cross_product
};

}  // namespace arcway::internal

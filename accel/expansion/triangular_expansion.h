#pragma once

#include <cstdint>
#include <vector>

#include "accel/expansion/free_space_triangulation.h"
#include "accel/expansion/line_of_sight_trace.h"

namespace arcway::internal {

/// What a point sees in all directions, by triangular expansion [Bungiu et al. 2014] through a free-space
/// triangulation. Every decision is exact. Immutable and thread-safe.
class TriangularExpansion {
 public:
  /// What is seen through an edge of a triangle, between two directions towards points; without the limits themselves.
  struct View {
    std::uint32_t right, left;  ///< ends of the edge
    std::uint32_t half_edge;    ///< kNone: a wall
    std::uint32_t low, high;    ///< points that limit the directions
    Vec2 to_low, to_high;       ///< from the point, rounded
  };
  /// Memory of a question, kept for the next one.
  struct Scratch {
    std::vector<std::uint32_t> triangles;  ///< those at the point, to be set before
    std::vector<std::uint32_t> points;
    std::vector<View> views, boundary;
    std::vector<View> postponed;
  };

  /// @param map, trace  of the same map; outlive this.
  TriangularExpansion(const FreeSpaceTriangulation& triangulation, const LineOfSightTrace& trace)
      : triangulation_(triangulation), trace_(trace), sure_(triangulation.sure_cross_product()) {}

  /// Sets `walls`: what p sees of walls and of the frame, counter-clockwise from +x, `half-edge` being kNone; and
  /// appends to `points` those that are seen on the way. O(triangles seen).
  void find_boundary(const Vec2& p, Scratch& scratch) const;
  /// Sets `points`: all that p sees, without its own one, in no order, some of them several times. O(triangles seen).
  /// @param own  the point at p, or kNone.
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

#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "accel/base/big_vector.h"
#include "arcway/world.h"

namespace arcway::internal {

/// A world as points and edges that meet in common ends only: the input of a plane sweep.
///
/// The points are the distinct positions of the world's vertices, ascending by (x, y). The corners of a frame around
/// them come first (two) and last (two). "To the right" means a larger index everywhere, so vertical edges are no
/// special case. An edge is an obstacle edge or, cut at the points on it, a piece of one; equal pieces are one edge. Of
/// two pieces that cross properly one is dropped.
///
/// A region that keeps all of its pieces is *valid*, and edges count valid regions only. The other regions are listed
/// as invalid: their edges are boundaries without an inside.
struct PlanarMap {
  struct Edge {
    std::uint32_t low, high;    ///< points, low < high
    std::int32_t above, below;  ///< number of valid regions that it bounds above and below
  };

  BigVector<Vec2> points;
  BigVector<std::uint32_t> point_of;    ///< by VertexId
  BigVector<Edge> edges;                ///< ascending by low, at a point by slope; the frame's come first (two)
  BigVector<std::uint32_t> first_edge;  ///< by point: its edges to the right are [first_edge[p], first_edge[p + 1])
  BigVector<std::uint32_t> incoming;    ///< by point: an edge that ends there, or kNone
  std::vector<ObstacleId> invalid;      ///< ascending
  bool outside_is_solid = false;        ///< the world has valid bounds
};

/// Makes a map of all obstacle edges without cutting them, which may violate the class's invariants. Overlapping edges
/// that start at a point are detected here, all other violations by the sweep. O(n) beside a radix sort.
/// @return false if edges overlap at a point.
bool make_uncut_map(const World& world, PlanarMap& map);

/// Makes a map whose invariants hold for any world, by cutting and dropping pieces. O(n log n + pairs of edges that
/// meet).
PlanarMap make_cut_map(const World& world);

/// Makes a map whose free space is what closed rings enclose. Everything beyond them is solid.
/// @param points  at least three, distinct, ascending by (x, y): all ends of the edges.
/// @param edges  from one point to another, by their places in `points`, with the free space on their left. They meet
///   in common ends only.
PlanarMap make_map_inside(std::span<const Vec2> points, std::span<const std::pair<std::uint32_t, std::uint32_t>> edges);

}  // namespace arcway::internal

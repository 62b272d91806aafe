#pragma once

#include <cstdint>
#include <vector>

#include "accel/base/big_vector.h"
#include "arcway/world.h"

namespace arcway::internal {

/// A world as points and edges that meet in common ends only: what a plane sweep takes.
///
/// Points are the distinct places of the world's vertices, ascending by (x, y), between the corners of a frame around
/// them: two before and two after all others. "To the right" means a larger point index everywhere, so that vertical
/// edges are no special case. An edge is an obstacle edge or, cut at the points on it, a piece of one; equal pieces are
/// one edge. Of two pieces that cross properly one is left out.
///
/// A region all of whose pieces are there is *whole*; edges count whole regions only. All other regions are listed as
/// broken: their edges are walls with no inside.
struct PlanarMap {
  struct Edge {
    std::uint32_t low, high;    ///< points, low < high
    std::int32_t above, below;  ///< whole regions that it bounds and that lie on its upper, lower side
  };

  BigVector<Vec2> points;
  BigVector<std::uint32_t> point_of;    ///< by VertexId
  BigVector<Edge> edges;                ///< ascending by low, at a point by slope; the first two are the frame's
  BigVector<std::uint32_t> first_edge;  ///< by point: its edges to the right are [first_edge[s], first_edge[s + 1])
  BigVector<std::uint32_t> incoming;    ///< by point: an edge that ends there, or kNone
  std::vector<ObstacleId> invalid;      ///< ascending
  bool outside_is_solid = false;        ///< the world has bounds, and they are whole
};

/// Takes all obstacle edges as they are, which may violate what is promised above: overlapping edges that start at a
/// point are noticed here, everything else by the sweep. O(n) beside a radix sort.
/// @return false if edges overlap at a point.
bool make_uncut_map(const World& world, PlanarMap& map);

/// Cuts and drops as promised, whatever the world. O(n log n + pairs of edges that meet).
PlanarMap make_cut_map(const World& world);

}  // namespace arcway::internal

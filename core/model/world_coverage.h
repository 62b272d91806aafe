#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arcway/world.h"

namespace arcway::internal {

/// Which vertices lie strictly inside a region, found for all of them by a few sweeps: for maps on which too many boxes
/// of regions overlap, as those of rings in rings do.
struct Coverage {
  std::vector<bool> covered;          ///< by vertex: strictly inside one of the regions that the sweeps took
  std::vector<ObstacleId> left_over;  ///< regions that cross many others, ascending: no sweep took them
};

/// Regions that cross each other are swept one after the other, each sweep with regions that do not: of regions that
/// cross up to seven others all are taken. O(n log n) for n edges.
/// @param edges      by vertex, the region on the left; no two of one region may cross.
/// @param region_of  by vertex.
/// @param bounds     the region that holds everything but a bounded part of the plane; kNone if there is none.
Coverage sweep_coverage(std::span<const LineSegment> edges, std::span<const ObstacleId> region_of, ObstacleId bounds);

}  // namespace arcway::internal

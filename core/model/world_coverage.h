#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/model/world.h"

namespace arcway {

/// Which vertices lie strictly inside a region, found for all of them by one sweep: for maps on which too many boxes of
/// regions overlap, as those of rings in rings do.
struct Coverage {
  std::vector<bool> covered;          ///< by vertex: strictly inside one of the regions that the sweep took
  std::vector<ObstacleId> left_over;  ///< regions that cross others, ascending: the sweep did not take them
};

/// O(n log n) for n edges.
/// @param edges      by vertex, the region on the left; no two of one region may cross.
/// @param region_of  by vertex.
/// @param bounds     the region that holds everything but a bounded part of the plane; kNone if there is none.
Coverage sweep_coverage(std::span<const LineSegment> edges, std::span<const ObstacleId> region_of, ObstacleId bounds);

}  // namespace arcway

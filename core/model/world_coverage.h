#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arcway/world.h"

namespace arcway::internal {

/// The vertices that lie strictly inside a region, found for all vertices by a few sweeps. It serves maps with many
/// overlapping boxes of regions, such as rings within rings.
struct Coverage {
  std::vector<bool> covered;          ///< by vertex: strictly inside a region that was swept
  std::vector<ObstacleId> left_over;  ///< regions that cross many others and were not swept, ascending
};

/// Sweeps over regions in groups of regions that do not cross each other. If regions cross up to seven others, all are
/// swept. O(n log n) for n edges.
/// @param edges  by vertex, the region on the left; no two of one region may cross.
/// @param region_of  by vertex.
/// @param bounds  the region that holds everything but a bounded part of the plane; kNone if there is none.
Coverage sweep_coverage(std::span<const LineSegment> edges, std::span<const ObstacleId> region_of, ObstacleId bounds);

}  // namespace arcway::internal

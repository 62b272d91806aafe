#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "accel/triangulation/planar_map.h"
#include "accel/triangulation/triangulation.h"
#include "arcway/executor.h"

namespace arcway::internal {

/// The triangulated part of the frame outside all valid regions.
struct FreeSpace {
  Triangulation triangulation;
  std::vector<std::uint8_t> edge_is_covered;  ///< by edge of the map: whether it lies strictly inside a valid region
};

/// Triangulates free space by one plane sweep over the gaps between neighboring edges [Hertel and Mehlhorn 1985]. Each
/// gap keeps the front of its triangles as a chain; every point adds the triangles that it sees. A point may have any
/// number of edges on either side. O(n log n), exact.
/// @return nothing if edges of the map meet elsewhere than in common ends; neighbors are tested when they become
///   neighbors [Shamos and Hoey 1976].
/// @param executor  asked only whether to stop.
/// @throws Canceled if it is to stop.
std::optional<FreeSpace> triangulate_free_space(const PlanarMap& map, const Executor& executor);

}  // namespace arcway::internal

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "accel/triangulation/planar_map.h"
#include "accel/triangulation/triangulation.h"
#include "arcway/executor.h"

namespace arcway::internal {

/// The part of the frame that lies in no whole region, triangulated; and which edges lie strictly inside one.
struct FreeSpace {
  Triangulation triangulation;
  std::vector<std::uint8_t> edge_is_covered;  ///< by edge of the map
};

/// One sweep from left to right over the gaps between neighboring edges [Hertel and Mehlhorn 1985]: each gap keeps the
/// front of its triangles as a chain, to which every point adds the triangles that it sees. Any point may have any
/// number of edges on either side. O(n log n), exact.
/// @return nothing if edges of the map meet elsewhere than in common ends: neighbors are tested as they become so
///   [Shamos and Hoey 1976].
/// @param executor  only asked whether to end. @throws Cancelled then
std::optional<FreeSpace> triangulate_free_space(const PlanarMap& map, const Executor& executor);

}  // namespace arcway::internal

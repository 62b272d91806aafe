#pragma once

#include <cstddef>
#include <vector>

#include "arcway/polygon.h"
#include "arcway/snapshot.h"
#include "arcway/world.h"

/// What World demands of a map.
namespace arcway::internal {

/// @param obstacles  their number, that of the bounds in the error.
/// @throws WorldError if there are more vertices than ids.
void require_vertex_count(std::size_t count, ObstacleId obstacles);

/// @param id  the number of obstacles for the bounds.
/// @return the polygon's contacts with itself.
/// @throws WorldError as World says.
std::vector<RingContact> require_region(const Polygon& polygon, ObstacleId id, bool is_bounds);

/// Everything that memory safety and the predicates rely on.
/// @throws SnapshotError if the snapshot is that of no world.
void require_world(const WorldSnapshot& snapshot);

}  // namespace arcway::internal

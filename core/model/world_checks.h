#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arcway/polygon.h"
#include "arcway/snapshot.h"
#include "arcway/world.h"
#include "arcway/zone.h"

namespace arcway::internal {

/// The number of vertices of some polygons.
std::size_t vertex_count_of(std::span<const Polygon> polygons);

/// Checks that a map's vertices have ids.
/// @param obstacles  their number, that of the bounds in the error.
/// @throws WorldError if there are more vertices than ids.
void require_vertex_count(std::size_t count, ObstacleId obstacles);

/// Checks one region as World documents.
/// @param id  of the obstacle; the number of obstacles for the bounds.
/// @return the polygon's contacts with itself.
/// @throws WorldError
std::vector<RingContact> require_region(const Polygon& polygon, ObstacleId id, bool is_bounds);

/// Checks the area and the rule of each zone.
/// @throws ZoneError for the first zone that is refused.
void require_zones(std::span<const Zone> zones);

/// Checks what memory safety and the predicates rely on.
/// @throws SnapshotError if no world has this snapshot.
void require_world(const WorldSnapshot& snapshot);

}  // namespace arcway::internal

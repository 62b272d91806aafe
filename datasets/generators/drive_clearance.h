#pragma once

// Private to datasets: whether obstacles keep away from a drive.

#include <span>

#include "arcway/path.h"
#include "arcway/polygon.h"
#include "arcway/vec2.h"
#include "arcway/vehicle.h"

namespace arcway::internal::detail {

/// Whether the polygon is proved to keep this distance from the body at every moment of the drive.
///
/// A line of a rectangle is decided by the rectangle that the body sweeps. An interval of an arc, or of a line of
/// another body, is decided at its middle. It is free if the distance there is at least the asked one plus the movement
/// of any point of the body within the interval. It is not free if the distance is below the asked one; otherwise both
/// halves are tested. Intervals in which the body moves less than a millionth of its reach count as too near.
/// O(vertices) for obstacles far away; more the nearer the polygon's distance is to the one asked for.
bool keeps_away(const Polygon& polygon, std::span<const PathSegment> drive, const Vehicle& vehicle, double distance);

/// A box that contains the body grown by `growth` at every moment of the drive.
Box box_of(std::span<const PathSegment> drive, const Footprint& body, double growth);

}  // namespace arcway::internal::detail

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arcway/moving_obstacle.h"
#include "arcway/path.h"
#include "arcway/vehicle.h"

namespace arcway::internal {

/// Places along a path and times at which the body would touch a moving obstacle: a convex polygon with the arc length
/// since the path's start [m] as x, and time [s] as y. Counter-clockwise; it may be flat.
struct BlockedPlaces {
  std::vector<Vec2> corners;
  double first, last;  ///< least and largest arc length
};

/// @throws std::invalid_argument naming the obstacle and the value, unless its numbers are finite, its outline simple
///   and its times in order.
void check_moving(std::span<const MovingObstacle> obstacles);

/// @throws std::invalid_argument naming the horizon, unless it is finite and > 0.
void check_horizon(double horizon);

/// What moving obstacles block of a path from time 0 to the horizon, for the body grown by half of the safety margin.
///
/// Two convex polygons touch iff F lies in the Minkowski sum of one and the mirrored other. On a line, the place of F
/// relative to the obstacle is an affine function of arc length and time: what is blocked is a polygon, exact up to
/// rounding. Arcs are cut into pieces, each covered by the hull of the body at both ends, grown by the height of the
/// arcs between: what is blocked is a rectangle that contains it. O(pieces x corners).
std::vector<BlockedPlaces> blocked_places(std::span<const PathSegment> path, const Vehicle& vehicle,
                                          std::span<const MovingObstacle> obstacles, double horizon);

}  // namespace arcway::internal

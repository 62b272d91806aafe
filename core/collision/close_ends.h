#pragma once

#include "arcway/path.h"
#include "arcway/vehicle.h"
#include "core/collision/clearance_cost.h"
#include "core/model/outlines.h"

namespace arcway::internal {

/// A lower bound on what driving close to obstacles costs on all paths between two poses [s], driven in any gears.
///
/// Proof, for one rule of a distance d.
/// 1. The body, grown by d, contains every disc of radius d about a point of the body. So F drives close wherever the
///    body itself is no further than d from an edge.
/// 2. F moves by ds on a curvature k, -1 / rho_right <= k <= 1 / rho_left. The point (x, y) of the body then moves by
///    |(1 - k y, k x)| ds. That is convex in k and in the point. So no point moves by more than X ds, where X is the
///    largest value at a corner of the bounding rectangle, on one of the two curvatures.
/// 3. At an end the body is c < d from an edge. Then F drives close for (d - c) / X from there at least, or all the
/// way.
/// 4. In a zone this holds as far as F cannot have left it: up to the distance of the end from the zone's border.
/// 5. Both parts may overlap only if they are the whole path. So F drives close for at least the smaller of their sum
///    and the length of the path.
/// @param length  that every path has at least [m].
/// @param outlines  of the world.
double close_ends_cost(const ClearanceCost& cost, const Vehicle& vehicle, const Outlines& outlines, const Pose& start,
                       const Pose& goal, double length);

}  // namespace arcway::internal

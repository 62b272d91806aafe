#pragma once

#include <limits>

#include "arcway/path.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "core/model/outlines.h"

namespace arcway::internal {

/// Where a body comes nearest to the obstacles.
struct Clearance {
  double distance = std::numeric_limits<double>::infinity();  ///< [m]; 0 in contact, infinity without edges
  double arc_length = 0.0;                                    ///< of the reference point from the segment's start [m]
  VertexId edge = kNone;                                      ///< the nearest edge
};

/// The smallest distance between a body and the edges of the world while it drives along a segment, in closed form.
/// Straight: from the swept rectangle. Turning: the nearest pair is a body corner on its circle and an edge, or an
/// obstacle vertex on its circle in the body's frame and a side of the body. Otherwise it occurs at one of the two
/// ends. Rounding: a few units in the last place of the largest of coordinates and turning radius. The body inside of
/// an obstacle without touching its boundary is not noticed. O(regions + edges of regions near by), no allocation;
/// thread-safe.
Clearance clearance_along(const PathSegment& segment, const Footprint& body, const World& world);

/// The same distance if it is below a limit, else the limit. Looks only at outlines nearer than that.
double clearance_below(double limit, const PathSegment& segment, const Footprint& body, const Outlines& outlines);

}  // namespace arcway::internal

#pragma once

#include <limits>

#include "arcway/path.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "core/model/outlines.h"

namespace arcway::internal {

/// The least distance between a body and the obstacles, and where it occurs.
struct Clearance {
  double distance = std::numeric_limits<double>::infinity();  ///< [m]; 0 in contact, infinity without edges
  double arc_length = 0.0;                                    ///< of the reference point from the segment's start [m]
  VertexId edge = kNone;                                      ///< the nearest edge
};

/// The clearance of a body on a segment, in closed form:
/// - On a line it is that of the swept rectangle, or of what the pieces of the body sweep.
/// - On an arc the nearest pair may be a corner of the body on its circle and an edge. It may also be an obstacle's
///   vertex, on its circle in the body's frame, and a side of the body.
/// - Else it occurs at one of the two ends.
///
/// Error: a few units in the last place of the largest coordinate or turning radius. A body that lies inside an
/// obstacle without touching its boundary is not noticed. O(regions + edges of regions near by), without allocation;
/// thread-safe.
Clearance clearance_along(const PathSegment& segment, const Body& body, const World& world);

/// The clearance if it is below a limit [m], else the limit. Examines only outlines nearer than that.
double clearance_below(double limit, const PathSegment& segment, const Body& body, const Outlines& outlines);

}  // namespace arcway::internal

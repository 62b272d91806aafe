#pragma once

#include <limits>

#include "core/path/path.h"
#include "core/vehicle.h"
#include "core/world.h"

namespace arcway {

/// Smallest distance between a moving body and the obstacles, and the obstacle edge where it is.
struct Clearance {
  double distance = std::numeric_limits<double>::infinity();  ///< [m]; infinity in a world without edges
  VertexId edge = kNone;
};

/// Smallest distance between the region boundaries and the body over one path segment, in closed form: of a line, that
/// of the swept rectangle; of an arc, the least of those between the arcs traced by the body's corners and the obstacle
/// edges, and, in the body's frame, between the arcs traced by the obstacle vertices and the body's sides. 0 where they
/// meet. Error: a few units in the last place of the coordinates. O(edges near the segment), thread-safe.
Clearance clearance_along(const PathSegment& segment, const Footprint& body, const World& world);

}  // namespace arcway

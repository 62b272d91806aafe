#pragma once

#include <optional>

#include "arcway/vec2.h"
#include "arcway/vehicle.h"

namespace arcway::internal {

/// How far an edge reaches over a side of a body, and how that changes as the body moves.
struct BodyContact {
  double depth;    ///< the least way out over any side, across it; negative: how far the edge is from the body [m]
  Vec2 by_place;   ///< gradient of the depth by the position of the body
  double by_turn;  ///< and by its heading [m/rad]
};

/// The contact of an edge with a body that follows a curvature. Where a corner passes, the depth over one side falls as
/// that over another one grows: the gradient is that of the deepest contact on the way. Constant time.
/// @param near  edges that are further from a side than this are none [m].
/// @param ahead  unit vector of the body's heading.
std::optional<BodyContact> body_contact(const Footprint& body, const Vec2& place, const Vec2& ahead, double curvature,
                                        const LineSegment& edge, double near);

}  // namespace arcway::internal

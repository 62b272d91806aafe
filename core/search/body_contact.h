#pragma once

#include <optional>

#include "arcway/vec2.h"
#include "arcway/vehicle.h"

namespace arcway::internal {

/// The contact of an edge with a body: how deep it reaches in, and how that changes as the body moves.
struct BodyContact {
  double depth;    ///< smallest shift out over any side [m]; negative: distance of the edge from the body
  Vec2 by_place;   ///< gradient of the depth by the position of the body
  double by_turn;  ///< derivative of the depth by its heading [m/rad]
};

/// The contact of an edge with a body that follows a curvature. Where a corner passes, the depth over one side falls as
/// that over another grows. The gradient is then that of the deepest contact on the way. Constant time.
/// @param near  edges further from a side than this have no contact [m].
/// @param ahead  unit vector of the body's heading.
std::optional<BodyContact> body_contact(const Footprint& body, const Vec2& place, const Vec2& ahead, double curvature,
                                        const LineSegment& edge, double near);

}  // namespace arcway::internal

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

/// A place on a motion of the body's reference point.
struct BodyMotion {
  Vec2 place;
  Vec2 ahead;        ///< unit vector of the body's heading
  double curvature;  ///< of the motion [1/m]
};

/// The contact of an edge with a body that follows a curvature. Where a corner passes, the depth over one side falls as
/// that over another grows. The gradient is then that of the deepest contact on the way. Constant time.
/// @param near  edges further from a side than this have no contact [m].
std::optional<BodyContact> body_contact(const Footprint& body, const BodyMotion& motion, const LineSegment& edge,
                                        double near);

/// A lower bound on the distance of an edge from a body at a place, with its heading along `ahead` [m]. Not above 0 if
/// they may touch. Constant time.
double distance_beside(const Footprint& body, const Vec2& place, const Vec2& ahead, const LineSegment& edge);

}  // namespace arcway::internal

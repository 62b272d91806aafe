#pragma once

#include <span>
#include <vector>

#include "arcway/vec2.h"

namespace arcway::internal {

/// A convex polygon with all sides moved outwards [m]. Where two sides would meet further than three times that
/// distance from their corner, the corner is cut off at right angles to its bisector, at that distance. Therefore
/// growing by a + b contains what is grown by a, and every disc of radius b about a point of it. O(n).
/// @param ring  counter-clockwise, without repeated vertices; three neighbors may lie on a line.
/// @param by  [m], >= 0.
std::vector<Vec2> grow_convex(std::span<const Vec2> ring, double by);

}  // namespace arcway::internal

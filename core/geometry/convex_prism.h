#pragma once

#include <span>
#include <vector>

#include "arcway/vec2.h"

namespace arcway::internal {

/// What a convex polygon sweeps when it moves along a line: a convex polygon again, which is decided on as its corners
/// are rounded.
/// @param from  corners before the motion, counter-clockwise, rounded.
/// @param to  the same corners after it, rounded; the same span if there is no motion.
/// @param ahead  by side, from corner i to the next one: +1 if it faces the motion, -1 if it faces backwards, 0 if it
///   lies along the motion.
/// @param prism  gets the corners, counter-clockwise. Rounding may leave fewer than 3 of them, or all on a line.
void convex_prism(std::span<const Vec2> from, std::span<const Vec2> to, std::span<const signed char> ahead,
                  std::vector<Vec2>& prism);

/// Whether a closed segment and a closed convex polygon have a common point. Exact on the given corners. The polygon
/// may be a segment or a point. Constant time a corner.
/// @param polygon  counter-clockwise, at least one corner.
bool meets_convex(const LineSegment& s, std::span<const Vec2> polygon);

}  // namespace arcway::internal

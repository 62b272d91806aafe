#pragma once

#include <vector>

#include "arcway/heading_set.h"
#include "arcway/polygon.h"
#include "arcway/vec2.h"

namespace arcway::internal {

/// Relative distance within which a critical angle counts as existing. One that does not exist only splits an interval
/// in vain; one that is lost by rounding could hide a contact.
inline constexpr double kCriticalSlack = 1e-9;

/// Appends the headings [rad] at which a convex piece of a turning body touches an obstacle edge. Contact changes only
/// at critical headings:
/// - A corner of the piece, on its circle, meets the edge.
/// - An end of the edge, on its circle about the center, meets a side of the piece.
///
/// Each interval between neighboring critical headings is decided once. O(corners) for each of them.
/// @param piece  counter-clockwise, in the frame of the body.
/// @param center  of the turn in that frame.
/// @param edge  about the center of the turn, in the frame of the world.
void append_blocked_by_piece(const Ring& piece, const Vec2& center, const LineSegment& edge,
                             std::vector<HeadingInterval>& blocked);

}  // namespace arcway::internal

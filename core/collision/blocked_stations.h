#pragma once

#include <vector>

#include "arcway/sweep_query.h"
#include "arcway/vec2.h"

namespace arcway::internal {

/// A part of a motion, by lengths or angles from a place on it.
struct BlockedRange {
  double low, high;
};

/// Appends the stations [m] at which a body that drives straight touches an obstacle edge: lengths that the reference
/// point has driven, from 0 to the length of the motion. They are one interval for each convex piece of the body, since
/// the edge is convex as well. Its ends are contacts of a corner of the piece with the edge, or of an end of the edge
/// with a side of the piece. Rounded to a few units in the last place of the distance between body and edge.
/// O(corners).
void append_blocked_stations(const StraightBody& body, const LineSegment& edge, std::vector<BlockedRange>& blocked);

/// The length of a union of ranges. They are left in an unspecified order. O(n log n).
double length_of_union(std::vector<BlockedRange>& ranges);

}  // namespace arcway::internal

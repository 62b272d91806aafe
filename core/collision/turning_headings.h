#pragma once

#include <vector>

#include "arcway/sweep_query.h"
#include "arcway/vec2.h"

namespace arcway::internal {

/// Appends the headings at which a turning body touches an obstacle edge. The status changes only at
/// critical angles (a body corner's circle meets the edge; an end of the edge, on its circle, meets a side of the
/// body): they are computed, and each interval between neighbors is decided once. Constant time.
void append_blocked_headings(const TurningBody& body, const LineSegment& edge, std::vector<HeadingInterval>& blocked);

/// Whether an edge comes near enough to the body's annulus to be worth the call above; never false for an edge that
/// the body touches at some heading.
bool may_touch(const TurningBody& body, const LineSegment& edge);

/// Distance from a turning body's center within which all edges lie that it can touch.
double reach_of(const TurningBody& body);

/// The middle of a turning body at a heading: a point of the body, as its reference point need not be.
Vec2 middle_at(const TurningBody& body, double heading);

}  // namespace arcway::internal

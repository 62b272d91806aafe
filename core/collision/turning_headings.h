#pragma once

#include <vector>

#include "arcway/sweep_query.h"
#include "arcway/vec2.h"

namespace arcway::internal {

/// Appends the headings [rad] at which a turning body touches an obstacle edge. Contact changes only at critical
/// headings, which are computed:
/// - A corner of the body, on its circle, meets the edge.
/// - An end of the edge, on its circle about the center, meets a side of the body. Each interval between neighboring
///   critical headings is decided once. Constant time.
void append_blocked_headings(const TurningBody& body, const LineSegment& edge, std::vector<HeadingInterval>& blocked);

/// Whether an edge is near enough to the body's annulus for append_blocked_headings to be worth a call. Never false for
/// an edge that the body touches at some heading.
bool may_touch(const TurningBody& body, const LineSegment& edge);

/// The distance from a turning body's center within which all edges lie that it can touch [m].
double reach_of(const TurningBody& body);

/// The middle of a turning body at a heading [m]. It is a point of the body, which the reference point need not be.
Vec2 middle_at(const TurningBody& body, double heading);

}  // namespace arcway::internal

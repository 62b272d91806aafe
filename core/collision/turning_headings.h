#pragma once

#include <vector>

#include "arcway/heading_set.h"
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

/// Takes closed intervals of headings out of a set. A set that none are taken out of keeps its bits.
/// @param blocked  in any order; unspecified afterwards, keeps its memory.
void remove_headings(std::vector<HeadingInterval>& blocked, HeadingSet& free);

/// The distance from a turning body's center within which all edges lie that it can touch [m].
double reach_of(const TurningBody& body);

/// Whether a test holds for a point of any connected part of a turning body at a heading. The point is one of the part,
/// which the reference point need not be.
template <class Test>
bool has_inner_point(const TurningBody& body, double heading, const Test& test) {
  const Vec2 ahead = direction_of(heading), aside = perpendicular(ahead);
  const Vec2 place = body.center - sign_of(body.side) * body.radius * aside;
  if (body.body.shape == nullptr) return test(middle_of(body.body, {place.x(), place.y(), heading}));
  for (const Vec2& p : body.body.shape->inner_points)
    if (test(Vec2(place + p.x() * ahead + p.y() * aside))) return true;
  return false;
}

}  // namespace arcway::internal

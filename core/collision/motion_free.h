#pragma once

#include <span>

#include "arcway/heading_set.h"
#include "arcway/path.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"

namespace arcway::internal {

/// Whether the body touches nothing along all segments, in whichever gear: the swept rectangle of each line and an
/// interval of free headings on each arc. As exact as the sweep query, without steps. Lines are asked first, as they
/// cost less.
bool motion_free(const SweepQuery& sweep, const Body& body, std::span<const PathSegment> motion);
/// @param headings  memory that is used again.
bool motion_free(const SweepQuery& sweep, const Body& body, std::span<const PathSegment> motion, HeadingSet& headings);

/// A body that drives an arc forwards.
TurningBody turning_body(const PathSegment& arc, const Body& body);

/// Whether the body touches nothing along one arc, in whichever gear.
/// @param headings  memory that is used again.
bool turn_free(const SweepQuery& sweep, const Body& body, const PathSegment& turn, HeadingSet& headings);

}  // namespace arcway::internal

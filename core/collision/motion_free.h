#pragma once

#include <span>

#include "arcway/heading_set.h"
#include "arcway/path.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"

namespace arcway::internal {

/// Whether the body touches nothing along all segments, in whichever gear: the swept rectangle for each line, a free
/// interval of headings for each arc. Exact as the sweep query is; no step size. Lines are asked for first: a rectangle
/// costs less than a set of headings.
bool motion_free(const SweepQuery& sweep, const Footprint& body, std::span<const PathSegment> motion);

/// The same for one arc driven forwards; `headings` is memory that is used again.
bool turn_free(const SweepQuery& sweep, const Footprint& body, const PathSegment& arc, HeadingSet& headings);

}  // namespace arcway::internal

#pragma once

#include <vector>

#include "arcway/polygon.h"

namespace arcway::internal {

/// Whether `find_conflict` finds a conflict in a polygon without repeated consecutive vertices. O(n log n), whatever
/// the polygon: it sweeps over the edges, while `find_conflict` searches their boxes, which is faster where few of them
/// overlap. Exact.
/// @param contacts  as find_conflict's.
bool has_conflict(const Polygon& polygon, std::vector<RingContact>* contacts = nullptr);

/// Whether all holes lie in the outer ring and none in another one. O(n log n), exact.
/// @param polygon  without conflicts.
bool holes_are_nested(const Polygon& polygon);

}  // namespace arcway::internal

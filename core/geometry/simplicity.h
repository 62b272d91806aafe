#pragma once

#include <vector>

#include "arcway/polygon.h"

namespace arcway::internal {

/// Whether a polygon without repeated consecutive vertices is self-intersecting: whether find_conflict finds a
/// conflict. It sweeps over the edges in O(n log n) for any polygon. find_conflict searches their boxes, which is
/// faster where few boxes overlap. Exact.
/// @param contacts  as in find_conflict.
bool has_conflict(const Polygon& polygon, std::vector<RingContact>* contacts = nullptr);

/// Whether all holes lie in the outer ring, and none in another hole. O(n log n), exact.
bool holes_are_nested(const Polygon& polygon);

}  // namespace arcway::internal

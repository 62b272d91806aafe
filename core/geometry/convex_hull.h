#pragma once

#include <vector>

#include "arcway/vec2.h"

namespace arcway::internal {

/// Replaces points by the corners of their convex hull, counter-clockwise; by both ends, if they lie on a line. Exact.
/// O(n log n).
void replace_by_hull(std::vector<Vec2>& points);

}  // namespace arcway::internal

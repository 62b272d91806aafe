#pragma once

#include <limits>

#include "arcway/vec2.h"

namespace arcway::internal {

/// Two points as near to each other as two closed sets are.
struct ClosestPair {
  double distance = std::numeric_limits<double>::infinity();  ///< as distance.h gives it [m]
  Vec2 a{0.0, 0.0};
  Vec2 b{0.0, 0.0};
};

/// Of two segments; where they meet, twice the same point, rounded.
ClosestPair closest_pair(const LineSegment& s, const LineSegment& t);

}  // namespace arcway::internal

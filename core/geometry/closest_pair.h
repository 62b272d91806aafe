#pragma once

#include <limits>

#include "arcway/vec2.h"

namespace arcway::internal {

/// Two points of two closed sets that are as near to each other as the sets.
struct ClosestPair {
  double distance = std::numeric_limits<double>::infinity();  ///< as distance.h computes it [m]
  Vec2 a{0.0, 0.0};
  Vec2 b{0.0, 0.0};
};

/// The closest pair of two segments; where they meet, one common point twice, rounded.
ClosestPair closest_pair(const LineSegment& s, const LineSegment& t);

}  // namespace arcway::internal

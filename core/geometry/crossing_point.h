#pragma once

#include "core/geometry/predicates.h"

namespace arcway::internal {

/// Where a segment meets the line through two points that its ends do not lie on the same side of, nor both on:
/// rounded, however small the angle between them; the end itself if that is on the line.
inline Vec2 crossing_point(const LineSegment& s, const LineSegment& line) {
  // The ends' distances from the line have opposite signs, so that nothing cancels.
  const double from_a = doubled_area(line.a, line.b, s.a), from_b = doubled_area(line.a, line.b, s.b);
  if (from_b == 0.0) return s.b;
  return s.a + from_a / (from_a - from_b) * (s.b - s.a);
}

}  // namespace arcway::internal

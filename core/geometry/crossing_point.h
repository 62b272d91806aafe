#pragma once

#include "core/geometry/predicates.h"

namespace arcway::internal {

/// The point where a segment meets the line through two points, rounded, however small their angle. Precondition: the
/// ends of the segment do not both lie on the line, or on the same side of it. If one lies on the line, it is the
/// result.
inline Vec2 crossing_point(const LineSegment& s, const LineSegment& line) {
  // The ends' distances from the line have opposite signs, so that nothing cancels.
  const double from_a = doubled_area(line.a, line.b, s.a), from_b = doubled_area(line.a, line.b, s.b);
  if (from_b == 0.0) return s.b;
  return s.a + from_a / (from_a - from_b) * (s.b - s.a);
}

}  // namespace arcway::internal

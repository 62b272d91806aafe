#pragma once

#include "core/geometry/predicates.h"

namespace arcway::internal {

/// Whether the direction from p to a comes before that to b, counter-clockwise from +x. Exact, a strict weak order of
/// points other than p.
inline bool precedes_about(const Vec2& p, const Vec2& a, const Vec2& b) {
  const auto in_lower_half = [&](const Vec2& q) { return q.y() < p.y() || (q.y() == p.y() && q.x() < p.x()); };
  if (in_lower_half(a) != in_lower_half(b)) return in_lower_half(b);
  return orientation(p, a, b) > 0;
}

}  // namespace arcway::internal

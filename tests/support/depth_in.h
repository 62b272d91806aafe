#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "arcway/polygon.h"

namespace arcway::internal::test {

/// How deep a point lies in an area [m]; negative outside. It tries every edge, and shares nothing with the library.
inline double depth_in(const Polygon& area, const Vec2& p) {
  double nearest = INFINITY;
  bool inside = false;
  std::vector<Ring> rings{area.outer};
  rings.insert(rings.end(), area.holes.begin(), area.holes.end());
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      const double part = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (a + part * (b - a) - p).norm());
      if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
        inside = !inside;
    }
  return inside ? nearest : -nearest;
}

}  // namespace arcway::internal::test

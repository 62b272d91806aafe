#include "core/geometry/grow_convex.h"

#include <cmath>
#include <cstddef>

namespace arcway::internal {

namespace {

constexpr double kLongestMiter = 3.0;  // reach of a corner beyond its old place, in distances that the sides move

Vec2 outward(const Vec2& from, const Vec2& to) { return -perpendicular(Vec2((to - from).normalized())); }

}  // namespace

std::vector<Vec2> grow_convex(std::span<const Vec2> ring, double by) {
  if (by == 0.0) return {ring.begin(), ring.end()};
  std::vector<Vec2> grown;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &before = ring[(i + n - 1) % n], &corner = ring[i], &after = ring[(i + 1) % n];
    const Vec2 one = outward(before, corner), two = outward(corner, after);
    // Half of the turn from one side to the next: the miter is 1 / cosine long.
    const double cosine = std::sqrt(std::max(0.0, 0.5 * (1.0 + one.dot(two))));
    if (cosine * kLongestMiter >= 1.0) {
      grown.push_back(corner + by / (1.0 + one.dot(two)) * (one + two));
      continue;
    }
    const Vec2 bisector = perpendicular(Vec2((one - two).normalized()));
    const Vec2 along = perpendicular(bisector);
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    const double half = by * (1.0 - cosine) / sine;
    grown.push_back(corner + by * bisector - half * along);
    grown.push_back(corner + by * bisector + half * along);
  }
  return grown;
}

}  // namespace arcway::internal

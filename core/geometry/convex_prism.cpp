#include "core/geometry/convex_prism.h"

#include <algorithm>
#include <cstddef>

#include "core/geometry/convex_hull.h"
#include "core/geometry/predicates.h"

namespace arcway::internal {

namespace {

bool is_strictly_convex(std::span<const Vec2> polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
    if (orientation(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) <= 0) return false;
  return true;
}

}  // namespace

void convex_prism(std::span<const Vec2> from, std::span<const Vec2> to, std::span<const signed char> ahead,
                  std::vector<Vec2>& prism) {
  prism.clear();
  const std::size_t n = from.size();
  if (from.data() == to.data()) prism.assign(from.begin(), from.end());
  for (std::size_t i = 0; i < n && from.data() != to.data(); ++i) {
    const int before = ahead[(i + n - 1) % n], after = ahead[i];
    if (before < 0) prism.push_back(from[i]);
    if (before > 0 || after > 0) prism.push_back(to[i]);
    if (before >= 0 && after < 0) prism.push_back(from[i]);
  }
  if (is_strictly_convex(prism)) return;
  prism.assign(from.begin(), from.end());
  prism.insert(prism.end(), to.begin(), to.end());
  replace_by_hull(prism);
}

bool meets_convex(const LineSegment& s, std::span<const Vec2> polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % n];
    if (orientation(a, b, s.a) < 0 && orientation(a, b, s.b) < 0) return false;
  }
  const int side = orientation(s.a, s.b, polygon[0]);
  const auto is_beside = [&](const Vec2& corner) { return orientation(s.a, s.b, corner) == side; };
  if (side != 0 && std::all_of(polygon.begin() + 1, polygon.end(), is_beside)) return false;
  // No line of one without area separates it from what lies further along that line.
  Box box;
  for (const Vec2& corner : polygon) box.extend(corner);
  return box_of(s).overlaps(box);
}

}  // namespace arcway::internal

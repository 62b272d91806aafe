#include "core/geometry/convex_prism.h"

#include <algorithm>
#include <cstddef>

#include "core/geometry/predicates.h"

namespace arcway::internal {

namespace {

bool is_strictly_convex(std::span<const Vec2> polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
    if (orientation(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) <= 0) return false;
  return true;
}

// The hull of points, by Andrew's monotone chain. Exact.
void replace_by_hull(std::vector<Vec2>& points) {
  std::sort(points.begin(), points.end(),
            [](const Vec2& p, const Vec2& q) { return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y()); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return;
  std::vector<Vec2> hull;
  const auto add = [&](const Vec2& p, std::size_t least) {
    while (hull.size() >= least && orientation(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
    hull.push_back(p);
  };
  for (const Vec2& p : points) add(p, 2);
  const std::size_t lower = hull.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower + 1);
  hull.pop_back();
  points = std::move(hull);
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

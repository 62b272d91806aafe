#include "core/geometry/convex_hull.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/geometry/predicates.h"

namespace arcway::internal {

// Andrew's monotone chain.
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

}  // namespace arcway::internal

#include "core/geometry/convex_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/geometry/predicates.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

// Few coordinates, so that points repeat and lie on lines.
TEST(ConvexHull, HasCornersAmongThePointsAndAllPointsInside) {
  test::RandomInputs random(1);
  for (int k = 0; k < 2000; ++k) {
    std::vector<Vec2> points;
    for (int i = 0; i < 8; ++i)
      points.emplace_back(static_cast<double>(random.integer(0, 4)), static_cast<double>(random.integer(0, 4)));
    std::vector<Vec2> hull = points;
    replace_by_hull(hull);
    const std::size_t n = hull.size();
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_NE(std::ranges::find(points, hull[i]), points.end());
      const Vec2& next = hull[(i + 1) % n];
      if (n >= 3) {
        EXPECT_GT(orientation(hull[i], next, hull[(i + 2) % n]), 0);
      }
      for (const Vec2& p : points) EXPECT_GE(orientation(hull[i], next, p), 0);
    }
  }
}

TEST(ConvexHull, OfALineIsItsEnds) {
  std::vector<Vec2> line{{2, 2}, {0, 0}, {1, 1}, {3, 3}, {0, 0}};
  replace_by_hull(line);
  EXPECT_EQ(line, (std::vector<Vec2>{{0, 0}, {3, 3}}));
  std::vector<Vec2> point{{1, 2}, {1, 2}};
  replace_by_hull(point);
  EXPECT_EQ(point, (std::vector<Vec2>{{1, 2}}));
}

}  // namespace
}  // namespace arcway::internal

#include "core/geometry/convex_prism.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "arcway/polygon.h"
#include "core/geometry/distance.h"
#include "core/geometry/predicates.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

bool in_triangle(const Vec2& p, const Vec2& a, const Vec2& b, const Vec2& c) {
  const int one = orientation(a, b, p), two = orientation(b, c, p), three = orientation(c, a, p);
  return (one >= 0 && two >= 0 && three >= 0) || (one <= 0 && two <= 0 && three <= 0);
}

// Whether a segment meets the hull of points: the triangles of all triples cover it.
bool meets_hull(const LineSegment& s, const std::vector<Vec2>& points) {
  for (const Vec2& a : points) {
    for (const Vec2& b : points) {
      if (relate({a, b}, s) != SegmentRelation::kDisjoint) return true;
      for (const Vec2& c : points)
        if (orientation(a, b, c) != 0 && in_triangle(s.a, a, b, c)) return true;
    }
  }
  return false;
}

constexpr double kRounding = 1e-11;  // of coordinates up to 1e4 [m]

double distance_to_sides(const LineSegment& s, const std::vector<Vec2>& polygon) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    least = std::min(least, distance(s, LineSegment{polygon[i], polygon[(i + 1) % polygon.size()]}));
  return least;
}

TEST(ConvexPrism, IsTheHullOfItsRoundedCorners) {
  test::RandomInputs random(31);
  std::vector<Vec2> prism;
  int met = 0, looked = 0;
  for (int i = 0; i < 1500; ++i) {
    const Ring ring = Polygon::regular({0, 0}, 1.0, static_cast<std::size_t>(random.integer(3, 8)),
                                       random.unit() < 0.3 ? 0.0 : random.uniform(0, 1))
                          .outer;
    const double length = i % 4 == 0 ? std::pow(10.0, random.uniform(-18.0, -8.0)) : random.uniform(0.0, 3.0);
    const Vec2 place = random.point(-1e4, 1e4), along = direction_of(random.uniform(-kPi, kPi));
    const Vec2 half(random.uniform(0.1, 1.0), std::exp(random.uniform(-5.0, 0.0)));
    std::vector<Vec2> from, to;
    std::vector<signed char> ahead;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec2 p = ring[k].cwiseProduct(half);
      const double rise = ring[(k + 1) % ring.size()].y() - ring[k].y();
      from.push_back(place + p.x() * along + p.y() * perpendicular(along));
      to.push_back(place + (length + p.x()) * along + p.y() * perpendicular(along));
      ahead.push_back(static_cast<signed char>((rise > 0.0) - (rise < 0.0)));
    }
    convex_prism(from, to, ahead, prism);
    std::vector<Vec2> points = from;
    points.insert(points.end(), to.begin(), to.end());
    for (int k = 0; k < 12; ++k, ++looked) {
      const Vec2& corner = points[static_cast<std::size_t>(random.integer(0, static_cast<int>(points.size()) - 1))];
      const Vec2 off = k % 3 == 0 ? Vec2(0, 0) : Vec2(random.point(-1, 1) * std::pow(10.0, random.uniform(-13.0, 0.5)));
      const LineSegment s{corner + off, corner + off + random.point(-2, 2)};
      const bool meets = meets_convex(s, prism);
      ASSERT_EQ(meets, meets_hull(s, prism)) << i << ' ' << length;
      // It leaves out corners within it before rounding.
      const bool meets_any = meets_hull(s, points);
      ASSERT_TRUE(meets_any || !meets) << i << ' ' << length;
      if (meets_any && !meets) {
        ASSERT_LT(distance_to_sides(s, prism), kRounding) << i << ' ' << length;
      }
      met += meets;
    }
  }
  EXPECT_GT(met, looked / 4);
  EXPECT_LT(met, 3 * looked / 4 + looked / 8);
}

TEST(ConvexPrism, WithoutMotionIsThePolygon) {
  const Ring ring = test::square(0, 0, 1);
  std::vector<Vec2> prism;
  convex_prism(ring, ring, {}, prism);
  EXPECT_EQ(prism, ring);
}

TEST(MeetsConvex, KnowsPolygonsWithoutArea) {
  const std::vector<Vec2> point{{1, 1}}, line{{0, 0}, {2, 0}};
  EXPECT_TRUE(meets_convex({{0, 0}, {2, 2}}, point));
  EXPECT_FALSE(meets_convex({{2, 2}, {3, 3}}, point));
  EXPECT_TRUE(meets_convex({{1, -1}, {1, 1}}, line));
  EXPECT_TRUE(meets_convex({{2, 0}, {3, 0}}, line));
  EXPECT_FALSE(meets_convex({{2.5, 0}, {3, 0}}, line));
  EXPECT_FALSE(meets_convex({{1, 0.5}, {1, 1}}, line));
}

}  // namespace
}  // namespace arcway::internal

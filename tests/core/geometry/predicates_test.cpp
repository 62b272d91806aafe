#include "core/geometry/predicates.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

using test::RandomInputs;
__extension__ using Wide = __int128;

// Oracle: the determinant in whole numbers, coordinates scaled by a power of two until whole.
Wide whole_determinant(const Vec2& a, const Vec2& b, const Vec2& c, double scale) {
  const auto whole = [scale](double x) { return static_cast<Wide>(static_cast<std::int64_t>(x * scale)); };
  return (whole(b.x()) - whole(a.x())) * (whole(c.y()) - whole(a.y())) -
         (whole(b.y()) - whole(a.y())) * (whole(c.x()) - whole(a.x()));
}

int whole_orientation(const Vec2& a, const Vec2& b, const Vec2& c, double scale) {
  const Wide determinant = whole_determinant(a, b, c, scale);
  return (determinant > 0) - (determinant < 0);
}

void expect_orientation_laws(const Vec2& a, const Vec2& b, const Vec2& c, int expected) {
  ASSERT_EQ(orientation(a, b, c), expected) << a.transpose() << " / " << b.transpose() << " / " << c.transpose();
  ASSERT_EQ(orientation(b, c, a), expected);
  ASSERT_EQ(orientation(c, a, b), expected);
  ASSERT_EQ(orientation(b, a, c), -expected);
  ASSERT_EQ(orientation(a, c, b), -expected);
  ASSERT_EQ(orientation(c, b, a), -expected);
}

TEST(Orientation, IsExactOnTheGridsThatBreakFloatingPoint) {
  // [Kettner et al. 2008, figure 2]
  struct Case {
    Vec2 p, q, r;
  };
  const Case cases[] = {{{0.5, 0.5}, {12, 12}, {24, 24}},
                        {{0.50000000000002531, 0.5000000000000171},
                         {17.300000000000001, 17.300000000000001},
                         {24.00000000000005, 24.0000000000000517765}}};
  for (const Case& c : cases) {
    for (int x = 0; x < 64; ++x) {
      for (int y = 0; y < 64; ++y) {
        const Vec2 p(c.p.x() + x * 0x1p-53, c.p.y() + y * 0x1p-53);
        expect_orientation_laws(p, c.q, c.r, whole_orientation(p, c.q, c.r, 0x1p53));
      }
    }
  }
}

TEST(Orientation, IsExactNearTenMillion) {
  RandomInputs random(1);
  for (int i = 0; i < 20000; ++i) {
    const Vec2 a(1e7 + static_cast<double>(random.integer(-9, 9)) * 0x1p-29, 1e7);
    const Vec2 step(static_cast<double>(random.integer(-5, 5)), static_cast<double>(random.integer(-5, 5)));
    const Vec2 b = a + step;
    const Vec2 c =
        a + static_cast<double>(random.integer(-4, 4)) * step +
        0x1p-29 * Vec2(static_cast<double>(random.integer(-1, 1)), static_cast<double>(random.integer(-1, 1)));
    expect_orientation_laws(a, b, c, whole_orientation(a, b, c, 0x1p29));
  }
}

TEST(DoubledArea, HasAllDigitsOfThinTriangles) {
  RandomInputs random(3);
  for (int i = 0; i < 20000; ++i) {
    const Vec2 a = 0x1p-29 * random.grid_point(-9, 9) + Vec2(1e7, -1e7);
    const Vec2 b = a + random.grid_point(-5, 5);
    const Vec2 c = a + static_cast<double>(random.integer(-4, 4)) * (b - a) + 0x1p-29 * random.grid_point(-1, 1);
    const double expected = static_cast<double>(whole_determinant(a, b, c, 0x1p29)) * 0x1p-58;
    ASSERT_NEAR(doubled_area(a, b, c), expected, 0x1p-51 * std::abs(expected));
  }
}

TEST(Orientation, IsExactOnWholeNumbers) {
  RandomInputs random(2);
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t size = std::int64_t{1} << random.integer(1, 50);
    const Vec2 a = random.grid_point(-size, size);
    const Vec2 b = random.grid_point(-size, size);
    const Vec2 c = i % 2 == 0 ? random.grid_point(-size, size) : Vec2(2.0 * b - a);
    expect_orientation_laws(a, b, c, whole_orientation(a, b, c, 1.0));
  }
}

TEST(Orientation, HoldsAtTheEndsOfTheRange) {
  for (const double m : {kMinMagnitude, 1.0, kMaxMagnitude / 8}) {
    expect_orientation_laws({m, m}, {3 * m, 3 * m}, {5 * m, 5 * m}, 0);
    expect_orientation_laws({m, m}, {3 * m, 3 * m}, {5 * m, std::nextafter(5 * m, 9 * m)},
                            orientation({1, 1}, {3, 3}, {5, 6}));
  }
  expect_orientation_laws({kMinMagnitude, 0}, {0, kMinMagnitude}, {kMaxMagnitude, kMaxMagnitude}, -1);
  expect_orientation_laws({0, 0}, {kMaxMagnitude, kMinMagnitude}, {kMaxMagnitude, 0}, -1);
  EXPECT_EQ(orientation({1, 2}, {1, 2}, {5, 7}), 0);
}

TEST(Relate, NamesEveryCase) {
  using enum SegmentRelation;
  struct Case {
    LineSegment s, t;
    SegmentRelation expected;
  };
  const Case cases[] = {
      {{{0, 0}, {2, 2}}, {{0, 2}, {2, 0}}, kCrossing},         {{{0, 0}, {2, 0}}, {{0, 1}, {2, 1}}, kDisjoint},
      {{{0, 0}, {2, 0}}, {{3, 1}, {3, -1}}, kDisjoint},        {{{0, 0}, {2, 0}}, {{3, 0}, {5, 0}}, kDisjoint},
      {{{0, 0}, {2, 0}}, {{1, 0}, {1, 5}}, kTouchingInterior}, {{{0, 0}, {2, 0}}, {{2, 0}, {3, 5}}, kTouchingEnds},
      {{{0, 0}, {2, 0}}, {{2, 0}, {3, 0}}, kTouchingEnds},     {{{0, 0}, {2, 0}}, {{1, 0}, {3, 0}}, kOverlapping},
      {{{0, 0}, {2, 0}}, {{0, 0}, {1, 0}}, kOverlapping},      {{{0, 0}, {2, 0}}, {{2, 0}, {0, 0}}, kOverlapping},
      {{{0, 0}, {0, 2}}, {{0, 1}, {0, 9}}, kOverlapping},      {{{1, 0}, {1, 0}}, {{0, 0}, {2, 0}}, kTouchingInterior},
      {{{0, 0}, {0, 0}}, {{0, 0}, {2, 0}}, kTouchingEnds},     {{{1, 1}, {1, 1}}, {{1, 1}, {1, 1}}, kTouchingEnds},
      {{{1, 1}, {1, 1}}, {{0, 0}, {2, 0}}, kDisjoint},
  };
  for (const Case& c : cases) {
    EXPECT_EQ(relate(c.s, c.t), c.expected);
    EXPECT_EQ(relate(c.t, c.s), c.expected);
  }
}

// Oracle: solves for the two parameters in whole numbers.
SegmentRelation solve_relation(const LineSegment& s, const LineSegment& t) {
  using enum SegmentRelation;
  const Vec2 u = s.b - s.a;
  const Vec2 v = t.b - t.a;
  const Vec2 w = t.a - s.a;
  double determinant = cross(u, v);
  if (determinant != 0.0) {
    const double sign = determinant > 0 ? 1.0 : -1.0;
    const double at_s = sign * cross(w, v);
    const double at_t = sign * cross(w, u);
    determinant *= sign;
    if (at_s < 0 || at_s > determinant || at_t < 0 || at_t > determinant) return kDisjoint;
    const int ends = (at_s == 0 || at_s == determinant) + (at_t == 0 || at_t == determinant);
    return ends == 0 ? kCrossing : ends == 1 ? kTouchingInterior : kTouchingEnds;
  }
  const Vec2 axis = u != Vec2(0, 0) ? u : v;
  if (cross(axis, w) != 0.0 || (axis == Vec2(0, 0) && w != axis)) return kDisjoint;
  const double low = std::max(std::min(0.0, axis.dot(u)), axis.dot(w) + std::min(0.0, axis.dot(v)));
  const double high = std::min(std::max(0.0, axis.dot(u)), axis.dot(w) + std::max(0.0, axis.dot(v)));
  if (low > high) return kDisjoint;
  if (low < high) return kOverlapping;
  const bool end_of_s = low == 0.0 || low == axis.dot(u);
  const bool end_of_t = low == axis.dot(w) || low == axis.dot(w) + axis.dot(v);
  return end_of_s && end_of_t ? kTouchingEnds : kTouchingInterior;
}

TEST(Relate, AgreesWithWholeNumbersOnASmallGrid) {
  RandomInputs random(3);
  for (int i = 0; i < 200000; ++i) {
    const LineSegment s{random.grid_point(0, 4), random.grid_point(0, 4)};
    const LineSegment t{random.grid_point(0, 4), random.grid_point(0, 4)};
    ASSERT_EQ(relate(s, t), solve_relation(s, t))
        << s.a.transpose() << " - " << s.b.transpose() << " and " << t.a.transpose() << " - " << t.b.transpose();
    ASSERT_EQ(relate({s.b, s.a}, {t.b, t.a}), relate(s, t));
    ASSERT_EQ(relate(t, s), relate(s, t));
  }
}

TEST(OnSegment, TellsEndsFromTheOpenSegment) {
  const LineSegment s{{1e7, 1e7}, {1e7 + 3, 1e7 + 3}};
  EXPECT_TRUE(on_segment(s.a, s));
  EXPECT_TRUE(on_segment(s.b, s));
  EXPECT_FALSE(on_open_segment(s.a, s));
  EXPECT_FALSE(on_open_segment(s.b, s));
  EXPECT_TRUE(on_open_segment({1e7 + 1, 1e7 + 1}, s));
  EXPECT_FALSE(on_segment({1e7 + 1, std::nextafter(1e7 + 1, 2e7)}, s));
  EXPECT_FALSE(on_segment({1e7 + 4, 1e7 + 4}, s));
  EXPECT_TRUE(on_segment({2, 2}, {{2, 2}, {2, 2}}));
}

// Oracle: the ray goes down instead of right.
PointLocation locate_by_column(const Vec2& p, const Ring& ring) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % ring.size()];
    const double side = cross(b - a, p - a);
    if (side == 0.0 && (p - a).dot(p - b) <= 0.0) return PointLocation::kBoundary;
    if ((a.x() <= p.x()) != (b.x() <= p.x()) && (side > 0.0) == (b.x() > a.x())) inside = !inside;
  }
  return inside ? PointLocation::kInside : PointLocation::kOutside;
}

TEST(Locate, AgreesWithAnotherRayOnASmallGrid) {
  RandomInputs random(4);
  for (int i = 0; i < 3000; ++i) {
    Ring ring;
    const auto n = random.integer(3, 9);
    while (std::ssize(ring) < n) ring.push_back(random.grid_point(0, 6));
    for (int x = -1; x <= 7; ++x) {
      for (int y = -1; y <= 7; ++y) {
        ASSERT_EQ(locate(Vec2(x, y), ring), locate_by_column(Vec2(x, y), ring))
            << "ring " << i << " at " << x << ' ' << y;
        ASSERT_EQ(locate(Vec2(x, y), ring), locate(Vec2(x, y), test::reversed(ring)));
      }
    }
  }
}

TEST(Locate, SeparatesNeighboringDoubles) {
  const Ring ring{{0, 0}, {1, 0}, {1, 1}};
  EXPECT_EQ(locate({0.3, 0.3}, ring), PointLocation::kBoundary);
  EXPECT_EQ(locate({0.3, std::nextafter(0.3, 0.0)}, ring), PointLocation::kInside);
  EXPECT_EQ(locate({0.3, std::nextafter(0.3, 1.0)}, ring), PointLocation::kOutside);
}

TEST(InOpenCone, AgreesWithAngles) {
  for (int i = 0; i < 7 * 7 * 7 * 7 * 49; ++i) {
    const auto digit = [i](int place) { return (i / place) % 7 - 3; };
    const Vec2 prev(digit(1), digit(7));
    const Vec2 next(digit(49), digit(343));
    const Vec2 p(digit(2401), digit(16807));
    const Vec2 v(0, 0);
    if (prev == v || next == v || p == v) continue;
    const auto angle_from_next = [&](const Vec2& q) {
      const double angle = wrap_positive(std::atan2(q.y(), q.x()) - std::atan2(next.y(), next.x()));
      return angle > kTwoPi - 1e-9 ? 0.0 : angle;
    };
    const double cone = angle_from_next(prev) < 1e-9 ? kTwoPi : angle_from_next(prev);
    const bool expected = angle_from_next(p) > 1e-9 && angle_from_next(p) < cone - 1e-9;
    ASSERT_EQ(in_open_cone(prev, v, next, p), expected)
        << prev.transpose() << " / " << next.transpose() << " / " << p.transpose();
  }
}

TEST(IntersectsQuad, AgreesWithEdgesAndContainment) {
  RandomInputs random(5);
  int convex = 0, flat = 0;
  while (convex < 5000 || flat < 500) {
    std::array<Vec2, 4> quad;
    for (Vec2& corner : quad) corner = random.grid_point(0, 6);
    bool is_convex = true;
    for (std::size_t i = 0; i < 4; ++i) is_convex &= orientation(quad[i], quad[(i + 1) % 4], quad[(i + 2) % 4]) >= 0;
    for (std::size_t i = 0; i < 4; ++i) is_convex &= orientation(quad[i], quad[(i + 1) % 4], quad[(i + 3) % 4]) >= 0;
    bool is_flat = true;
    for (std::size_t i = 0; i < 4; ++i) is_flat &= orientation(quad[i], quad[(i + 1) % 4], quad[(i + 2) % 4]) == 0;
    if (!is_convex) continue;
    ++(is_flat ? flat : convex);
    for (int k = 0; k < 20; ++k) {
      const LineSegment s{random.grid_point(-1, 7), random.grid_point(-1, 7)};
      bool expected = locate(s.a, quad) != PointLocation::kOutside;
      for (std::size_t i = 0; i < 4; ++i) {
        expected |= relate(s, {quad[i], quad[(i + 1) % 4]}) != SegmentRelation::kDisjoint;
      }
      ASSERT_EQ(intersects(s, quad), expected);
    }
  }
}

}  // namespace
}  // namespace arcway::internal

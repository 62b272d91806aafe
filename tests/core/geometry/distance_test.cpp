#include "core/geometry/distance.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/geometry/predicates.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

using test::RandomInputs;
using test::square;

Vec2 point_on(const LineSegment& s, double t) { return s.a + t * (s.b - s.a); }

TEST(Distance, OfAPointFromASegment) {
  const LineSegment s{{0, 0}, {4, 0}};
  EXPECT_EQ(distance(Vec2(2, 3), s), 3.0);
  EXPECT_EQ(distance(Vec2(7, 4), s), 5.0);
  EXPECT_EQ(distance(Vec2(-3, -4), s), 5.0);
  EXPECT_EQ(distance(Vec2(1, 0), s), 0.0);
  EXPECT_EQ(distance(Vec2(3, 4), LineSegment{{0, 0}, {0, 0}}), 5.0);
  EXPECT_EQ(closest_point({2, 3}, s), Vec2(2, 0));
  EXPECT_EQ(closest_point({9, 3}, s), s.b);
  EXPECT_EQ(closest_point({-9, 3}, s), s.a);
  EXPECT_EQ(closest_point({1, 1}, {{3, 3}, {3, 3}}), Vec2(3, 3));
}

TEST(Distance, OfAPointIsZeroOnlyOnTheSegment) {
  const LineSegment s{{1e7, 1e7}, {1e7 + 3, 1e7 + 3}};
  EXPECT_EQ(distance(Vec2(1e7 + 1, 1e7 + 1), s), 0.0);
  const Vec2 near(1e7 + 1, std::nextafter(1e7 + 1, 2e7));
  EXPECT_NEAR(distance(near, s), 0x1p-29 * std::sqrt(0.5), 0x1p-70);
  RandomInputs random(1);
  for (int i = 0; i < 20000; ++i) {
    const LineSegment t{random.point(-1, 1), random.point(-1, 1)};
    const Vec2 p = point_on(t, random.unit());
    ASSERT_EQ(distance(p, t) == 0.0, on_segment(p, t));
    ASSERT_LT(distance(p, t), 1e-15);
  }
}

TEST(Distance, OfTwoSegmentsIsZeroExactlyIfTheyMeet) {
  RandomInputs random(2);
  for (int i = 0; i < 20000; ++i) {
    const LineSegment s{random.grid_point(0, 6), random.grid_point(0, 6)};
    const LineSegment t{random.grid_point(0, 6), random.grid_point(0, 6)};
    const double d = distance(s, t);
    ASSERT_EQ(d == 0.0, relate(s, t) != SegmentRelation::kDisjoint);
    ASSERT_EQ(d, distance(t, s));
    for (int k = 0; k <= 10; ++k) ASSERT_LE(d, distance(point_on(s, 0.1 * k), t) + 1e-14);
  }
}

TEST(Distance, OfPolygonsHeedsHolesAndContainment) {
  const Polygon frame{square(0, 0, 10), {square(2, 2, 6)}};
  EXPECT_EQ(distance(Vec2(1, 1), frame), 0.0);
  EXPECT_EQ(distance(Vec2(2, 5), frame), 0.0);
  EXPECT_EQ(distance(Vec2(5, 4), frame), 2.0);
  EXPECT_EQ(distance(Vec2(13, 14), frame), 5.0);
  EXPECT_EQ(distance(frame, Polygon{square(4, 4, 1), {}}), 2.0);
  EXPECT_EQ(distance(frame, Polygon{square(0.5, 0.5, 0.5), {}}), 0.0);
  EXPECT_EQ(distance(Polygon{square(0.5, 0.5, 0.5), {}}, frame), 0.0);
  EXPECT_EQ(distance(frame, Polygon{square(-1, 4, 12), {}}), 0.0);
  EXPECT_EQ(distance(frame, Polygon{square(10, 10, 1), {}}), 0.0);
  EXPECT_EQ(distance(frame, Polygon{square(13, 14, 1), {}}), 5.0);
}

TEST(Distance, OfASegmentFromAQuad) {
  const std::array<Vec2, 4> quad{Vec2(0, 0), Vec2(4, 0), Vec2(4, 2), Vec2(0, 2)};
  EXPECT_EQ(distance(LineSegment{{1, 1}, {2, 1}}, quad), 0.0);
  EXPECT_EQ(distance(LineSegment{{4, 2}, {5, 3}}, quad), 0.0);
  EXPECT_EQ(distance(LineSegment{{-1, 5}, {9, 5}}, quad), 3.0);
  EXPECT_EQ(distance(LineSegment{{7, 6}, {9, 6}}, quad), 5.0);
}

TEST(Distance, OfAPointFromAnArc) {
  const CircularArc quarter{{0, 0}, 2, 0, kPi / 2};
  EXPECT_DOUBLE_EQ(distance(quarter, Vec2(3, 3)), std::sqrt(18.0) - 2);
  EXPECT_DOUBLE_EQ(distance(quarter, Vec2(0, 0)), 2.0);
  EXPECT_NEAR(distance(quarter, Vec2(-3, 2)), 3.0, 1e-15);
  EXPECT_DOUBLE_EQ(distance(quarter, Vec2(2, -1)), 1.0);
  const CircularArc clockwise{{0, 0}, 2, kPi / 2, -kPi / 2};
  EXPECT_NEAR(distance(clockwise, Vec2(3, 3)), std::sqrt(18.0) - 2, 1e-15);
  const CircularArc circle{{1, 1}, 2, 5, -7};
  for (int i = 0; i < 20; ++i) EXPECT_NEAR(distance(circle, Vec2(1, 1) + 5 * direction_of(0.4 * i)), 3.0, 1e-14);
}

TEST(Distance, OfASegmentFromAnArcFindsEveryKindOfNearestPair) {
  const CircularArc top{{0, 0}, 2, 0, kPi};
  EXPECT_DOUBLE_EQ(distance(top, LineSegment{{-5, 3}, {5, 3}}), 1.0);  // perpendicular from the center
  EXPECT_EQ(distance(top, LineSegment{{0, 0}, {0, 5}}), 0.0);          // crossing
  EXPECT_EQ(distance(top, LineSegment{{-5, 1}, {5, 1}}), 0.0);         // two crossings
  EXPECT_DOUBLE_EQ(distance(top, LineSegment{{-0.5, 1}, {0.5, 1}}), 2 - std::sqrt(1.25));  // an end of the segment
  EXPECT_DOUBLE_EQ(distance(top, LineSegment{{-5, -1}, {5, -1}}), 1.0);                    // an end of the arc
  EXPECT_DOUBLE_EQ(distance(top, LineSegment{{0, 4}, {0, 4}}), 2.0);                       // a point
  EXPECT_DOUBLE_EQ(distance(top, LineSegment{{-0.5, 0}, {0.5, 0}}), 1.5);                  // a line through the center
}

TEST(Distance, OfASegmentFromAnArcAgreesWithSamples) {
  RandomInputs random(3);
  for (int i = 0; i < 500; ++i) {
    const CircularArc arc{random.point(-3, 3), random.uniform(0.1, 4), random.uniform(-7, 7), random.uniform(-7, 7)};
    const LineSegment s{random.point(-6, 6), random.point(-6, 6)};
    const double d = distance(arc, s);
    constexpr int kSamples = 2000;
    double least = 1e9;
    for (int k = 0; k <= kSamples; ++k) least = std::min(least, distance(arc.point_at(arc.sweep * k / kSamples), s));
    // The nearest point of the arc is at most half a step from a sample.
    const double step = arc.radius * std::abs(arc.sweep) / kSamples;
    ASSERT_LE(d, least + 1e-13) << "case " << i;
    ASSERT_GE(d, least - step / 2 - 1e-13) << "case " << i;
  }
}

}  // namespace
}  // namespace arcway::internal

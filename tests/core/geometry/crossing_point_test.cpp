#include "core/geometry/crossing_point.h"

#include <gtest/gtest.h>

#include "arcway/polygon.h"
#include "core/geometry/closest_pair.h"
#include "core/geometry/distance.h"
#include "core/geometry/predicates.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

// Segments on nearly the same line, the ends of one off it by some units in the last place.
TEST(CrossingPoint, LiesOnBothSegmentsHoweverNearlyParallel) {
  test::RandomInputs random(4);
  std::size_t crossings = 0;
  for (int i = 0; i < 20000; ++i) {
    const double scale = i % 2 == 0 ? 1.0 : 1e6 / 3.0;
    const LineSegment s{scale * random.grid_point(-8, 8), scale * random.grid_point(-30, 30)};
    const double from = random.uniform(-0.3, 0.9);
    LineSegment t{s.a + from * (s.b - s.a), s.a + (from + random.uniform(0.1, 1.0)) * (s.b - s.a)};
    t.a.x() += 0x1p-52 * static_cast<double>(random.integer(-2, 2)) * t.a.x();
    t.b.y() += 0x1p-52 * static_cast<double>(random.integer(-2, 2)) * t.b.y();
    if (relate(s, t) != SegmentRelation::kCrossing) continue;
    ++crossings;
    const Vec2 p = crossing_point(s, t);
    ASSERT_LE(distance(p, s) + distance(p, t), 1e-13 * scale) << i;
    const ClosestPair pair = closest_pair(s, t);
    ASSERT_LE(distance(pair.a, s) + distance(pair.b, t), 1e-13 * scale) << i;
    const auto conflict = find_conflict({{s.a, s.b, t.a, t.b}, {}});
    ASSERT_TRUE(conflict);
    ASSERT_LE(distance(conflict->place, s) + distance(conflict->place, t), 1e-13 * scale) << i;
  }
  EXPECT_GT(crossings, 1000u);
}

TEST(CrossingPoint, IsAnEndThatLiesOnTheLine) {
  const LineSegment line{{1, 1}, {4, 4}};
  EXPECT_EQ(crossing_point({{7, 7}, {8, 3}}, line), Vec2(7, 7));
  EXPECT_EQ(crossing_point({{8, 3}, {7, 7}}, line), Vec2(7, 7));
  EXPECT_EQ(crossing_point({{0, 4}, {4, 0}}, line), Vec2(2, 2));
}

}  // namespace
}  // namespace arcway::internal

#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/angle.h"
#include "core/query/query_set.h"
#include "datasets/clutter.h"
#include "tests/support/random_inputs.h"

namespace arcway {
namespace {

// The body at one heading, as a rectangle of its own: decided by the straight check, which is exact.
bool free_at(const SweepQuery& sweep, const TurningBody& body, double heading) {
  const Vec2 p = body.center - sign_of(body.side) * body.radius * perpendicular(direction_of(heading));
  return sweep.straight_free(swept_rectangle({p.x(), p.y(), heading}, 0.0, body.body));
}

TEST(FreeHeadings, AgreeWithTheBodyPlacedAtEachHeading) {
  const Clutter clutter =
      generate_clutter({.kind = ClutterKind::kMixed, .obstacles = 40, .vertices = 7, .fill = 0.4, .seed = 3});
  const World world(clutter.obstacles, clutter.bounds);
  const QuerySet queries = make_reference_queries(world);
  test::Random random(11);
  std::size_t partly_free = 0;
  for (int i = 0; i < 150; ++i) {
    const Vec2 span = world.box().max - world.box().min;
    const Vec2 center =
        world.box().min + Vec2(random.uniform(0.0, 1.0) * span.x(), random.uniform(0.0, 1.0) * span.y());
    const TurningBody body{center, random.uniform(0.8, 4.0), i % 2 == 0 ? Side::kLeft : Side::kRight,
                           Vehicle{}.footprint(0.0005)};
    const HeadingSet set = queries.sweep->free_headings(body);
    partly_free += !set.empty() && !set.is_full();
    for (int k = 0; k < 100; ++k) {
      const double heading = random.uniform(0.0, kTwoPi);
      bool near_an_end = false;
      for (const HeadingInterval& interval : set.intervals())
        for (const double end : {interval.low, interval.high})
          near_an_end = near_an_end || std::abs(wrap_signed(heading - end)) < 1e-6;
      if (near_an_end) continue;
      ASSERT_EQ(set.contains(heading), free_at(*queries.sweep, body, heading))
          << "body " << i << ", heading " << heading;
    }
  }
  EXPECT_GT(partly_free, 30u);
}

TEST(FreeHeadings, AnEmptyWorldIsFreeAllRound) {
  const World world({});
  const QuerySet queries = make_reference_queries(world);
  EXPECT_TRUE(queries.sweep->free_headings(TurningBody{{0, 0}, 2.0, Side::kLeft, Vehicle{}.footprint()}).is_full());
}

TEST(FreeHeadings, ABodySwallowedByAnObstacleIsNotFree) {
  const World world({{{{-50, -50}, {50, -50}, {50, 50}, {-50, 50}}, {}}});
  const QuerySet queries = make_reference_queries(world);
  EXPECT_TRUE(queries.sweep->free_headings(TurningBody{{0, 0}, 2.0, Side::kRight, Vehicle{}.footprint()}).empty());
  EXPECT_FALSE(queries.sweep->straight_free(swept_rectangle({0, 0, 0.3}, 5.0, Vehicle{}.footprint())));
}

TEST(FreeHeadings, ABodyInsideAHoleIsFree) {
  const World world({{{{-50, -50}, {50, -50}, {50, 50}, {-50, 50}}, {{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}}}});
  const QuerySet queries = make_reference_queries(world);
  EXPECT_TRUE(queries.sweep->free_headings(TurningBody{{0, 0}, 2.0, Side::kRight, Vehicle{}.footprint()}).is_full());
}

TEST(FreeHeadings, OutsideTheBoundsNothingIsFree) {
  const World world({}, Ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  const QuerySet queries = make_reference_queries(world);
  EXPECT_TRUE(queries.sweep->free_headings(TurningBody{{30, 30}, 2.0, Side::kLeft, Vehicle{}.footprint()}).empty());
  EXPECT_TRUE(queries.sweep->free_headings(TurningBody{{5, 5}, 2.0, Side::kLeft, Vehicle{}.footprint()}).is_full());
}

}  // namespace
}  // namespace arcway

#include "arcway/sweep_query.h"

#include <gtest/gtest.h>

#include <cmath>

#include "accel/backend/make_queries.h"
#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/query_set.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

// A heading of a circle, half of the time within rounding of an end of a free interval.
double heading_on(const HeadingSet& free, test::RandomInputs& random) {
  if (free.empty() || random.integer(0, 1) == 0) return random.uniform(-7.0, 7.0);
  const auto interval =
      free.intervals()[static_cast<std::size_t>(random.integer(0, static_cast<int>(free.intervals().size()) - 1))];
  const double end = random.integer(0, 1) == 0 ? interval.low : interval.high;
  return end + random.uniform(-1e-7, 1e-7);
}

// The accelerated answers about arcs against those of all free headings of the reference.
TEST(SweepQueryOfAnArc, AnswersAsTheSetOfFreeHeadingsDoes) {
  const Clutter clutter =
      generate_clutter({.kind = ClutterKind::kMixed, .obstacles = 60, .vertices = 7, .fill = 0.35, .seed = 5});
  const World world(clutter.obstacles, clutter.bounds);
  const QuerySet reference = make_reference_queries(world), embree = make_embree_queries(world);
  test::RandomInputs random(3);
  HeadingSet memory;
  int free = 0, blocked = 0, near = 0;
  const Vec2 span = world.box().max - world.box().min;
  for (int i = 0; i < 600; ++i) {
    const Vec2 center =
        world.box().min + Vec2(random.uniform(-0.1, 1.1) * span.x(), random.uniform(-0.1, 1.1) * span.y());
    const TurningBody body{center, std::exp(random.uniform(-1.0, 4.0)), i % 2 == 0 ? Side::kLeft : Side::kRight,
                           Vehicle{}.footprint(0.0005)};
    const HeadingSet all = reference.sweep->free_headings(body);
    for (int k = 0; k < 20; ++k) {
      const double heading = heading_on(all, random), angle = std::exp(random.uniform(-9.0, 1.8));
      const bool is_free = all.reach(heading, body.side) >= angle;
      ASSERT_EQ(embree.sweep->arc_free(body, heading, angle, memory), is_free) << "body " << i << ", arc " << k;
      ASSERT_EQ(reference.sweep->arc_free(body, heading, angle, memory), is_free);
      ++(is_free ? free : blocked);
      for (const Side towards : {Side::kLeft, Side::kRight}) {
        const double reached = all.reach(heading, towards);
        ASSERT_EQ(embree.sweep->reach(body, heading, towards, memory), reached) << "body " << i << ", arc " << k;
        ASSERT_EQ(reference.sweep->reach(body, heading, towards, memory), reached);
        near += reached > 0.0 && reached < 0.5 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(free, 500);
  EXPECT_GT(blocked, 500);
  EXPECT_GT(near, 500);
}

// An arc that touches no edge lies wholly in an obstacle, or wholly out of bounds.
TEST(SweepQueryOfAnArc, ABodySwallowedByAnObstacleIsNotFree) {
  const World block({{test::square(-50, -50, 100), {}}});
  const QuerySet queries = make_embree_queries(block);
  const TurningBody body{{0, 0}, 2.0, Side::kRight, Vehicle{}.footprint()};
  HeadingSet memory;
  EXPECT_FALSE(queries.sweep->arc_free(body, 0.3, 0.5, memory));
  EXPECT_LT(queries.sweep->reach(body, 0.3, Side::kLeft, memory), 0.0);
}

}  // namespace
}  // namespace arcway::internal

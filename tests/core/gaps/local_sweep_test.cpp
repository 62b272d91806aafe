#include "core/gaps/local_sweep.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "datasets/io/random.h"
#include "tests/support/boxes.h"
#include "tests/support/counting_sweep.h"

namespace arcway::internal {
namespace {

using test::CountingSweep;

// Rectangles in the place and beyond, some of them inside obstacles; obstacles with few edges there and with more than
// are remembered.
TEST(LocalSweep, AnswersAsTheQueryAndSeldomAsks) {
  for (const std::size_t vertices : {std::size_t{5}, std::size_t{300}}) {
    const World world = random_world({.obstacles = 30, .vertices = vertices, .fill = 0.4, .seed = 3});
    const CountingSweep sweep(world);
    const Outlines outlines(world);
    const auto distance = make_reference_queries(world).distance;
    Random random(vertices);
    std::size_t met = 0, inside = 0, free = 0, asked = 0;
    for (int place = 0; place < 20; ++place) {
      const Vec2 size = world.box().max - world.box().min;
      const Vec2 middle = world.box().min + Vec2(random.uniform(0, 1) * size.x(), random.uniform(0, 1) * size.y());
      const double around = 0.05 * size.maxCoeff();
      LocalSweep local(sweep, outlines, box_of({middle, middle}).grown(around));
      for (int i = 0; i < 200; ++i) {
        const Pose pose{middle.x() + random.uniform(-1.5, 1.5) * around,
                        middle.y() + random.uniform(-1.5, 1.5) * around, random.uniform(0, kTwoPi)};
        const double reach = random.uniform(0.02, 0.5) * around;
        const SweptRectangle r = swept_rectangle(pose, 0.0, {reach, 0.5 * reach, 0.6 * reach, 0.2 * reach});
        const std::size_t before = sweep.asked();
        const bool is_free = local.straight_free(r);
        asked += sweep.asked() - before;
        ASSERT_EQ(is_free, sweep.straight_free(r)) << vertices << ' ' << place << ' ' << i;
        (is_free ? free : distance->containing(pose.position()) != kNone ? inside : met) += 1;
      }
    }
    EXPECT_GT(met, 500u);
    EXPECT_GT(inside, 200u);
    EXPECT_GT(free, 500u);
    if (vertices == 5) {
      EXPECT_LT(asked, free + inside + met / 2);
    }
  }
}

// Searches for dead ends ask in this way: from a free rectangle to rectangles near it.
TEST(LocalSweep, SeldomAsksAboutStepsFromWhatIsFree) {
  const World world = random_world({.obstacles = 30, .vertices = 6, .fill = 0.3, .seed = 5});
  const CountingSweep sweep(world);
  const Outlines outlines(world);
  Random random(8);
  std::size_t free = 0, in_the_way = 0, asked = 0;
  for (int place = 0; place < 40; ++place) {
    const Vec2 size = world.box().max - world.box().min;
    Vec2 at = world.box().min + Vec2(random.uniform(0, 1) * size.x(), random.uniform(0, 1) * size.y());
    const double around = 0.1 * size.maxCoeff();
    LocalSweep local(sweep, outlines, box_of({at, at}).grown(around));
    for (int i = 0; i < 100; ++i) {
      const Vec2 next = at + 0.1 * around * Vec2(random.uniform(-1, 1), random.uniform(-1, 1));
      const Footprint body{0.1 * around, 0.05 * around, 0.06 * around, 0.02 * around};
      const SweptRectangle r = swept_rectangle({next.x(), next.y(), random.uniform(0, kTwoPi)}, 0.0, body);
      const std::size_t before = sweep.asked();
      const bool is_free = local.straight_free(r);
      if (is_free) asked += sweep.asked() - before;
      ASSERT_EQ(is_free, sweep.straight_free(r)) << place << ' ' << i;
      (is_free ? free : in_the_way) += 1;
      if (is_free) at = next;
    }
  }
  EXPECT_GT(free, 1500u);
  EXPECT_GT(in_the_way, 300u);
  EXPECT_LT(asked, free / 4);
}

}  // namespace
}  // namespace arcway::internal

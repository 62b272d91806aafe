#include "core/passage/local_sweep.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "core/geometry/angle.h"
#include "datasets/clutter.h"
#include "datasets/random.h"
#include "tests/support/boxes.h"
#include "tests/support/counting_sweep.h"

namespace arcway {
namespace {

using test::CountingSweep;

// Rectangles in the place and beyond, some of them inside obstacles; obstacles with few edges there and with more than
// are remembered.
TEST(LocalSweep, AnswersAsTheQueryAndSeldomAsks) {
  for (const std::size_t vertices : {5, 300}) {
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
        const SweptRectangle r = swept_rectangle(pose, 0.0, {reach, 0.5 * reach, 0.4 * reach});
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

}  // namespace
}  // namespace arcway

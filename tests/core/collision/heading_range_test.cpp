#include "core/collision/heading_range.h"

#include <gtest/gtest.h>

#include <cmath>

#include "arcway/angle.h"
#include "core/collision/turning_headings.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

constexpr Footprint kBody{.front = 1.4, .rear = 0.1, .left = 0.4, .right = 0.4};
constexpr Footprint kUnevenBody{.front = 1.4, .rear = 0.1, .left = 0.2, .right = 0.6};

// The free headings of one edge, of the range alone and of the whole circle.
TEST(HeadingRange, HasTheBitsOfTheWholeCircleWithin) {
  test::RandomInputs random(8);
  HeadingRange::Memory memory;
  int clear = 0, touched = 0, left_out = 0;
  for (int i = 0; i < 20000; ++i) {
    const TurningBody body{random.point(-1.0, 1.0), std::exp(random.uniform(-1.0, 3.0)),
                           i % 2 == 0 ? Side::kLeft : Side::kRight, i % 4 < 2 ? kBody : kUnevenBody};
    const double far = 1.2 * reach_of(body);
    const Vec2 a = random.point(-far, far), b = a + random.point(-2.0, 2.0);
    const double low = random.uniform(-7.0, 7.0), angle = random.uniform(0.0, 3.0);
    std::vector<HeadingInterval> blocked;
    if (may_touch(body, {a, b})) append_blocked_headings(body, {a, b}, blocked);
    const HeadingSet all = HeadingSet::complement(blocked);
    HeadingRange range(body, low, angle, memory);
    const bool is_clear = range.add({a, b});
    const bool is_free = all.reach(low, Side::kLeft) >= angle;
    EXPECT_EQ(is_clear, is_free) << "round " << i;
    left_out += range.free_headings().is_full() && !all.is_full() ? 1 : 0;
    for (int k = 0; k <= 10; ++k)
      EXPECT_EQ(range.free_headings().contains(low + 0.1 * k * angle), all.contains(low + 0.1 * k * angle));
    ++(is_free ? clear : touched);
  }
  EXPECT_GT(clear, 2000);
  EXPECT_GT(touched, 2000);
  EXPECT_GT(left_out, 1000);
}

// The disc that edges are looked up in is smaller than the circle where the range is a short part of it.
TEST(HeadingRange, LooksUpEdgesNearTheSweptAreaAlone) {
  HeadingRange::Memory memory;
  const TurningBody body{{0.0, 100.0}, 100.0, Side::kLeft, kBody};
  const HeadingRange few(body, 0.0, 0.02, memory), all(body, 0.0, 6.0, memory);
  EXPECT_LT(few.reach(), 3.0);
  EXPECT_LT((few.middle() - Vec2(1.6, 0.0)).norm(), 0.2);
  EXPECT_GT(all.reach(), 99.0);
}

}  // namespace
}  // namespace arcway::internal

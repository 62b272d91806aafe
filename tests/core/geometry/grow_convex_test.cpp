#include "core/geometry/grow_convex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "arcway/polygon.h"
#include "core/geometry/distance.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

// Corners on an ellipse, which may be as thin as a needle.
Ring random_convex(test::RandomInputs& random) {
  const double long_axis = random.uniform(0.5, 3.0), short_axis = long_axis * std::exp(random.uniform(-9.0, 0.0));
  const Vec2 middle = random.point(-2, 2), ahead = direction_of(random.uniform(-kPi, kPi));
  Ring ring;
  for (const Vec2& p :
       test::random_star(random, Vec2::Zero(), 1.0, 1.0, static_cast<std::size_t>(random.integer(3, 12))))
    ring.push_back(middle + long_axis * p.x() * ahead + short_axis * p.y() * perpendicular(ahead));
  return ring;
}

TEST(GrowConvex, MovesSidesOutwards) {
  const Ring grown = grow_convex(test::square(0, 0, 2), 0.5);
  ASSERT_EQ(grown.size(), 4u);
  for (const Vec2& corner : test::square(-0.5, -0.5, 3))
    EXPECT_TRUE(std::ranges::any_of(grown, [&](const Vec2& p) { return (p - corner).norm() < 1e-15; }));
}

// What is grown by a + b contains what is grown by a, with a disc of radius b around each of its points.
TEST(GrowConvex, ContainsDiscsAroundWhatIsGrownByLess) {
  test::RandomInputs random(3);
  for (int i = 0; i < 300; ++i) {
    const Ring ring = random_convex(random);
    const double a = random.unit() < 0.2 ? 0.0 : random.uniform(0.0, 0.4), b = random.uniform(1e-3, 0.4);
    const Ring less = grow_convex(ring, a), more = grow_convex(ring, a + b);
    for (std::size_t k = 0; k < more.size(); ++k) {
      const Vec2 from = more[k], along = (more[(k + 1) % more.size()] - from).normalized();
      for (const Vec2& p : less) EXPECT_GE(cross(along, p - from), b - 1e-12);
    }
  }
}

TEST(GrowConvex, ReachesNoFurtherThanThreeTimes) {
  test::RandomInputs random(4);
  bool is_cut = false;
  for (int i = 0; i < 300; ++i) {
    const Ring ring = random_convex(random), grown = grow_convex(ring, 0.1);
    is_cut = is_cut || grown.size() > ring.size();
    for (const Vec2& corner : grown) EXPECT_LE(distance(corner, Polygon{ring, {}}), 0.3 + 1e-12);
  }
  EXPECT_TRUE(is_cut);
}

}  // namespace
}  // namespace arcway::internal

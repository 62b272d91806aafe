#include "core/geometry/inscribed.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "arcway/polygon.h"
#include "core/geometry/distance.h"
#include "core/geometry/predicates.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

double distance_from_sides(const Ring& ring, const Vec2& p) {
  double least = distance(p, LineSegment{ring.back(), ring.front()});
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    least = std::min(least, distance(p, LineSegment{ring[i], ring[i + 1]}));
  return least;
}

TEST(InscribedDisc, IsThatOfKnownShapes) {
  EXPECT_NEAR(largest_disc_in(test::square(1, 2, 4), {1.5, 2.5}).radius, 2.0, 2e-3);
  EXPECT_NEAR(largest_disc_in(Polygon::regular({0, 0}, 2.0, 6).outer, {1, 0}).radius, 2.0 * std::sqrt(0.75), 2e-3);
  // The disc touches the reflex corner and the two far sides: r = (2 - r) / sqrt(2) from (r, r).
  const Ring angle{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}};
  EXPECT_NEAR(largest_disc_in(angle, {0.5, 0.5}).radius, 2.0 - std::sqrt(2.0), 1e-3);
}

TEST(InscribedDisc, LiesInTheRing) {
  test::RandomInputs random(5);
  for (int i = 0; i < 200; ++i) {
    const Ring ring = test::random_star(random, {3, 3}, 0.05, 2.0, static_cast<std::size_t>(random.integer(4, 60)));
    const InscribedDisc disc = largest_disc_in(ring, {3, 3});
    ASSERT_EQ(locate(disc.center, ring), PointLocation::kInside);
    EXPECT_GT(disc.radius, 0.0);
    EXPECT_LE(disc.radius, distance_from_sides(ring, disc.center));
    for (int k = 0; k < 300; ++k) {
      const Vec2 p = random.point(1.0, 5.0);
      if (locate(p, ring) != PointLocation::kInside) continue;
      EXPECT_LE(distance_from_sides(ring, p), 1.0011 * disc.radius);
    }
  }
}

TEST(InscribedDisc, OfANeedleLiesInIt) {
  const Ring needle{{0, 0}, {3, 1}, {3, 1.0001}};
  const InscribedDisc disc = largest_disc_in(needle, {2, (2.0 / 3.0 + 2.0002 / 3.0) / 2.0});
  EXPECT_EQ(locate(disc.center, needle), PointLocation::kInside);
  EXPECT_GT(disc.radius, 1e-5);
}

TEST(InscribedBox, IsThatOfKnownShapes) {
  const Box square = large_box_in(test::square(1, 2, 4));
  EXPECT_NEAR((square.min - Vec2(1, 2)).norm() + (square.max - Vec2(5, 6)).norm(), 0.0, 1e-10);
  const Box leg = large_box_in(Ring{{0, 0}, {5, 0}, {5, 1}, {1, 1}, {1, 4}, {0, 4}});
  EXPECT_NEAR((leg.min - Vec2(0, 0)).norm() + (leg.max - Vec2(5, 1)).norm(), 0.0, 1e-10);
}

TEST(InscribedBox, LiesInTheRing) {
  test::RandomInputs random(6);
  for (int i = 0; i < 200; ++i) {
    const Ring ring = test::random_star(random, {3, 3}, 0.5, 2.0, static_cast<std::size_t>(random.integer(4, 30)));
    const Box box = large_box_in(ring);
    ASSERT_FALSE(box.empty());
    for (const Vec2& corner : box.corners()) EXPECT_EQ(locate(corner, ring), PointLocation::kInside);
    for (std::size_t k = 0; k < ring.size(); ++k)
      EXPECT_FALSE(intersects(LineSegment{ring[k], ring[(k + 1) % ring.size()]}, box.corners()));
  }
}

}  // namespace
}  // namespace arcway::internal

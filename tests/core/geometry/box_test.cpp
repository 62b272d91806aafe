#include <gtest/gtest.h>

#include <array>

#include "arcway/vec2.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

TEST(Box, IsSoFarFromAPoint) {
  const Box box{{1, 2}, {5, 4}};
  EXPECT_EQ(box.closest_point({3, 3}), Vec2(3, 3));
  EXPECT_EQ(box.closest_point({3, 9}), Vec2(3, 4));
  EXPECT_EQ(box.closest_point({-3, 9}), Vec2(1, 4));
  EXPECT_EQ(box.distance_to(Vec2(3, 3)), 0.0);
  EXPECT_EQ(box.distance_to(Vec2(5, 2)), 0.0);
  EXPECT_EQ(box.distance_to(Vec2(3, -5)), 7.0);
  EXPECT_EQ(box.distance_to(Vec2(-2, 3)), 3.0);
  EXPECT_EQ(box.distance_to(Vec2(8, 8)), 5.0);
  EXPECT_EQ((Box{{4, 5}, {4, 5}}.distance_to(Vec2(1, 1))), 5.0);
}

TEST(Box, HasNoPointNearerThanTheClosest) {
  test::RandomInputs random(1);
  for (int i = 0; i < 2000; ++i) {
    Box box;
    box.extend(random.point(-5, 5));
    box.extend(random.point(-5, 5));
    const Vec2 p = random.point(-9, 9);
    EXPECT_TRUE(box.contains(box.closest_point(p)));
    EXPECT_EQ(box.distance_to(p), (p - box.closest_point(p)).norm());
    EXPECT_EQ(box.distance_to(p) == 0.0, box.contains(p));
    const Vec2 within = box.min + Vec2(random.unit(), random.unit()).cwiseProduct(box.max - box.min);
    EXPECT_LE(box.distance_to(p), (p - within).norm() * (1.0 + 1e-12));
  }
}

TEST(Box, IsSoFarFromAnother) {
  const Box box{{1, 2}, {5, 4}};
  EXPECT_EQ(box.distance_to(box), 0.0);
  EXPECT_EQ(box.distance_to(Box{{5, 4}, {6, 7}}), 0.0);
  EXPECT_EQ(box.distance_to(Box{{2, -9}, {3, -1}}), 3.0);
  EXPECT_EQ((Box{{-9, -9}, {-2, -2}}.distance_to(box)), 5.0);
  test::RandomInputs random(2);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 p = random.point(-9, 9);
    EXPECT_EQ(box.distance_to(Box{p, p}), box.distance_to(p));
  }
}

TEST(Box, IsAsLargeAsTold) {
  const Box box = box_of({{5, 2}, {1, 4}});
  EXPECT_EQ(box.min, Vec2(1, 2));
  EXPECT_EQ(box.max, Vec2(5, 4));
  const Box grown = box.grown(0.5);
  EXPECT_EQ(grown.min, Vec2(0.5, 1.5));
  EXPECT_EQ(grown.max, Vec2(5.5, 4.5));
  const std::array<Vec2, 4> corners = box.corners();
  EXPECT_EQ(corners, (std::array<Vec2, 4>{Vec2(1, 2), Vec2(5, 2), Vec2(5, 4), Vec2(1, 4)}));
}

}  // namespace
}  // namespace arcway::internal

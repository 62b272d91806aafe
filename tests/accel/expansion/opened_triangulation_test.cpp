#include "accel/expansion/opened_triangulation.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

#include "core/geometry/predicates.h"
#include "tests/support/opened_triangles.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

// Twice the area of all triangles that may meet a box.
double area_near(const OpenedTriangulation& triangles, const Box& box) {
  double area = 0.0;
  triangles.visit_near({&box, 1}, [&](std::uint32_t first) {
    const auto [a, b, c] = triangles.positions_of(first);
    EXPECT_GT(orientation(a, b, c), 0);
    EXPECT_EQ(a, triangles.triangulation().points()[triangles.corners_of(first)[0]]);
    area += cross(b - a, c - a);
  });
  return area;
}

// Whether what lies beyond each side of each triangle has the same ends, and this triangle beyond that side.
void expect_joined(const OpenedTriangulation& triangles, const Box& box) {
  triangles.visit_near({&box, 1}, [&](std::uint32_t first) {
    const OpenedTriangulation::Corners corners = triangles.corners_of(first);
    for (std::uint32_t j = 0; j < 3; ++j) {
      const std::uint32_t other = triangles.beyond(first + j);
      if (other == kNone) continue;
      ASSERT_EQ(triangles.beyond(other), first + j);
      const OpenedTriangulation::Corners theirs = triangles.corners_of(other - other % 3);
      EXPECT_EQ(theirs[other % 3], corners[(j + 1) % 3]);
      EXPECT_EQ(theirs[(other % 3 + 1) % 3], corners[j]);
      EXPECT_EQ(triangles.left_of(other), triangles.beyond(Triangulation::previous(other)));
      EXPECT_EQ(triangles.right_of(other), triangles.beyond(Triangulation::next(other)));
    }
  });
}

TEST(OpenedTriangulation, CoversAnOpenedObstacleWithTrianglesJoinedToThoseAround) {
  test::OpenedTriangles t(World({{test::square(0, 0, 4), {test::square(1, 1, 2)}}, {test::square(9, 0, 2), {}}}));
  const Box all = t.world.box().grown(100.0);
  const double before = area_near(t.opened, all);
  expect_joined(t.opened, all);
  ASSERT_TRUE(t.opened.open(t.world, 0));
  EXPECT_EQ(t.opened.opened_vertices(), 8u);
  EXPECT_DOUBLE_EQ(area_near(t.opened, all), before + 2.0 * (16.0 - 4.0));
  expect_joined(t.opened, all);
  std::size_t boundary = 0;
  t.opened.visit_near({&all, 1}, [&](std::uint32_t first) {
    for (std::uint32_t j = 0; j < 3; ++j) boundary += t.opened.beyond(first + j) == kNone ? 1 : 0;
  });
  EXPECT_EQ(boundary, 4u + 4u);  // of the other obstacle and the frame
}

TEST(OpenedTriangulation, OfACopyIsItsOwn) {
  test::OpenedTriangles t(World({{test::square(0, 0, 4), {}}, {test::square(9, 0, 2), {}}}));
  const Box all = t.world.box().grown(100.0);
  const double before = area_near(t.opened, all);
  OpenedTriangulation copy = t.opened;
  ASSERT_TRUE(copy.open(t.world, 1));
  EXPECT_EQ(t.opened.opened_vertices(), 0u);
  EXPECT_DOUBLE_EQ(area_near(t.opened, all), before);
  EXPECT_DOUBLE_EQ(area_near(copy, all), before + 2.0 * 4.0);
}

// Where they touch, the inside of one leads to that of the other.
TEST(OpenedTriangulation, JoinsInsidesOfObstaclesThatTouch) {
  test::OpenedTriangles t(
      World({{test::square(0, 0, 4), {}}, {test::square(4, 1, 2), {}}, {test::square(20, 0, 1), {}}}));
  ASSERT_TRUE(t.opened.open(t.world, 0));
  ASSERT_TRUE(t.opened.open(t.world, 1));
  const Box all = t.world.box().grown(100.0);
  expect_joined(t.opened, all);
  std::size_t boundary = 0;
  t.opened.visit_near({&all, 1}, [&](std::uint32_t first) {
    for (std::uint32_t j = 0; j < 3; ++j) boundary += t.opened.beyond(first + j) == kNone ? 1 : 0;
  });
  EXPECT_EQ(boundary, 4u + 4u);
}

TEST(OpenedTriangulation, RefusesObstaclesThatLieInEachOther) {
  test::OpenedTriangles t(World({{test::square(0, 0, 4), {}}, {test::square(0, 0, 4), {}}}));
  ASSERT_TRUE(t.opened.open(t.world, 0));
  EXPECT_FALSE(t.opened.open(t.world, 1));
}

}  // namespace
}  // namespace arcway::internal

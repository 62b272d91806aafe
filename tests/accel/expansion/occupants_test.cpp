#include "accel/expansion/occupants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "accel/expansion/change_visibility.h"
#include "tests/support/opened_triangles.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

// Numbers of the occupants that may be seen from a point.
std::vector<std::uint32_t> seen_from(const Vec2& point, const test::OpenedTriangles& t, const Occupants& occupants) {
  const Box place{point, point};
  ChangeVisibility viewers(t.opened, &occupants);
  viewers.mark_viewers({&place, 1});
  return viewers.occupants();
}

// A wall between two occupants, each of which is seen from its side.
struct Walled {
  Walled() {
    left.extend(Vec2(-6, 1));
    left.extend(Vec2(-5, 2));
    right.extend(Vec2(5, 1));
    right.extend(Vec2(6, 2));
    occupants.add(t.opened, {100, 104}, left);
    occupants.add(t.opened, {104, 108}, right);
  }

  test::OpenedTriangles t{World({{{{-1, -50}, {1, -50}, {1, 50}, {-1, 50}}, {}},
                                 {{{-10, -50}, {-9, -50}, {-9, 50}, {-10, 50}}, {}},
                                 {{{9, -50}, {10, -50}, {10, 50}, {9, 50}}, {}},
                                 {{{-10, 50}, {10, 50}, {10, 51}, {-10, 51}}, {}},
                                 {{{-10, -51}, {10, -51}, {10, -50}, {-10, -50}}, {}}})};
  Box left, right;
  Occupants occupants;
};

TEST(Occupants, AreSeenWhereTheyLie) {
  const Walled w;
  EXPECT_EQ(seen_from({-3, 0}, w.t, w.occupants), (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(seen_from({3, 0}, w.t, w.occupants), (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(w.occupants.vertex_count(), 8u);
  EXPECT_EQ(w.occupants.numbers(), (std::vector<std::uint32_t>{0, 1}));
}

TEST(Occupants, AreSeenPastAnOpenedWall) {
  Walled w;
  ASSERT_TRUE(w.t.opened.open(w.t.world, 0));
  EXPECT_EQ(seen_from({-3, 0}, w.t, w.occupants), (std::vector<std::uint32_t>{0, 1}));
}

// One that lies across a wall is seen in it once it is opened.
TEST(Occupants, SpreadToTrianglesThatAreNew) {
  Walled w;
  Box across;
  across.extend(Vec2(-0.5, 10));
  across.extend(Vec2(0.5, 11));
  w.occupants.add(w.t.opened, {108, 112}, across);
  EXPECT_EQ(seen_from({3, 0}, w.t, w.occupants), (std::vector<std::uint32_t>{1}));
  ASSERT_TRUE(w.t.opened.open(w.t.world, 0));
  w.occupants.spread(w.t.opened, w.t.world.box_of(0));
  EXPECT_EQ(seen_from({3, 0}, w.t, w.occupants), (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(Occupants, GoWithTheirVerticesAndKeepTheirNumbers) {
  Walled w;
  w.occupants.follow(VertexMap({{100, 104}}, {}));
  EXPECT_EQ(seen_from({-3, 0}, w.t, w.occupants), (std::vector<std::uint32_t>{}));
  EXPECT_EQ(seen_from({3, 0}, w.t, w.occupants), (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(w.occupants.with_number(1).vertices.first, 100u);
  EXPECT_EQ(w.occupants.with_number(1).vertices.last, 104u);
  w.occupants.add(w.t.opened, {104, 108}, w.left);
  EXPECT_EQ(seen_from({-3, 0}, w.t, w.occupants), (std::vector<std::uint32_t>{2}));
}

}  // namespace
}  // namespace arcway::internal

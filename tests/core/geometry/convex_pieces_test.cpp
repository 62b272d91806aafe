#include "core/geometry/convex_pieces.h"

#include <gtest/gtest.h>

#include "arcway/polygon.h"
#include "core/geometry/predicates.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

void expect_split(const Ring& ring) {
  const std::vector<Ring> pieces = convex_pieces(ring);
  double area = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Ring& piece = pieces[i];
    ASSERT_GE(piece.size(), 3u);
    for (std::size_t k = 0; k < piece.size(); ++k)
      EXPECT_GT(orientation(piece[k], piece[(k + 1) % piece.size()], piece[(k + 2) % piece.size()]), 0);
    area += signed_area(piece);
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(interiors_meet(piece, pieces[j]));
  }
  EXPECT_NEAR(area, signed_area(ring), 1e-12 * signed_area(ring));
}

TEST(ConvexPieces, CoverStarsOnce) {
  test::RandomInputs random(11);
  for (int i = 0; i < 200; ++i)
    expect_split(
        test::random_star(random, random.point(-5, 5), 0.2, 2.0, static_cast<std::size_t>(random.integer(4, 40))));
}

// Coordinates are small integers: many triples on a line.
TEST(ConvexPieces, CoverCombsOnce) {
  test::RandomInputs random(12);
  for (int i = 0; i < 100; ++i) {
    const auto teeth = random.integer(1, 8);
    Ring ring{{0, 0}, {2.0 * static_cast<double>(teeth), 0}};
    for (std::int64_t k = teeth; k-- > 0;) {
      const auto x = 2.0 * static_cast<double>(k), top = static_cast<double>(random.integer(2, 4));
      for (const Vec2& p : {Vec2(x + 2, 1), Vec2(x + 1.5, top), Vec2(x + 1, top), Vec2(x + 1, 1)}) ring.push_back(p);
    }
    ring.emplace_back(0, 1);
    expect_split(ring);
  }
}

TEST(ConvexPieces, LeaveConvexRingsWhole) {
  for (const std::size_t corners : {3u, 4u, 7u, 60u}) {
    const std::vector<Ring> pieces = convex_pieces(Polygon::regular({1, 2}, 3.0, corners).outer);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces[0].size(), corners);
  }
}

TEST(ConvexPieces, AreFewWhereADiagonalServesTwoCorners) {
  EXPECT_EQ(
      convex_pieces(
          {{-1, -5}, {1, -5}, {1, -4}, {2, -4}, {2, -2}, {1, -2}, {1, 2}, {2, 2}, {2, 4}, {1, 4}, {1, 5}, {-1, 5}})
          .size(),
      3u);
  EXPECT_EQ(convex_pieces(Ring{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}).size(), 2u);
}

TEST(ConvexPieces, ThatTouchHaveNoInnerPointInCommon) {
  EXPECT_FALSE(interiors_meet(test::square(0, 0, 1), test::square(1, 0.5, 1)));
  EXPECT_FALSE(interiors_meet(test::square(0, 0, 1), test::square(1, 1, 1)));
  EXPECT_TRUE(interiors_meet(test::square(0, 0, 1), test::square(1.0 - 1e-16, 0.5, 1)));
  EXPECT_TRUE(interiors_meet(test::square(0, 0, 3), test::square(1, 1, 1)));
}

}  // namespace
}  // namespace arcway::internal

#include "arcway/visibility_query.h"

#include <gtest/gtest.h>

#include "arcway/query_set.h"

namespace arcway::internal {
namespace {

bool sees(const World& world, const Vec2& a, const Vec2& b) {
  const QuerySet queries = make_reference_queries(world);
  const bool forwards = queries.visibility->visible(LineSegment{a, b});
  EXPECT_EQ(forwards, queries.visibility->visible(LineSegment{b, a}));
  return forwards;
}

const Polygon kBox{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {}};

TEST(Visibility, TouchingIsSeeingCrossingIsNot) {
  const World world({kBox});
  EXPECT_TRUE(sees(world, {-1, 0}, {5, 0}));    // along an edge
  EXPECT_TRUE(sees(world, {-1, 1}, {1, -1}));   // through a vertex
  EXPECT_TRUE(sees(world, {0, 0}, {4, 0}));     // an edge itself
  EXPECT_FALSE(sees(world, {0, 0}, {4, 4}));    // a diagonal
  EXPECT_FALSE(sees(world, {-1, -1}, {5, 5}));  // through two vertices
  EXPECT_FALSE(sees(world, {-1, 2}, {5, 2}));
  EXPECT_FALSE(sees(world, {0, 1}, {2, 0}));  // from edge to edge
  EXPECT_FALSE(sees(world, {1, 1}, {2, 2}));  // wholly inside
  EXPECT_FALSE(sees(world, {1, 1}, {1, 1}));
  EXPECT_TRUE(sees(world, {0, 1}, {0, 1}));
}

TEST(Visibility, PassesBetweenObstaclesThatTouch) {
  const World world({kBox, {{{4, 0}, {8, 0}, {8, 4}, {4, 4}}, {}}});
  EXPECT_TRUE(sees(world, {4, -1}, {4, 5}));
  EXPECT_FALSE(sees(world, {4.5, -1}, {3.5, 5}));
}

TEST(Visibility, EndsAtTheBounds) {
  const World world({}, Ring{{0, 0}, {4, 0}, {4, 4}, {2, 2}, {0, 4}});
  EXPECT_TRUE(sees(world, {0, 0}, {4, 0}));
  EXPECT_TRUE(sees(world, {1, 3}, {3, 1}));
  EXPECT_FALSE(sees(world, {0, 4}, {4, 4}));
  EXPECT_FALSE(sees(world, {1, 1}, {5, 1}));
}

TEST(Visibility, AHoleThatTouchesItsRingIsFreeFromTheTouchingPoint) {
  const World world({{{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 4}}, {{{0, 4}, {3, 3}, {3, 5}}}}});
  EXPECT_TRUE(sees(world, {0, 4}, {2, 4}));
  EXPECT_TRUE(sees(world, {-2, 4}, {2, 4}));  // in through the touching point
  EXPECT_TRUE(sees(world, {0, 4}, {3, 3}));
  EXPECT_TRUE(sees(world, {0, 0}, {0, 8}));
  EXPECT_FALSE(sees(world, {0, 4}, {4, 4}));
  EXPECT_FALSE(sees(world, {0, 4}, {2, 6}));
}

TEST(Visibility, LobesThatTouchBlockEachOnItsOwn) {
  const World world({{{{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}, {}}});
  EXPECT_TRUE(sees(world, {2, 0}, {2, 4}));
  EXPECT_FALSE(sees(world, {0, 2}, {4, 2}));
  EXPECT_FALSE(sees(world, {2, 2}, {4, 2}));
}

}  // namespace
}  // namespace arcway::internal

#include "core/gaps/minimum_distances.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/geometry/predicates.h"
#include "tests/support/boxes.h"

namespace arcway::internal {
namespace {

using Ids = std::vector<ObstacleId>;

using test::box;

// A path to the right and then up: the bisector at (10, 0) runs from the lower right to the upper left.
const std::vector<Vec2> kCorner = {{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}};

World corner_world() {
  return World({box(2.0, 1.0, 4.0, 2.0),      // 0: left of the first segment
                box(3.0, -3.0, 5.0, -0.5),    // 1: right of the first segment
                box(7.0, 1.5, 9.0, 4.0),      // 2: left, on the bisector: of both
                box(11.0, 5.0, 12.0, 6.0)});  // 3: right of the second segment
}

TEST(MinimumDistances, RadialSets) {
  const MinimumDistances found = minimum_distances(corner_world(), kCorner);
  ASSERT_EQ(found.by_segment.size(), 2u);
  EXPECT_EQ(found.by_segment[0].left, (Ids{0, 2}));
  EXPECT_EQ(found.by_segment[0].right, (Ids{1}));
  EXPECT_EQ(found.by_segment[1].left, (Ids{2}));
  EXPECT_EQ(found.by_segment[1].right, (Ids{3}));
  EXPECT_EQ(found.obstacles.left, (Ids{0, 2}));
  EXPECT_EQ(found.obstacles.right, (Ids{1, 3}));
}

TEST(MinimumDistances, PairsAcrossASegment) {
  const MinimumDistances found = minimum_distances(corner_world(), kCorner);
  ASSERT_EQ(found.pairs.size(), 3u);
  EXPECT_EQ(found.pairs[0].left, 0u);
  EXPECT_EQ(found.pairs[0].right, 1u);
  EXPECT_DOUBLE_EQ(found.pairs[0].distance, 1.5);
  EXPECT_EQ(found.pairs[1].left, 2u);
  EXPECT_EQ(found.pairs[1].right, 1u);
  EXPECT_DOUBLE_EQ(found.pairs[1].distance, std::hypot(2.0, 2.0));
  EXPECT_EQ(found.pairs[1].on_left, Vec2(7.0, 1.5));
  EXPECT_EQ(found.pairs[1].on_right, Vec2(5.0, -0.5));
  EXPECT_EQ(found.pairs[2].segment, 1u);
  EXPECT_EQ(found.pairs[2].left, 2u);
  EXPECT_EQ(found.pairs[2].right, 3u);
  EXPECT_DOUBLE_EQ(found.pairs[2].distance, std::hypot(2.0, 1.0));
  for (const ObstaclePairDistance& pair : found.pairs) {
    EXPECT_NEAR((pair.on_left - pair.on_right).norm(), pair.distance, 1e-15);
  }
}

TEST(MinimumDistances, SegmentsToObstacles) {
  const MinimumDistances found = minimum_distances(corner_world(), kCorner);
  ASSERT_EQ(found.to_segments.size(), 5u);
  const double expected[] = {1.0, 0.5, 1.5, 1.0, 1.0};
  const ObstacleId obstacle[] = {0, 1, 2, 2, 3};
  for (std::size_t i = 0; i < 5; ++i) {
    const SegmentObstacleDistance& d = found.to_segments[i];
    EXPECT_EQ(d.segment, i < 3 ? 0u : 1u);
    EXPECT_EQ(d.obstacle, obstacle[i]);
    EXPECT_DOUBLE_EQ(d.distance, expected[i]);
    EXPECT_NEAR((d.on_segment - d.on_obstacle).norm(), d.distance, 1e-15);
  }
  EXPECT_EQ(found.to_segments[1].side, Side::kRight);
}

// The text's distance between vertices would be 2.06 here.
TEST(MinimumDistances, VertexToEdge) {
  const World world({{{Vec2(0.0, 1.0), Vec2(2.0, 3.0), Vec2(-2.0, 3.0)}, {}}, box(-0.5, -2.0, 9.0, -1.0)});
  const std::vector<Vec2> path = {{-5.0, 0.0}, {5.0, 0.0}};
  const MinimumDistances found = minimum_distances(world, path);
  ASSERT_EQ(found.pairs.size(), 1u);
  EXPECT_DOUBLE_EQ(found.pairs[0].distance, 2.0);
  EXPECT_EQ(found.pairs[0].on_right, Vec2(0.0, -1.0));
}

TEST(MinimumDistances, PathThatTouchesAnObstacle) {
  const World world({box(4.0, 0.0, 6.0, 2.0)});
  const std::vector<Vec2> path = {{0.0, 0.0}, {10.0, 0.0}};
  const MinimumDistances found = minimum_distances(world, path);
  ASSERT_EQ(found.to_segments.size(), 1u);
  EXPECT_EQ(found.to_segments[0].distance, 0.0);
  EXPECT_EQ(found.to_segments[0].side, Side::kLeft);
  EXPECT_TRUE(found.pairs.empty());
}

TEST(MinimumDistances, RefusesPathsThatAreNone) {
  const World world({});
  EXPECT_THROW(minimum_distances(world, std::vector<Vec2>{{0.0, 0.0}}), std::invalid_argument);
  EXPECT_THROW(minimum_distances(world, std::vector<Vec2>{{0.0, 0.0}, {0.0, 0.0}}), std::invalid_argument);
  EXPECT_THROW(minimum_distances(world, std::vector<Vec2>{{0.0, 0.0}, {std::nan(""), 0.0}}), std::invalid_argument);
}

TEST(MinimumDistances, TakesTheSideOfTheNearestSegmentAndOfTheLargerPart) {
  // Left of the path there, right of the path back, which passes nearer by.
  const std::vector<Vec2> there_and_back{{0, 0}, {10, 0}, {10, 2}, {0, 2}};
  const MinimumDistances turned = minimum_distances(World({box(4, 3, 5, 4)}), there_and_back);
  EXPECT_EQ(turned.by_segment[0].left, Ids{0});
  EXPECT_EQ(turned.by_segment[2].right, Ids{0});
  EXPECT_TRUE(turned.obstacles.left.empty());
  EXPECT_EQ(turned.obstacles.right, Ids{0});
  // Across the way.
  const std::vector<Vec2> line{{0, 0}, {10, 0}};
  EXPECT_EQ(minimum_distances(World({box(4, -3, 5, 1)}), line).obstacles.right, Ids{0});
  EXPECT_EQ(minimum_distances(World({box(4, -1, 5, 3)}), line).obstacles.left, Ids{0});
}

TEST(MinimumDistances, ThePathMayTurnBack) {
  const std::vector<Vec2> path{{0, 0}, {10, 0}, {5, 0}};
  const MinimumDistances distances = minimum_distances(World({box(3, 2, 4, 3)}), path);
  EXPECT_EQ(distances.by_segment[0].left, Ids{0});
  EXPECT_EQ(distances.obstacles.left, Ids{0});
  EXPECT_TRUE(distances.by_segment[1].left.empty() && distances.by_segment[1].right.empty());
}

}  // namespace
}  // namespace arcway::internal

#include "core/search/point_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "arcway/datasets/clutter.h"
#include "arcway/query_set.h"
#include "core/base/infinity.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

PointDistance point_distance(const World& world, const QuerySet& queries) {
  return {world, rows_of(world, build_reduced_visibility_graph(world, *queries.visibility)),
          std::make_shared<const Outlines>(world)};
}

double distance_in(const World& world, const Vec2& start, const Vec2& goal) {
  const QuerySet queries = make_reference_queries(world);
  PointDistance::Workspace workspace;
  return point_distance(world, queries)(start, goal, *queries.visibility, workspace);
}

// Dijkstra over start, goal and all vertices, every pair asked for.
double brute_force(const World& world, const Vec2& start, const Vec2& goal) {
  const QuerySet queries = make_reference_queries(world);
  std::vector<Vec2> points{start, goal};
  points.insert(points.end(), world.vertices().begin(), world.vertices().end());
  std::vector<double> length(points.size(), kInfinity);
  std::vector<bool> done(points.size(), false);
  length[0] = 0.0;
  for (;;) {
    std::size_t next = points.size();
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!done[i] && length[i] < kInfinity && (next == points.size() || length[i] < length[next])) next = i;
    if (next == points.size() || next == 1) return length[1];
    done[next] = true;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!done[i] && queries.visibility->visible({points[next], points[i]}))
        length[i] = std::min(length[i], length[next] + (points[i] - points[next]).norm());
  }
}

TEST(PointDistance, GoesRoundASquare) {
  const World world({{test::square(2.0, -1.0, 2.0), {}}});
  EXPECT_NEAR(distance_in(world, {0, 0}, {6, 0}), 2.0 + 2.0 * std::sqrt(5.0), 1e-12);
  EXPECT_DOUBLE_EQ(distance_in(world, {0, 1}, {6, 1}), 6.0);  // along its edge
  EXPECT_DOUBLE_EQ(distance_in(world, {0, 3}, {6, 3}), 6.0);
  EXPECT_EQ(distance_in(world, {1, 0}, {1, 0}), 0.0);
  EXPECT_DOUBLE_EQ(distance_in(World({}), {0, 0}, {3, 4}), 5.0);
}

TEST(PointDistance, IsInfiniteWhereThereIsNoWay) {
  const World ring({{test::square(0.0, 0.0, 10.0), {test::reversed(test::square(2.0, 2.0, 6.0))}}});
  EXPECT_EQ(distance_in(ring, {5, 5}, {20, 5}), kInfinity);
  EXPECT_LT(distance_in(ring, {3, 3}, {7, 7}), kInfinity);
}

TEST(PointDistance, IsThatOfAllPairsOfVertices) {
  test::RandomInputs random(11);
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const ClutterKind kind = seed % 2 == 0 ? ClutterKind::kStar : ClutterKind::kConvex;
    const World world = random_world({.kind = kind, .obstacles = 8, .vertices = 6, .fill = 0.35, .seed = seed});
    const QuerySet queries = make_reference_queries(world);
    const PointDistance distance = point_distance(world, queries);
    PointDistance::Workspace workspace;
    for (int i = 0; i < 12; ++i) {
      const auto free_point = [&] {
        for (;;) {
          const Vec2 p = random.point(0.0, world.box().max.x());
          if (queries.distance->containing(p) == kNone) return p;
        }
      };
      const Vec2 start = free_point(), goal = free_point();
      const double expected = brute_force(world, start, goal);
      EXPECT_NEAR(distance(start, goal, *queries.visibility, workspace), expected, 1e-12 * expected) << "seed " << seed;
      EXPECT_NEAR(distance(goal, start, *queries.visibility, workspace), expected, 1e-12 * expected) << "seed " << seed;
    }
  }
}

TEST(PointDistance, MayPassWhereTwoSquaresTouch) {
  const World world({{test::square(0.0, 0.0, 2.0), {}}, {test::square(2.0, 2.0, 2.0), {}}});
  EXPECT_NEAR(distance_in(world, {1, 3}, {3, 1}), 2.0 * std::sqrt(2.0), 1e-12);
  const double round = distance_in(world, {1, 3}, {1, -1});
  EXPECT_NEAR(round, brute_force(world, {1, 3}, {1, -1}), 1e-12);
}

// Squares that share corners, squares that share edges, and rows of collinear vertices: taut where angles are zero.
TEST(PointDistance, IsThatOfAllPairsAmongContacts) {
  test::RandomInputs random(12);
  for (int world_index = 0; world_index < 12; ++world_index) {
    std::vector<Polygon> squares;
    for (int x = 0; x < 6; ++x)
      for (int y = 0; y < 6; ++y)
        if (random.uniform(0.0, 1.0) < 0.3) squares.push_back({test::square(x, y, 1.0), {}});
    const World world(squares);
    const QuerySet queries = make_reference_queries(world);
    const PointDistance distance = point_distance(world, queries);
    PointDistance::Workspace workspace;
    for (int i = 0; i < 12; ++i) {
      // On corners, on edges and off them.
      const auto place = [&] {
        const double part = i % 3 == 0 ? 1.0 : i % 3 == 1 ? 2.0 : 8.0;
        for (;;) {
          const Vec2 p = (random.point(-1.0, 7.0) * part).array().round().matrix() / part;
          if (queries.distance->containing(p) == kNone) return p;
        }
      };
      const Vec2 start = place(), goal = place();
      const double expected = brute_force(world, start, goal);
      const double found = distance(start, goal, *queries.visibility, workspace);
      if (std::isinf(expected)) {
        EXPECT_EQ(found, expected);
      } else {
        EXPECT_NEAR(found, expected, 1e-12 * (1.0 + expected)) << "world " << world_index << ", query " << i;
      }
    }
  }
}

}  // namespace
}  // namespace arcway::internal

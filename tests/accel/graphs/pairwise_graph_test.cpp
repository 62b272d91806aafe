#include "accel/graphs/pairwise_graph.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstdlib>
#include <stop_token>
#include <string>

#include "accel/backend/make_queries.h"
#include "arcway/accel/parallel.h"
#include "arcway/datasets/clutter.h"
#include "tests/support/troublesome_queries.h"

namespace arcway::internal {
namespace {

VisibilityGraph expected_graph(const World& world) {
  return build_reduced_visibility_graph(world, *make_reference_queries(world).visibility);
}

void expect_reference_graph(const World& world) {
  const VisibilityGraph expected = expected_graph(world);
  const QuerySet queries = make_embree_queries(world);
  for (const TangentSearch search : {TangentSearch::kBinary, TangentSearch::kAllPairs}) {
    EXPECT_TRUE(build_pairwise_visibility_graph(world, *queries.visibility, SerialExecutor(), search) == expected);
  }
  EXPECT_TRUE(build_reduced_visibility_graph(world, *queries.visibility) == expected);
}

TEST(PairwiseGraph, IsTheReferenceGraphAmongAllKindsOfClutter) {
  for (const ClutterKind kind :
       {ClutterKind::kConvex, ClutterKind::kStar, ClutterKind::kMixed, ClutterKind::kRectangle}) {
    for (const double fill : {0.1, 0.3, 0.5}) {
      SCOPED_TRACE(std::string(name_of(kind)) + ", fill " + std::to_string(fill));
      expect_reference_graph(random_world({.kind = kind, .obstacles = 30, .vertices = 9, .fill = fill, .seed = 5}));
    }
  }
}

TEST(PairwiseGraph, IsTheReferenceGraphAmongTouchingAndCollinearObstacles) {
  std::size_t edges = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const test::TroublesomeQueries questions(seed, seed % 2 == 0 ? 64.0 : 0x1p-10, seed % 3 == 0 ? 0x1p14 : 0.0);
    expect_reference_graph(questions.world());
    edges += expected_graph(questions.world()).edge_count();
  }
  EXPECT_GT(edges, 1000u);
}

TEST(PairwiseGraph, IsTheReferenceGraphOfConvexObstaclesThatOverlap) {
  test::RandomInputs random(8);
  for (int world = 0; world < 20; ++world) {
    std::vector<Polygon> obstacles;
    for (int i = 0; i < 12; ++i) {
      Ring ring;
      const Vec2 center = random.point(0, 40);
      const double radius = random.uniform(1, 8);
      const int vertices = static_cast<int>(random.integer(3, 80));
      for (int k = 0; k < vertices; ++k) ring.push_back(center + radius * direction_of(kTwoPi * k / vertices));
      obstacles.push_back({ring, {}});
    }
    SCOPED_TRACE("world " + std::to_string(world));
    expect_reference_graph(World(std::move(obstacles)));
  }
}

// All corners of these obstacles are convex, the obstacles are not.
TEST(PairwiseGraph, IsTheReferenceGraphAmongPairsOfTrianglesThatTouchInACorner) {
  std::vector<Polygon> obstacles;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      Ring ring{{4, 3}, {0, 4}, {0, 0}, {4, 0}, {4, 2}, {0, 0}};
      for (Vec2& p : ring)
        p = (i + k) % 2 == 0 ? Vec2(10 * i + p.x(), 9 * k + p.y()) : Vec2(10 * i - p.y(), 9 * k + p.x());
      obstacles.push_back({ring, {}});
    }
  expect_reference_graph(World(std::move(obstacles)));
}

TEST(PairwiseGraph, FindsTangentsOfConvexObstaclesBySearch) {
  const World world = random_world({.obstacles = 100, .vertices = 10, .fill = 0.2, .seed = 5});
  const QuerySet queries = make_embree_queries(world);
  PairwiseCounts binary;
  PairwiseCounts all;
  const SerialExecutor serial;
  const auto& visibility = *queries.visibility;
  EXPECT_TRUE(build_pairwise_visibility_graph(world, visibility, serial, TangentSearch::kBinary, &binary) ==
              build_pairwise_visibility_graph(world, visibility, serial, TangentSearch::kAllPairs, &all));
  EXPECT_EQ(binary.tangent_pairs, all.tangent_pairs);
  EXPECT_EQ(all.binary_pairs, 0u);
  EXPECT_GT(binary.binary_pairs, 100u * 99u / 2u * 9u / 10u);
  const std::size_t n = world.convex_vertices().size();
  EXPECT_EQ(all.vertex_pairs, n * (n - 1) / 2);
}

// Takes a minute of brute force and runs on request only, see accel/README.md.
TEST(PairwiseGraph, IsTheReferenceGraphOfTenThousandVertices) {
  if (std::getenv("ARCWAY_LONG_TESTS") == nullptr) GTEST_SKIP() << "runs where ARCWAY_LONG_TESTS is set";
  for (const ClutterKind kind : {ClutterKind::kConvex, ClutterKind::kStar}) {
    SCOPED_TRACE(name_of(kind));
    expect_reference_graph(random_world({.kind = kind, .obstacles = 1250, .vertices = 8, .fill = 0.3, .seed = 9}));
  }
}

TEST(PairwiseGraph, IsTheSameForAnyNumberOfThreads) {
  const tbb::global_control eight(tbb::global_control::max_allowed_parallelism, 8);
  const World world = random_world({.kind = ClutterKind::kMixed, .obstacles = 80, .fill = 0.25, .seed = 11});
  const QuerySet queries = make_embree_queries(world);
  const VisibilityGraph expected = build_pairwise_visibility_graph(world, *queries.visibility, SerialExecutor());
  for (const std::size_t threads : {1u, 2u, 3u, 8u}) {
    const TbbExecutor executor(threads);
    EXPECT_TRUE(build_pairwise_visibility_graph(world, *queries.visibility, executor) == expected) << threads;
    EXPECT_TRUE(build_reduced_visibility_graph(world, *queries.visibility, executor) == expected) << threads;
  }
}

TEST(PairwiseGraph, CanBeCanceled) {
  const World world = random_world({.obstacles = 100, .seed = 2});
  const QuerySet queries = make_embree_queries(world);
  const TbbExecutor threads(2);
  std::stop_source stop;
  const StoppableExecutor executor(threads, stop.get_token());
  EXPECT_GT(build_pairwise_visibility_graph(world, *queries.visibility, executor).edge_count(), 0u);
  stop.request_stop();
  EXPECT_THROW(build_pairwise_visibility_graph(world, *queries.visibility, executor), Canceled);
}

}  // namespace
}  // namespace arcway::internal

#include "arcway/accel/tangent_cone_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stop_token>
#include <string>
#include <vector>

#include "accel/backend/make_queries.h"
#include "accel/expansion/free_space_triangulation.h"
#include "accel/expansion/long_fans.h"
#include "accel/graphs/pairwise_graph.h"
#include "arcway/accel/parallel.h"
#include "arcway/datasets/catalog.h"
#include "arcway/datasets/clutter.h"
#include "arcway/progress.h"
#include "arcway/query_set.h"
#include "core/geometry/predicates.h"
#include "tests/support/nasty_worlds.h"
#include "tests/support/sleeve_graph.h"

namespace arcway::internal {
namespace {

constexpr std::uint64_t kNastyWorlds = 1500;

VisibilityGraph reference(const World& world) {
  return build_reduced_visibility_graph(world, *make_reference_queries(world).visibility);
}

std::string edges_missing_from(const VisibilityGraph& from, const VisibilityGraph& graph) {
  std::string text;
  for (VertexId u = 0; u < graph.vertex_count(); ++u)
    for (const VertexId v : graph.row(u)) {
      const auto row = from.row(u);
      if (!std::binary_search(row.begin(), row.end(), v)) text += " " + std::to_string(u) + "-" + std::to_string(v);
    }
  return text;
}

::testing::AssertionResult agrees(const VisibilityGraph& graph, const VisibilityGraph& expected) {
  if (graph == expected) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "missing:" << edges_missing_from(graph, expected)
                                       << "\nextra:" << edges_missing_from(expected, graph);
}

::testing::AssertionResult agrees(const World& world) {
  const VisibilityGraph expected = reference(world);
  if (const auto result = agrees(build_reduced_visibility_graph_by_tangent_cones(world), expected); !result)
    return result;
  for (const Diagonals shortened : {Diagonals::kLong, Diagonals::kAll})
    if (auto result = agrees(test::graph_by_sleeves(world, shortened), expected); !result)
      return result << "\nby sleeves";
  return ::testing::AssertionSuccess();
}

TEST(TangentConeGraph, Clutters) {
  for (const ClutterKind kind :
       {ClutterKind::kConvex, ClutterKind::kStar, ClutterKind::kMixed, ClutterKind::kRectangle})
    for (const std::uint64_t seed : {1, 2, 3}) {
      const World world = random_world({.kind = kind, .obstacles = 40, .vertices = 9, .fill = 0.3, .seed = seed});
      EXPECT_TRUE(agrees(world)) << name_of(kind) << " " << seed;
    }
}

// A chain's rays may begin to lead left in the middle of a sleeve along it, which ends the chain there.
TEST(TangentConeGraph, ChainsThatEndWithinSleeves) {
  for (std::uint64_t seed = 40; seed < 130; ++seed)
    ASSERT_TRUE(agrees(random_world({.obstacles = 3, .vertices = 16, .fill = 0.3, .seed = seed}))) << "seed " << seed;
}

TEST(TangentConeGraph, NastyWorlds) {
  for (std::uint64_t seed = 0; seed < kNastyWorlds; ++seed)
    ASSERT_TRUE(agrees(test::nasty_world(seed, 14))) << "seed " << seed;
  for (std::uint64_t seed = 0; seed < kNastyWorlds / 20; ++seed)
    ASSERT_TRUE(agrees(test::nasty_world(seed, 80))) << "large, seed " << seed;
}

TEST(TangentConeGraph, WorldsOfTheCatalog) {
  for (const char* family : {"corridor",
                             "city",
                             "coastline",
                             "islands",
                             "maze",
                             "rooms",
                             "warehouse",
                             "adversarial/touching",
                             "adversarial/shared",
                             "adversarial/collinear",
                             "adversarial/needles",
                             "adversarial/far",
                             "adversarial/nested",
                             "adversarial/overlapping",
                             "adversarial/contacts",
                             "adversarial/holes",
                             "adversarial/saw",
                             "adversarial/comb",
                             "adversarial/spikes",
                             "adversarial/rings"})
    EXPECT_TRUE(agrees(catalog_world(std::string(family) + "/v250/s2"))) << family;
}

TEST(TangentConeGraph, NothingAndLittle) {
  EXPECT_TRUE(agrees(World({})));
  EXPECT_TRUE(agrees(World({}, test::square(0, 0, 4))));
  EXPECT_TRUE(agrees(World({{test::square(0, 0, 4), {}}})));
  EXPECT_EQ(build_reduced_visibility_graph_by_tangent_cones(World({{test::square(0, 0, 4), {}}})).edge_count(), 4u);
}

// Lines of sight between the columns run along two boundaries at once, and so do those between the rows.
TEST(TangentConeGraph, RowsOfBoxesThatTouch) {
  std::vector<Polygon> boxes;
  for (int i = 0; i < 9; ++i)
    for (int k = 0; k < 9; ++k)
      if ((i * 5 + k * 3) % 7 != 0) boxes.push_back({test::square(i, k, 1), {}});
  EXPECT_TRUE(agrees(World(boxes)));
  EXPECT_TRUE(agrees(World(boxes, test::square(0, 0, 9))));
  EXPECT_TRUE(agrees(World(boxes, test::square(3, 3, 4))));
}

TEST(TangentConeGraph, LongRowsOfEqualBoxes) {
  std::vector<Polygon> boxes;
  for (int i = 0; i < 12; ++i)
    for (int k = 0; k < 12; ++k) boxes.push_back({test::square(2 * i, 3 * k, 1), {}});
  EXPECT_TRUE(agrees(World(boxes)));
}

TEST(TangentConeGraph, NeedlesAndNearlyParallelEdges) {
  EXPECT_TRUE(agrees(World({{{{0, 0}, {1000000, 1}, {1000000, 2}}, {}},
                            {{{0, 5}, {1000000, 6}, {0, 7}}, {}},
                            {test::square(400000, 20, 10), {}},
                            {{{10, -3}, {999999, -3}, {999998, -2}}, {}}})));
}

TEST(TangentConeGraph, CoordinatesAtTheEndsOfTheRange) {
  for (const double scale : {kMinMagnitude, 1e-60, 1e60, 0.01 * kMaxMagnitude}) {
    std::vector<Polygon> boxes;
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k) boxes.push_back({test::square(3 * i + k, 2 * k, 1 + k % 2), {}});
    for (Polygon& box : boxes)
      for (Vec2& p : box.outer) p *= scale;
    EXPECT_TRUE(agrees(World(boxes))) << scale;
  }
}

TEST(TangentConeGraph, OnePolygonOfManyVertices) {
  test::RandomInputs random(5);
  EXPECT_TRUE(agrees(World({{test::random_star(random, {0, 0}, 20, 100, 700), {}}})));
  EXPECT_TRUE(agrees(World({}, test::random_star(random, {0, 0}, 20, 100, 700))));
}

Ring round(const Vec2& center, double radius, int vertices) {
  Ring ring;
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / vertices;
    ring.push_back(center + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

// Long chains of nodes that are expanded at once.
TEST(TangentConeGraph, SmoothObstacles) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    test::RandomInputs random(seed);
    std::vector<Polygon> obstacles;
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 3; ++k)
        obstacles.push_back(
            {round({3.0 * i + random.uniform(-0.4, 0.4), 3.0 * k}, random.uniform(0.3, 1.4), 10 * i + 20 * k + 7), {}});
    EXPECT_TRUE(agrees(World(obstacles))) << seed;
    EXPECT_TRUE(agrees(World(obstacles, round({4.5, 3.0}, 12.0, 50)))) << seed;
  }
}

// Teeth around a circle, or along a line if the radius is 0. The free space outside is a fan around each corner of the
// frame.
Ring saw(test::RandomInputs& random, std::size_t teeth, double radius, double deepest, bool is_on_grid) {
  Ring ring;
  for (std::size_t i = 0; i < 2 * teeth; ++i) {
    const double share = static_cast<double>(i) / (2.0 * static_cast<double>(teeth));
    const double depth = i % 2 == 0 ? 0.0 : random.uniform(0.1, 1.0) * deepest;
    Vec2 p =
        radius > 0.0 ? Vec2((radius - depth) * direction_of(kTwoPi * share)) : Vec2(static_cast<double>(i), -depth);
    if (is_on_grid) p = p.array().round();
    ring.push_back(p);
  }
  if (radius == 0.0) {
    ring.push_back({2.0 * static_cast<double>(teeth), -2.0 * deepest});
    ring.push_back({-1.0, -2.0 * deepest});
    std::reverse(ring.begin(), ring.end());
  }
  return ring;
}

TEST(TangentConeGraph, LongFansAroundSaws) {
  test::RandomInputs random(7);
  std::size_t fans = 0;
  for (int round = 0; round < 24; ++round) {
    const bool is_line = round % 3 == 0, is_on_grid = round % 2 == 0;
    const double turn = random.uniform(0.0, round % 4 < 2 ? 0.0 : 6.0);
    Ring ring = saw(random, static_cast<std::size_t>(random.integer(140, 180)), is_line ? 0.0 : 400.0,
                    random.uniform(2.0, is_line ? 20.0 : 200.0), is_on_grid);
    for (Vec2& p : ring) p = p.x() * direction_of(turn) + p.y() * perpendicular(direction_of(turn));
    std::vector<Polygon> obstacles{{ring, {}}};
    for (std::int64_t k = random.integer(0, 4); k > 0; --k)
      obstacles.push_back({test::random_star(random, 500.0 * direction_of(random.uniform(0, 6)), 5.0, 60.0, 9), {}});
    try {
      const World world(obstacles);
      ASSERT_TRUE(agrees(world)) << "round " << round;
      fans += LongFans(FreeSpaceTriangulation(world), 32).size();
    } catch (const WorldError&) {  // rounded to the grid, teeth may cross
    }
  }
  EXPECT_GT(fans, 30u);
}

TEST(TangentConeGraph, LongFansEndAtTheirClock) {
  test::RandomInputs random(7);
  const FreeSpaceTriangulation triangulation(World({{saw(random, 200, 400.0, 50.0, false), {}}}));
  EXPECT_FALSE(LongFans(triangulation, 32).empty());
  EXPECT_THROW((void)LongFans(triangulation, 32, StopClock(0.0)), Canceled);
}

// Needles side by side, each with a vertex on the next one's long edge. The boxes of all edges overlap, so contacts are
// found by a sweep. A box across the needles makes edges cross, which the sweep does not handle.
TEST(TangentConeGraph, ContactsOfLongEdges) {
  for (const bool crosses : {false, true})
    for (const double turn : {0.0, 0.3}) {
      const double n = 90.0;
      std::vector<Polygon> obstacles;
      for (double k = 0.0; k < n; ++k) obstacles.push_back({{{0, k}, {1, k}, {n, n + k}}, {}});
      if (crosses) obstacles.push_back({test::square(0.5, n + 0.5, 3.0), {}});
      for (Polygon& polygon : obstacles)
        for (Vec2& p : polygon.outer) p = p.x() * direction_of(turn) + p.y() * perpendicular(direction_of(turn));
      EXPECT_TRUE(agrees(World(obstacles))) << crosses << " " << turn;
    }
}

// A ring within a ring of teeth: fans from outside and from inside.
TEST(TangentConeGraph, LongFansWithinARing) {
  test::RandomInputs random(8);
  for (int round = 0; round < 10; ++round) {
    const Ring outer = test::square(-500, -500, 1000);
    Ring hole = test::reversed(saw(random, 90, 300.0, 3.0, false));
    EXPECT_TRUE(agrees(World({{outer, {hole}}, {test::random_star(random, {20, 30}, 20, 250, 60), {}}}))) << round;
  }
}

// Worlds in which the builder uses fans by itself: the steps a vertex stay the same at every size.
TEST(TangentConeGraph, StepsAroundASawGrowLikeItsTeeth) {
  for (const std::size_t teeth : {5000, 20000}) {
    test::RandomInputs random(9);
    const World world({{saw(random, teeth, static_cast<double>(teeth), 2.0, false), {}}});
    TangentConeStatistics statistics;
    const VisibilityGraph graph = build_reduced_visibility_graph_by_tangent_cones(world, SerialExecutor(), &statistics);
    EXPECT_GE(graph.edge_count(), teeth);
    EXPECT_LT(statistics.steps, 12 * world.vertices().size());
    for (const std::size_t threads : {2, 3})
      EXPECT_TRUE(graph == build_reduced_visibility_graph_by_tangent_cones(world, TbbExecutor(threads)));
  }
}

// Worlds in which the builder uses sleeves by itself.
TEST(TangentConeGraph, LongConvexChains) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const World world = random_world({.obstacles = 15, .vertices = 90, .fill = 0.35, .seed = seed});
    EXPECT_FALSE(worthwhile_sleeves(world, FreeSpaceTriangulation(world)).empty());
    EXPECT_TRUE(agrees(world)) << seed;
  }
}

// Rays of a chain pass vertices exactly, and edges of other obstacles lie on the lines of its own edges.
TEST(TangentConeGraph, RoundObstaclesOnAGrid) {
  const Ring octagon{{1, 0}, {2, 0}, {3, 1}, {3, 2}, {2, 3}, {1, 3}, {0, 2}, {0, 1}};
  std::vector<Polygon> obstacles;
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 6; ++k) {
      if ((i + 2 * k) % 5 == 0) continue;
      obstacles.push_back({octagon, {}});
      for (Vec2& p : obstacles.back().outer) p += Vec2(4 * i + (k % 3), 3 * k + (i % 2));
    }
  EXPECT_TRUE(agrees(World(obstacles)));
  EXPECT_TRUE(agrees(World(obstacles, test::square(-1, -1, 40))));
}

// Chains that turn more than once around, with other obstacles in their arms.
TEST(TangentConeGraph, Spirals) {
  Ring spiral;
  for (int i = 0; i <= 90; ++i) spiral.push_back((1.0 + 0.1 * i) * Vec2(std::cos(0.2 * i), std::sin(0.2 * i)));
  for (int i = 90; i >= 0; --i) spiral.push_back((0.8 + 0.1 * i) * Vec2(std::cos(0.2 * i), std::sin(0.2 * i)));
  std::vector<Polygon> obstacles{{spiral, {}}};
  EXPECT_TRUE(agrees(World(obstacles)));
  for (int i = 0; i < 8; ++i)
    obstacles.push_back({round((2.4 + 0.5 * i) * Vec2(std::cos(1.0 * i), std::sin(1.0 * i)), 0.05, 12), {}});
  EXPECT_TRUE(agrees(World(obstacles)));
}

TEST(TangentConeGraph, ThousandsOfPointsInManyTiles) {
  EXPECT_TRUE(
      agrees(random_world({.kind = ClutterKind::kMixed, .obstacles = 500, .vertices = 8, .fill = 0.3, .seed = 4})));
}

// More triangles than one block of flips.
TEST(TangentConeGraph, SixteenThousandVerticesAgainstPairs) {
  const World world =
      random_world({.kind = ClutterKind::kConvex, .obstacles = 1600, .vertices = 10, .fill = 0.3, .seed = 5});
  EXPECT_EQ(build_reduced_visibility_graph_by_tangent_cones(world),
            build_pairwise_visibility_graph(world, *make_embree_queries(world).visibility, SerialExecutor()));
}

TEST(TangentConeGraph, HasTheSameBitsForAnyNumberOfThreads) {
  const World world =
      random_world({.kind = ClutterKind::kStar, .obstacles = 2000, .vertices = 9, .fill = 0.25, .seed = 2});
  TangentConeStatistics serial, parallel;
  const VisibilityGraph graph = build_reduced_visibility_graph_by_tangent_cones(world, SerialExecutor(), &serial);
  for (const std::size_t threads : {1, 2, 7}) {
    EXPECT_EQ(build_reduced_visibility_graph_by_tangent_cones(world, TbbExecutor(threads), &parallel), graph)
        << threads;
    EXPECT_EQ(parallel.steps, serial.steps);
  }
}

// Walks that see far get shorter diagonals than those that do not: the same edges.
TEST(TangentConeGraph, OpenCountryAndLongAisles) {
  EXPECT_TRUE(
      agrees(random_world({.kind = ClutterKind::kConvex, .obstacles = 60, .vertices = 8, .fill = 0.005, .seed = 3})));
  std::vector<Polygon> boxes;
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 40; ++k) boxes.push_back({test::square(2 * k, 3 * i, 1), {}});
  EXPECT_TRUE(agrees(World(boxes)));
}

TEST(TangentConeGraph, NamesItsStagesAndStopsAtEachOfThem) {
  const World world = random_world({.obstacles = 200, .vertices = 6, .fill = 0.2, .seed = 3});
  const std::vector<std::string> all{"sorting", "triangulation", "lines of sight"};
  for (std::size_t end = 0; end < all.size(); ++end) {
    const SerialExecutor serial;
    std::stop_source stop;
    const StoppableExecutor stoppable(serial, stop.get_token());
    std::vector<std::string> stages;
    const ReportingExecutor executor(stoppable, [&](const Progress& progress) {
      if (stages.empty() || stages.back() != progress.stage) stages.emplace_back(progress.stage);
      if (progress.stage == all[end]) stop.request_stop();
    });
    EXPECT_THROW((void)build_reduced_visibility_graph_by_tangent_cones(world, executor), Canceled);
    EXPECT_EQ(stages, std::vector(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(end) + 1));
  }
}

TEST(TangentConeGraph, CountsRegionsThatCross) {
  TangentConeStatistics statistics;
  const auto count = [&](const World& world) {
    build_reduced_visibility_graph_by_tangent_cones(world, SerialExecutor(), &statistics);
    return statistics.invalid_regions;
  };
  EXPECT_EQ(count(World({{test::square(0, 0, 4), {}}, {test::square(4, 1, 2), {}}, {test::square(1, 1, 2), {}}})), 0u);
  EXPECT_EQ(statistics.candidates, 0u);
  EXPECT_GE(count(World({{test::square(0, 0, 4), {}}, {test::square(2, 2, 4), {}}})), 1u);
  EXPECT_GT(statistics.candidates, 0u);
}

}  // namespace
}  // namespace arcway::internal

#include "accel/expansion/sleeves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "accel/expansion/free_space_triangulation.h"
#include "arcway/accel/parallel.h"
#include "arcway/datasets/clutter.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

Ring disc(const Vec2& center, double radius, int vertices) {
  Ring ring;
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.3) / vertices;
    ring.push_back(center + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

World discs(int vertices) {
  std::vector<Polygon> obstacles;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) obstacles.push_back({disc({5.0 * i, 5.0 * k + 0.3 * i}, 2.0, vertices), {}});
  return World(std::move(obstacles));
}

std::uint32_t triangles(const Sleeves::Sleeve& sleeve) { return sleeve.left.count + sleeve.right.count; }

// Checks a sleeve's invariants from half-edge to half-edge.
void expect_sleeve(const FreeSpaceTriangulation& triangulation, const Sleeves& sleeves, std::uint32_t entrance) {
  const Sleeves::Sleeve& sleeve = *sleeves.behind(entrance);
  const auto half_edges = triangulation.half_edges();
  const auto nodes = triangulation.nodes();
  std::uint32_t half_edge = entrance, left = 0, right = 0;
  while (half_edge != sleeve.exit) {
    const FreeSpaceTriangulation::HalfEdge& triangle = half_edges[half_edge];
    ASSERT_NE(triangle.left == kNone, triangle.right == kNone);
    if (triangle.left == kNone) {
      ASSERT_EQ(triangle.node, sleeve.left.first_node + left);
      EXPECT_EQ(sleeves.right_before(sleeve, left), right);
      ++left;
      half_edge = triangle.right;
    } else {
      ASSERT_EQ(triangle.node, sleeve.right.first_node - right);
      EXPECT_EQ(sleeves.left_before(sleeve, right), left);
      ++right;
      half_edge = triangle.left;
    }
    ASSERT_TRUE(nodes[triangle.node].is_simple());
  }
  EXPECT_EQ(left, sleeve.left.count);
  EXPECT_EQ(right, sleeve.right.count);
  // Its chains lead from left to right or from right to left, around one obstacle.
  for (std::uint32_t i = 0; i + 1 < left; ++i) {
    const FreeSpaceTriangulation::Node& n = nodes[sleeve.left.first_node + i];
    EXPECT_EQ(n.after, sleeve.left.first_node + i + 1);
    EXPECT_EQ(n.previous_point < n.point, n.point < n.next_point);
  }
  for (std::uint32_t i = 0; i + 1 < right; ++i) {
    const FreeSpaceTriangulation::Node& n = nodes[sleeve.right.first_node - i];
    EXPECT_EQ(n.before, sleeve.right.first_node - i - 1);
    EXPECT_EQ(n.previous_point < n.point, n.point < n.next_point);
  }
}

std::vector<std::uint32_t> entrances(const FreeSpaceTriangulation& triangulation, const Sleeves& sleeves) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t half_edge = 0; half_edge < triangulation.half_edges().size(); ++half_edge)
    if (sleeves.behind(half_edge)) found.push_back(half_edge);
  return found;
}

TEST(Sleeves, LieBetweenChainsThatFaceEachOther) {
  for (const int vertices : {4, 7, 50, 200}) {
    const FreeSpaceTriangulation triangulation(discs(vertices));
    const Sleeves sleeves(triangulation, 1);
    const std::vector<std::uint32_t> half_edges = entrances(triangulation, sleeves);
    EXPECT_EQ(half_edges.size(), sleeves.size());
    std::uint32_t longest = 0;
    for (const std::uint32_t half_edge : half_edges) {
      expect_sleeve(triangulation, sleeves, half_edge);
      longest = std::max(longest, triangles(*sleeves.behind(half_edge)));
    }
    EXPECT_GE(4 * longest, static_cast<std::uint32_t>(vertices));
  }
}

TEST(Sleeves, PassEachTriangleOnceInEachDirection) {
  const FreeSpaceTriangulation triangulation(
      random_world({.kind = ClutterKind::kMixed, .obstacles = 60, .vertices = 30, .seed = 7}));
  const Sleeves sleeves(triangulation, 1);
  std::vector<std::uint8_t> visits(triangulation.half_edges().size(), 0);
  for (const std::uint32_t entrance : entrances(triangulation, sleeves)) {
    expect_sleeve(triangulation, sleeves, entrance);
    for (std::uint32_t half_edge = entrance; half_edge != sleeves.behind(entrance)->exit;) {
      EXPECT_EQ(visits[half_edge]++, 0);
      half_edge = triangulation.half_edges()[half_edge].left == kNone ? triangulation.half_edges()[half_edge].right
                                                                      : triangulation.half_edges()[half_edge].left;
    }
  }
}

TEST(Sleeves, AreAsLongAsDemanded) {
  const FreeSpaceTriangulation triangulation(discs(60));
  const Sleeves all(triangulation, 1), longer(triangulation, 12);
  EXPECT_LT(longer.size(), all.size());
  EXPECT_GT(longer.size(), 0u);
  for (const std::uint32_t half_edge : entrances(triangulation, longer)) {
    EXPECT_GE(triangles(*longer.behind(half_edge)), 12u);
    ASSERT_NE(all.behind(half_edge), nullptr);
    EXPECT_EQ(all.behind(half_edge)->exit, longer.behind(half_edge)->exit);
  }
}

// A chain that comes nearer up to a node and then recedes, as seen from a point far before it.
TEST(Sleeves, FindTheBoundingNodeOfChainsOfAnyLength) {
  const Vec2 s(0.0, -1e12);
  for (const std::uint32_t count : {1u, 2u, 3u, 100u, 1u << 16, 1u << 17}) {
    for (const double share : {0.0, 0.3, 0.5, 0.7001, 1.0}) {
      const std::uint32_t nearest = static_cast<std::uint32_t>(share * (count - 1));
      const auto at = [&](double i) { return Vec2(-(i - nearest) * (i - nearest) / count, i); };
      std::vector<FreeSpaceTriangulation::Node> nodes(count);
      for (std::uint32_t i = 0; i < count; ++i) {
        nodes[i].previous = at(i - 1.0);
        nodes[i].at = at(i);
        nodes[i].next = at(i + 1.0);
      }
      const Sleeves::Reach reach{0, count};
      const Sleeves::Chain<1> chain(reach, nodes);
      const double sure = std::numeric_limits<double>::infinity();  // nothing is
      const std::uint32_t bounding = chain.bounding_node_from(s, count, 0, count / 2, sure);
      if (nearest == 0) {
        EXPECT_EQ(bounding, 0u);
      } else {
        ASSERT_LT(bounding, count);
        EXPECT_LT(chain.turn(s, nodes[bounding].previous, nodes[bounding].at), 0) << count << " " << bounding;
        EXPECT_TRUE(bounding == count - 1 || chain.turn(s, nodes[bounding].at, nodes[bounding].next) >= 0) << bounding;
      }
      for (const std::uint32_t guess : {0u, nearest / 2, nearest, count - 1})
        EXPECT_EQ(chain.bounding_node_from(s, count, 0, guess, sure), bounding) << count << " from " << guess;
    }
  }
}

// On a round chain, the node that a ray touches follows from the ray's direction.
TEST(Sleeves, GuessWhereRaysTouchRoundChains) {
  const FreeSpaceTriangulation triangulation(discs(200));
  const Sleeves sleeves(triangulation, 20);
  std::size_t guesses = 0;
  const auto expect_guesses = [&](const auto& chain) {
    for (std::uint32_t i = 0; i < chain.count(); ++i, ++guesses) {
      const FreeSpaceTriangulation::Node& n = chain.node(i);
      const Vec2 along = chain.ahead_of(n) - chain.before(n);
      EXPECT_NEAR(chain.guess(along), i, 1.5);
      EXPECT_LT(chain.guess(-along), chain.count());
    }
  };
  for (const std::uint32_t half_edge : entrances(triangulation, sleeves)) {
    expect_guesses(Sleeves::Chain<1>(sleeves.behind(half_edge)->left, triangulation.nodes()));
    expect_guesses(Sleeves::Chain<-1>(sleeves.behind(half_edge)->right, triangulation.nodes()));
  }
  EXPECT_GT(guesses, 1000u);
}

void expect_same_for_threads(const FreeSpaceTriangulation& triangulation) {
  const Sleeves serial(triangulation, 3);
  EXPECT_FALSE(serial.empty());
  for (int repetition = 0; repetition < 3; ++repetition) {
    const Sleeves parallel(triangulation, 3, TbbExecutor(2));
    ASSERT_EQ(entrances(triangulation, parallel), entrances(triangulation, serial));
    for (const std::uint32_t half_edge : entrances(triangulation, serial)) {
      const Sleeves::Sleeve& a = *serial.behind(half_edge);
      const Sleeves::Sleeve& b = *parallel.behind(half_edge);
      EXPECT_EQ(b.exit, a.exit);
      ASSERT_EQ(b.left.count, a.left.count);
      EXPECT_EQ(b.left.nodes_per_quarter, a.left.nodes_per_quarter);
      for (std::uint32_t i = 0; i < a.left.count; ++i)
        ASSERT_EQ(parallel.right_before(b, i), serial.right_before(a, i));
    }
  }
}

TEST(Sleeves, AreTheSameForAnyNumberOfThreads) {
  expect_same_for_threads(FreeSpaceTriangulation(
      random_world({.kind = ClutterKind::kConvex, .obstacles = 300, .vertices = 120, .seed = 5})));
}

// Triangles that follow each other all around a ring, many times as many as a thread handles at once.
TEST(Sleeves, AreFoundInRings) {
  const int vertices = 30000;
  Ring outside = disc({0.0, 0.0}, 3.0, 7), hole = disc({0.0, 0.0}, 2.1, vertices);
  std::reverse(hole.begin(), hole.end());
  const FreeSpaceTriangulation triangulation(World({{outside, {hole}}, {disc({0.0, 0.0}, 2.0, vertices), {}}}));
  const Sleeves sleeves(triangulation, 1);
  for (const std::uint32_t half_edge : entrances(triangulation, sleeves))
    expect_sleeve(triangulation, sleeves, half_edge);
  expect_same_for_threads(triangulation);
}

TEST(Sleeves, AreFoundBetweenLongConvexChainsOnly) {
  const auto count = [](const World& world) { return worthwhile_sleeves(world, FreeSpaceTriangulation(world)).size(); };
  EXPECT_GT(count(discs(200)), 0u);
  EXPECT_EQ(count(discs(30)), 0u);
  EXPECT_EQ(count(random_world({.kind = ClutterKind::kStar, .obstacles = 9, .vertices = 200, .seed = 1})), 0u);
  EXPECT_EQ(count(World({})), 0u);
}

}  // namespace
}  // namespace arcway::internal

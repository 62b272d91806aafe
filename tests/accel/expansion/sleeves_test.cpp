#include "accel/expansion/sleeves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "accel/expansion/sight_map.h"
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

// What a sleeve promises, from door to door.
void expect_sleeve(const SightMap& map, const Sleeves& sleeves, std::uint32_t entrance) {
  const Sleeves::Sleeve& sleeve = *sleeves.behind(entrance);
  const auto doors = map.doors();
  const auto nodes = map.nodes();
  std::uint32_t door = entrance, left = 0, right = 0;
  while (door != sleeve.exit) {
    const SightMap::Door& triangle = doors[door];
    ASSERT_NE(triangle.left == kNone, triangle.right == kNone);
    if (triangle.left == kNone) {
      ASSERT_EQ(triangle.node, sleeve.left.first_node + left);
      EXPECT_EQ(sleeves.right_before(sleeve, left), right);
      ++left;
      door = triangle.right;
    } else {
      ASSERT_EQ(triangle.node, sleeve.right.first_node - right);
      EXPECT_EQ(sleeves.left_before(sleeve, right), left);
      ++right;
      door = triangle.left;
    }
    ASSERT_TRUE(nodes[triangle.node].is_plain());
  }
  EXPECT_EQ(left, sleeve.left.count);
  EXPECT_EQ(right, sleeve.right.count);
  // From left to right or from right to left, around one obstacle.
  for (std::uint32_t i = 0; i + 1 < left; ++i) {
    const SightMap::Node& n = nodes[sleeve.left.first_node + i];
    EXPECT_EQ(n.after, sleeve.left.first_node + i + 1);
    EXPECT_EQ(n.previous_site < n.site, n.site < n.next_site);
  }
  for (std::uint32_t i = 0; i + 1 < right; ++i) {
    const SightMap::Node& n = nodes[sleeve.right.first_node - i];
    EXPECT_EQ(n.before, sleeve.right.first_node - i - 1);
    EXPECT_EQ(n.previous_site < n.site, n.site < n.next_site);
  }
}

std::vector<std::uint32_t> entrances(const SightMap& map, const Sleeves& sleeves) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t door = 0; door < map.doors().size(); ++door)
    if (sleeves.behind(door)) found.push_back(door);
  return found;
}

TEST(Sleeves, LieBetweenWallsThatFaceEachOther) {
  for (const int vertices : {4, 7, 50, 200}) {
    const SightMap map(discs(vertices));
    const Sleeves sleeves(map, 1);
    const std::vector<std::uint32_t> doors = entrances(map, sleeves);
    EXPECT_EQ(doors.size(), sleeves.size());
    std::uint32_t longest = 0;
    for (const std::uint32_t door : doors) {
      expect_sleeve(map, sleeves, door);
      longest = std::max(longest, triangles(*sleeves.behind(door)));
    }
    EXPECT_GE(4 * longest, static_cast<std::uint32_t>(vertices));
  }
}

TEST(Sleeves, PassEachTriangleOnceInEachDirection) {
  const SightMap map(random_world({.kind = ClutterKind::kMixed, .obstacles = 60, .vertices = 30, .seed = 7}));
  const Sleeves sleeves(map, 1);
  std::vector<std::uint8_t> visits(map.doors().size(), 0);
  for (const std::uint32_t entrance : entrances(map, sleeves)) {
    expect_sleeve(map, sleeves, entrance);
    for (std::uint32_t door = entrance; door != sleeves.behind(entrance)->exit;) {
      EXPECT_EQ(visits[door]++, 0);
      door = map.doors()[door].left == kNone ? map.doors()[door].right : map.doors()[door].left;
    }
  }
}

TEST(Sleeves, AreAsLongAsDemanded) {
  const SightMap map(discs(60));
  const Sleeves all(map, 1), longer(map, 12);
  EXPECT_LT(longer.size(), all.size());
  EXPECT_GT(longer.size(), 0u);
  for (const std::uint32_t door : entrances(map, longer)) {
    EXPECT_GE(triangles(*longer.behind(door)), 12u);
    ASSERT_NE(all.behind(door), nullptr);
    EXPECT_EQ(all.behind(door)->exit, longer.behind(door)->exit);
  }
}

// A wall that comes nearer up to a node and then recedes, as a point far before it sees it.
TEST(Sleeves, FindWhatLimitsSightsOnWallsOfAnyLength) {
  const Vec2 s(0.0, -1e12);
  for (const std::uint32_t count : {1u, 2u, 3u, 100u, 1u << 16, 1u << 17}) {
    for (const double share : {0.0, 0.3, 0.5, 0.7001, 1.0}) {
      const std::uint32_t nearest = static_cast<std::uint32_t>(share * (count - 1));
      const auto at = [&](double i) { return Vec2(-(i - nearest) * (i - nearest) / count, i); };
      std::vector<SightMap::Node> nodes(count);
      for (std::uint32_t i = 0; i < count; ++i) {
        nodes[i].previous = at(i - 1.0);
        nodes[i].at = at(i);
        nodes[i].next = at(i + 1.0);
      }
      const Sleeves::Reach reach{0, count};
      const Sleeves::Wall<1> wall(reach, nodes);
      const double sure = std::numeric_limits<double>::infinity();  // nothing is
      const std::uint32_t limit = wall.limit_from(s, count, 0, count / 2, sure);
      if (nearest == 0) {
        EXPECT_EQ(limit, 0u);
      } else {
        ASSERT_LT(limit, count);
        EXPECT_LT(wall.turn(s, nodes[limit].previous, nodes[limit].at), 0) << count << " " << limit;
        EXPECT_TRUE(limit == count - 1 || wall.turn(s, nodes[limit].at, nodes[limit].next) >= 0) << limit;
      }
      for (const std::uint32_t guess : {0u, nearest / 2, nearest, count - 1})
        EXPECT_EQ(wall.limit_from(s, count, 0, guess, sure), limit) << count << " from " << guess;
    }
  }
}

// On a round wall the node that a ray touches follows from the ray's direction.
TEST(Sleeves, GuessWhereRaysTouchRoundWalls) {
  const SightMap map(discs(200));
  const Sleeves sleeves(map, 20);
  std::size_t guesses = 0;
  const auto expect_guesses = [&](const auto& wall) {
    for (std::uint32_t i = 0; i < wall.count(); ++i, ++guesses) {
      const SightMap::Node& n = wall.node(i);
      const Vec2 along = wall.ahead_of(n) - wall.before(n);
      EXPECT_NEAR(wall.guess(along), i, 1.5);
      EXPECT_LT(wall.guess(-along), wall.count());
    }
  };
  for (const std::uint32_t door : entrances(map, sleeves)) {
    expect_guesses(Sleeves::Wall<1>(sleeves.behind(door)->left, map.nodes()));
    expect_guesses(Sleeves::Wall<-1>(sleeves.behind(door)->right, map.nodes()));
  }
  EXPECT_GT(guesses, 1000u);
}

void expect_same_for_threads(const SightMap& map) {
  const Sleeves serial(map, 3);
  EXPECT_FALSE(serial.empty());
  for (int repetition = 0; repetition < 3; ++repetition) {
    const Sleeves parallel(map, 3, TbbExecutor(2));
    ASSERT_EQ(entrances(map, parallel), entrances(map, serial));
    for (const std::uint32_t door : entrances(map, serial)) {
      const Sleeves::Sleeve& a = *serial.behind(door);
      const Sleeves::Sleeve& b = *parallel.behind(door);
      EXPECT_EQ(b.exit, a.exit);
      ASSERT_EQ(b.left.count, a.left.count);
      EXPECT_EQ(b.left.nodes_per_quarter, a.left.nodes_per_quarter);
      for (std::uint32_t i = 0; i < a.left.count; ++i)
        ASSERT_EQ(parallel.right_before(b, i), serial.right_before(a, i));
    }
  }
}

TEST(Sleeves, AreTheSameForAnyNumberOfThreads) {
  expect_same_for_threads(
      SightMap(random_world({.kind = ClutterKind::kConvex, .obstacles = 300, .vertices = 120, .seed = 5})));
}

// Triangles that follow each other all around, many times as many as a thread looks at.
TEST(Sleeves, AreFoundInRings) {
  const int vertices = 30000;
  Ring outside = disc({0.0, 0.0}, 3.0, 7), hole = disc({0.0, 0.0}, 2.1, vertices);
  std::reverse(hole.begin(), hole.end());
  const SightMap map(World({{outside, {hole}}, {disc({0.0, 0.0}, 2.0, vertices), {}}}));
  const Sleeves sleeves(map, 1);
  for (const std::uint32_t door : entrances(map, sleeves)) expect_sleeve(map, sleeves, door);
  expect_same_for_threads(map);
}

TEST(Sleeves, AreLookedForBetweenLongConvexWallsOnly) {
  const auto count = [](const World& world) { return worthwhile_sleeves(world, SightMap(world)).size(); };
  EXPECT_GT(count(discs(200)), 0u);
  EXPECT_EQ(count(discs(30)), 0u);
  EXPECT_EQ(count(random_world({.kind = ClutterKind::kStar, .obstacles = 9, .vertices = 200, .seed = 1})), 0u);
  EXPECT_EQ(count(World({})), 0u);
}

}  // namespace
}  // namespace arcway::internal

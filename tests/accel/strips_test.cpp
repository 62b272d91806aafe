#include "accel/wedge/strips.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "accel/parallel.h"
#include "accel/wedge/sight_map.h"
#include "datasets/clutter.h"
#include "tests/support/random_inputs.h"

namespace arcway {
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

std::uint32_t triangles(const Strips::Strip& strip) { return strip.left_count + strip.right_count; }

// What a strip promises, from door to door.
void expect_strip(const SightMap& map, const Strips& strips, std::uint32_t entrance) {
  const Strips::Strip& strip = *strips.behind(entrance);
  const auto doors = map.doors();
  const auto nodes = map.nodes();
  std::uint32_t door = entrance, left = 0, right = 0;
  while (door != strip.exit) {
    const SightMap::Door& triangle = doors[door];
    ASSERT_NE(triangle.left == kNone, triangle.right == kNone);
    if (triangle.left == kNone) {
      ASSERT_EQ(triangle.node, strip.first_left + left);
      EXPECT_EQ(strips.right_before(strip, left), right);
      ++left;
      door = triangle.right;
    } else {
      ASSERT_EQ(triangle.node, strip.first_right - right);
      EXPECT_EQ(strips.left_before(strip, right), left);
      ++right;
      door = triangle.left;
    }
    ASSERT_TRUE(nodes[triangle.node].is_plain());
  }
  EXPECT_EQ(left, strip.left_count);
  EXPECT_EQ(right, strip.right_count);
  // From left to right or from right to left, around one obstacle.
  for (std::uint32_t i = 0; i + 1 < left; ++i) {
    const SightMap::Node& n = nodes[strip.first_left + i];
    EXPECT_EQ(n.after, strip.first_left + i + 1);
    EXPECT_EQ(n.previous_site < n.site, n.site < n.next_site);
  }
  for (std::uint32_t i = 0; i + 1 < right; ++i) {
    const SightMap::Node& n = nodes[strip.first_right - i];
    EXPECT_EQ(n.before, strip.first_right - i - 1);
    EXPECT_EQ(n.previous_site < n.site, n.site < n.next_site);
  }
}

std::vector<std::uint32_t> entrances(const SightMap& map, const Strips& strips) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t door = 0; door < map.doors().size(); ++door)
    if (strips.behind(door)) found.push_back(door);
  return found;
}

TEST(Strips, LieBetweenWallsThatFaceEachOther) {
  for (const int vertices : {4, 7, 50, 200}) {
    const SightMap map(discs(vertices));
    const Strips strips(map, 1);
    const std::vector<std::uint32_t> doors = entrances(map, strips);
    EXPECT_EQ(doors.size(), strips.size());
    std::uint32_t longest = 0;
    for (const std::uint32_t door : doors) {
      expect_strip(map, strips, door);
      longest = std::max(longest, triangles(*strips.behind(door)));
    }
    EXPECT_GE(4 * longest, static_cast<std::uint32_t>(vertices));
  }
}

TEST(Strips, PassEachTriangleOnceInEachDirection) {
  const SightMap map(random_world({.kind = ClutterKind::kMixed, .obstacles = 60, .vertices = 30, .seed = 7}));
  const Strips strips(map, 1);
  std::vector<std::uint8_t> visits(map.doors().size(), 0);
  for (const std::uint32_t entrance : entrances(map, strips)) {
    expect_strip(map, strips, entrance);
    for (std::uint32_t door = entrance; door != strips.behind(entrance)->exit;) {
      EXPECT_EQ(visits[door]++, 0);
      door = map.doors()[door].left == kNone ? map.doors()[door].right : map.doors()[door].left;
    }
  }
}

TEST(Strips, AreAsLongAsDemanded) {
  const SightMap map(discs(60));
  const Strips all(map, 1), longer(map, 12);
  EXPECT_LT(longer.size(), all.size());
  EXPECT_GT(longer.size(), 0u);
  for (const std::uint32_t door : entrances(map, longer)) {
    EXPECT_GE(triangles(*longer.behind(door)), 12u);
    ASSERT_NE(all.behind(door), nullptr);
    EXPECT_EQ(all.behind(door)->exit, longer.behind(door)->exit);
  }
}

// A wall that comes nearer up to a node and then recedes, as a point far before it sees it.
TEST(Strips, FindWhatLimitsSightsOnWallsOfAnyLength) {
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
      const Strips::Wall wall{nodes.data(), 1, count};
      const std::uint32_t limit = wall.limit_from(s, count, 0);
      if (nearest == 0) {
        EXPECT_EQ(limit, 0u);
      } else {
        ASSERT_LT(limit, count);
        EXPECT_LT(wall.turn(s, nodes[limit].previous, nodes[limit].at), 0) << count << " " << limit;
        EXPECT_TRUE(limit == count - 1 || wall.turn(s, nodes[limit].at, nodes[limit].next) >= 0) << limit;
      }
      for (const std::uint32_t guess : {0u, nearest / 2, nearest, count - 1})
        EXPECT_EQ(wall.limit_from(s, count, 0, guess), limit) << count << " from " << guess;
    }
  }
}

TEST(Strips, AreTheSameForAnyNumberOfThreads) {
  const SightMap map(random_world({.kind = ClutterKind::kConvex, .obstacles = 300, .vertices = 120, .seed = 5}));
  const Strips serial(map, 3), parallel(map, 3, TbbExecutor(2));
  ASSERT_EQ(parallel.size(), serial.size());
  for (const std::uint32_t door : entrances(map, serial)) {
    const Strips::Strip* const a = serial.behind(door);
    const Strips::Strip* const b = parallel.behind(door);
    ASSERT_NE(b, nullptr);
    EXPECT_EQ(b->exit, a->exit);
    EXPECT_EQ(b->left_count, a->left_count);
    for (std::uint32_t i = 0; i < a->left_count; ++i)
      ASSERT_EQ(parallel.right_before(*b, i), serial.right_before(*a, i));
  }
}

TEST(Strips, AreLookedForBetweenLongConvexWallsOnly) {
  const auto count = [](const World& world) { return worthwhile_strips(world, SightMap(world)).size(); };
  EXPECT_GT(count(discs(200)), 0u);
  EXPECT_EQ(count(discs(40)), 0u);
  EXPECT_EQ(count(random_world({.kind = ClutterKind::kStar, .obstacles = 9, .vertices = 200, .seed = 1})), 0u);
  EXPECT_EQ(count(World({})), 0u);
}

}  // namespace
}  // namespace arcway

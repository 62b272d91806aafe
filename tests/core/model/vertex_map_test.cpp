#include "core/model/vertex_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "arcway/datasets/map_file.h"
#include "tests/support/nasty_worlds.h"

namespace arcway::internal {
namespace {

// The vertex after a change, by the keys of obstacles.
VertexId vertex_after(VertexId v, const World& before, const World& after) {
  const ObstacleId o = before.obstacle_of(v);
  const bool is_bounds = o == before.obstacle_count();
  const ObstacleId now =
      is_bounds ? static_cast<ObstacleId>(after.obstacle_count()) : after.obstacle_with(before.key_of(o));
  return now == kNone ? kNone : v - before.vertices_of(o).first + after.vertices_of(now).first;
}

// The vertices by the whole table of a change, and after several.
TEST(VertexMap, IsTheTableOfAllVertices) {
  std::size_t removed_vertices = 0, later_removals = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    test::RandomInputs random(seed);
    World world = test::nasty_world(seed, 12);
    std::vector<VertexId> expected(world.vertices().size());  // by vertex of the first world
    for (VertexId v = 0; v < expected.size(); ++v) expected[v] = v;
    std::optional<VertexMap> all;
    for (int step = 0; step < 5; ++step) {
      std::vector<ObstacleId> removed;
      for (ObstacleId o = 0; o < world.obstacle_count(); ++o)
        if (random.integer(0, 3) == 0) removed.push_back(o);
      const World after = world.changed(removed, to_map_file(test::nasty_world(random.bits(), 3)).obstacles);
      const VertexMap map(WorldChange::unchecked(world, after, removed));
      for (VertexId v = 0; v < world.vertices().size(); ++v) {
        ASSERT_EQ(map.after(v), vertex_after(v, world, after));
        if (map.after(v) != kNone) {
          ASSERT_EQ(map.before(map.after(v)), v);
        }
      }
      for (VertexId& v : expected)
        if (v != kNone) v = vertex_after(v, world, after);
      if (all) later_removals += map.removed().size();
      all = all ? all->then(map) : map;
      std::vector<VertexId> before(after.vertices().size(), kNone);
      for (VertexId v = 0; v < expected.size(); ++v) {
        ASSERT_EQ(all->after(v), expected[v]);
        if (expected[v] != kNone) before[expected[v]] = v;
        removed_vertices += expected[v] == kNone ? 1 : 0;
      }
      for (VertexId v = 0; v < before.size(); ++v) {
        ASSERT_EQ(all->before(v), before[v]);
        ASSERT_EQ(all->is_added(v), before[v] == kNone);
      }
      world = after;
    }
  }
  EXPECT_GT(removed_vertices, 100u);
  EXPECT_GT(later_removals, 100u);
}

// Two worlds that came from one by changes: up to which vertex they are the same.
TEST(VertexMap, KnowsTheFirstVerticesThatTwoHaveInCommon) {
  std::size_t differ_early = 0, common_vertices = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    test::RandomInputs random(seed);
    const World world = test::nasty_world(seed, 12);
    const auto change = [&](const World& from) {
      std::vector<ObstacleId> removed;
      for (ObstacleId o = 0; o < from.obstacle_count(); ++o)
        if (random.integer(0, 9) == 0) removed.push_back(o);
      const World after = from.changed(removed, to_map_file(test::nasty_world(random.bits(), 3)).obstacles);
      return std::pair(after, VertexMap(WorldChange(from, after, removed)));
    };
    const auto [a, to_a] = change(world);
    const auto [later, a_to_later] = change(a);
    const VertexMap to_later = to_a.then(a_to_later);
    const VertexId common = to_a.common_with(to_later);
    EXPECT_EQ(to_later.common_with(to_a), common);
    EXPECT_EQ(to_a.common_with(to_a), to_a.added().first);
    for (VertexId v = 0; v < common; ++v) {
      ASSERT_EQ(to_a.before(v), to_later.before(v));
      ASSERT_NE(to_a.before(v), kNone);
    }
    common_vertices += common;
    const VertexId most = std::min(to_a.added().first, to_later.added().first);
    if (common < most) {
      ++differ_early;
      EXPECT_NE(to_a.before(common), to_later.before(common)) << "and no further";
    }
  }
  EXPECT_GT(differ_early, 10u);
  EXPECT_GT(common_vertices, 500u);
}

}  // namespace
}  // namespace arcway::internal

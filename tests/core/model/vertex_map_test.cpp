#include "core/model/vertex_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "arcway/datasets/map_file.h"
#include "tests/support/known_obstacles.h"
#include "tests/support/nasty_worlds.h"

namespace arcway::internal {
namespace {

// A world and which obstacles these are.
struct MappedWorld {
  explicit MappedWorld(const World& the_world) : world(the_world), obstacles(to_map_file(world).obstacles) {}
  void change(std::span<const ObstacleId> removed, const std::vector<Polygon>& added) {
    world = world.changed(removed, added);
    obstacles.change(removed, added);
  }

  World world;
  test::KnownObstacles obstacles;
};

// The vertex after a change.
VertexId vertex_after(VertexId v, const MappedWorld& before, const MappedWorld& after) {
  const ObstacleId o = before.world.obstacle_of(v);
  const bool is_bounds = o == before.world.obstacle_count();
  const ObstacleId now = is_bounds ? static_cast<ObstacleId>(after.world.obstacle_count())
                                   : after.obstacles.id_of(before.obstacles.all()[o].birth);
  return now == kNone ? kNone : v - before.world.vertices_of(o).first + after.world.vertices_of(now).first;
}

// The vertices by the whole table of a change, and after several.
TEST(VertexMap, IsTheTableOfAllVertices) {
  std::size_t removed_vertices = 0, later_removals = 0, in_place = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    test::RandomInputs random(seed);
    MappedWorld known(test::nasty_world(seed, 12));
    std::vector<VertexId> expected(known.world.vertices().size());  // by vertex of the first world
    for (VertexId v = 0; v < expected.size(); ++v) expected[v] = v;
    std::optional<VertexMap> all;
    for (int step = 0; step < 5; ++step) {
      const std::vector<ObstacleId> removed = test::draw_obstacles(known.world, 4, random);
      MappedWorld after = known;
      after.change(removed, to_map_file(test::nasty_world(random.bits(), 3)).obstacles);
      const VertexMap map(WorldChange::unchecked(known.world, after.world, removed));
      for (VertexId v = 0; v < known.world.vertices().size(); ++v) {
        ASSERT_EQ(map.after(v), vertex_after(v, known, after));
        if (map.after(v) != kNone) {
          ASSERT_EQ(map.before(map.after(v)), v);
        }
      }
      for (VertexId& v : expected)
        if (v != kNone) v = vertex_after(v, known, after);
      if (all) later_removals += map.removed().size();
      all = all ? all->then(map) : map;
      std::vector<VertexId> before(after.world.vertices().size(), kNone);
      for (VertexId v = 0; v < expected.size(); ++v) {
        ASSERT_EQ(all->after(v), expected[v]);
        if (expected[v] != kNone) before[expected[v]] = v;
        removed_vertices += expected[v] == kNone ? 1 : 0;
      }
      for (VertexId v = 0; v < before.size(); ++v) {
        ASSERT_EQ(all->before(v), before[v]);
        ASSERT_EQ(all->is_added(v), before[v] == kNone);
      }
      for (const World::VertexRange& range : map.added())
        in_place += range.last < after.world.vertices().size() && map.before(range.last) != kNone &&
                            map.before(range.last) == range.last
                        ? 1
                        : 0;
      known = after;
    }
  }
  EXPECT_GT(removed_vertices, 100u);
  EXPECT_GT(later_removals, 100u);
  EXPECT_GT(in_place, 50u);
}

// The ranges of a map, in order, and each vertex in one of them.
TEST(VertexMap, VisitsRangesThatAreKeptAndAdded) {
  const VertexMap map({{0, 4}, {10, 14}, {20, 25}}, {{0, 4}, {6, 9}, {30, 34}});
  std::string visited;
  const auto append = [&](const char* what, const World::VertexRange& range) {
    visited += what + std::to_string(range.first) + "-" + std::to_string(range.last) + " ";
  };
  map.visit(
      40,
      [&](const World::VertexRange& range, VertexId before) {
        append("", range);
        for (VertexId v = range.first; v < range.last; ++v) EXPECT_EQ(map.before(v), before + (v - range.first));
      },
      [&](const World::VertexRange& range) { append("+", range); });
  EXPECT_EQ(visited, "+0-4 4-6 +6-9 9-13 13-19 19-30 +30-34 34-40 ");
}

// Two worlds that came from one by changes: up to which vertex those that both have from there are the same.
TEST(VertexMap, KnowsUpToWhereTwoAreAligned) {
  std::size_t differ_early = 0, aligned_vertices = 0, all_aligned = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    test::RandomInputs random(seed);
    const World world = test::nasty_world(seed, 12);
    const auto change = [&](const World& from) {
      const std::vector<ObstacleId> removed = test::draw_obstacles(from, 10, random);
      std::vector<Polygon> added;
      if (seed % 2 == 0)
        added = to_map_file(test::nasty_world(random.bits(), 3)).obstacles;
      else
        for (const ObstacleId o : removed) added.push_back(from.polygon_of(o));
      const World after = from.changed(removed, added);
      return std::pair(after, VertexMap(WorldChange(from, after, removed)));
    };
    const auto [a, to_a] = change(world);
    const auto [later, a_to_later] = change(a);
    const VertexMap to_later = to_a.then(a_to_later);
    const VertexId aligned = to_a.aligned_with(to_later);
    EXPECT_EQ(to_later.aligned_with(to_a), aligned);
    EXPECT_EQ(to_a.aligned_with(to_a), kNone);
    const auto both = static_cast<VertexId>(std::min(a.vertices().size(), later.vertices().size()));
    const auto are_there = [&one = to_a, &other = to_later](VertexId v) {
      return one.before(v) != kNone && other.before(v) != kNone;
    };
    for (VertexId v = 0; v < std::min(aligned, both); ++v) {
      if (!are_there(v)) continue;
      ASSERT_EQ(to_a.before(v), to_later.before(v));
      ++aligned_vertices;
    }
    all_aligned += aligned == kNone ? 1 : 0;
    if (aligned < both) {
      ++differ_early;
      EXPECT_TRUE(are_there(aligned));
      EXPECT_NE(to_a.before(aligned), to_later.before(aligned)) << "and no further";
    }
  }
  EXPECT_GT(differ_early, 20u);
  EXPECT_GT(all_aligned, 80u);
  EXPECT_GT(aligned_vertices, 2000u);
}

}  // namespace
}  // namespace arcway::internal

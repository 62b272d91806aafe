#include "core/model/vertex_map.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "arcway/datasets/map_file.h"
#include "tests/support/nasty_worlds.h"

namespace arcway::internal {
namespace {

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
      const WorldChange change(world, after, removed);
      const VertexMap map(change);
      for (VertexId v = 0; v < world.vertices().size(); ++v) {
        ASSERT_EQ(map.after(v), change.vertex_after[v]);
        if (map.after(v) != kNone) {
          ASSERT_EQ(map.before(map.after(v)), v);
        }
      }
      for (VertexId& v : expected)
        if (v != kNone) v = change.vertex_after[v];
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

}  // namespace
}  // namespace arcway::internal

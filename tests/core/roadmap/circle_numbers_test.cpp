#include "core/roadmap/circle_numbers.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "arcway/datasets/map_file.h"
#include "tests/support/nasty_worlds.h"

namespace arcway::internal {
namespace {

// Of worlds after changes, by the origin's list and without it, covered or not.
TEST(ConvexVertices, AreThoseOfTheWorld) {
  std::size_t changed = 0, covered = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    test::RandomInputs random(seed);
    World world = test::nasty_world(seed, 12);
    for (int step = 0; step < 5; ++step) {
      for (const auto& of_origin : {world.history().convex_of_origin(), {}}) {
        const ConvexVertices listed(world, of_origin);
        std::size_t index = 0;
        for (VertexId v = 0; v < world.vertices().size(); ++v) {
          covered += world.is_covered(v) ? 1 : 0;
          if (!world.is_convex(v)) {
            EXPECT_EQ(listed.index_of(v), listed.size());
            continue;
          }
          EXPECT_EQ(listed.index_of(v), index);
          EXPECT_EQ(listed[index++], v);
        }
        EXPECT_EQ(index, listed.size());
        changed += of_origin ? 1 : 0;
      }
      const std::vector<ObstacleId> removed = test::draw_obstacles(world, 6, random);
      world = world.changed(removed, to_map_file(test::nasty_world(random.bits(), 2)).obstacles);
    }
  }
  EXPECT_GT(changed, 200u);
  EXPECT_GT(covered, 200u);
}

}  // namespace
}  // namespace arcway::internal

#include "core/model/world_history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "arcway/datasets/map_file.h"
#include "tests/support/nasty_worlds.h"

namespace arcway::internal {
namespace {

std::vector<ObstacleId> draw_obstacles(const World& world, test::RandomInputs& random) {
  std::vector<ObstacleId> drawn;
  for (ObstacleId o = 0; o < world.obstacle_count(); ++o)
    if (random.integer(0, 5) == 0) drawn.push_back(o);
  return drawn;
}

// How many first vertices are equal, with their edges.
VertexId count_equal(const World& a, const World& b) {
  const auto count = static_cast<VertexId>(std::min(a.vertices().size(), b.vertices().size()));
  VertexId v = 0;
  while (v < count && a.vertex(v) == b.vertex(v) && a.next(v) == b.next(v) && a.previous(v) == b.previous(v)) ++v;
  return v;
}

// Worlds that come from one by changes, each from any before it, so that obstacles cover vertices here and not there.
TEST(WorldHistory, TellsWhatWorldsOfOneOriginHaveInCommon) {
  std::size_t some_in_common = 0, flipped = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    test::RandomInputs random(seed);
    std::vector<World> worlds{test::nasty_world(seed, 12)};
    for (int step = 0; step < 8; ++step) {
      const World& before = worlds[static_cast<std::size_t>(random.integer(0, step))];
      worlds.push_back(
          before.changed(draw_obstacles(before, random), to_map_file(test::nasty_world(random.bits(), 2)).obstacles));
    }
    for (const World& a : worlds)
      for (const World& b : worlds) {
        const VertexId common = a.history().common_with(b.history());
        ASSERT_LE(common, count_equal(a, b));
        EXPECT_EQ(common, b.history().common_with(a.history()));
        some_in_common += common > 0 ? 1 : 0;
        const std::vector<VertexId> differing = a.history().flipped_from(b.history());
        ASSERT_TRUE(std::ranges::is_sorted(differing));
        for (VertexId v = 0; v < common; ++v)
          ASSERT_EQ(std::ranges::binary_search(differing, v), a.is_covered(v) != b.is_covered(v));
        flipped += differing.size();
      }
    for (const World& world : worlds) {
      const auto bounds = world.has_bounds() ? world.vertices_of(static_cast<ObstacleId>(world.obstacle_count())).first
                                             : static_cast<VertexId>(world.vertices().size());
      EXPECT_EQ(world.history().common_with(world.history()), std::min(bounds, world.history().map().added().first));
    }
  }
  EXPECT_GT(some_in_common, 100u);
  EXPECT_GT(flipped, 500u);
}

TEST(WorldHistory, HasNothingInCommonWithThatOfAnotherOrigin) {
  const World world = test::nasty_world(3, 12), same = test::nasty_world(3, 12);
  ASSERT_EQ(count_equal(world, same), world.vertices().size());
  EXPECT_EQ(world.history().common_with(same.history()), 0u);
  EXPECT_TRUE(world.history().flipped_from(same.history()).empty());
  EXPECT_FALSE(world.history().has_origin_of(same.history()));
  EXPECT_TRUE(world.history().has_origin_of(world.changed({}, {}).history()));
  EXPECT_FALSE(WorldHistory().has_origin_of(WorldHistory()));
}

}  // namespace
}  // namespace arcway::internal

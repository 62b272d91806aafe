#include "core/model/world_history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "arcway/datasets/map_file.h"
#include "tests/support/nasty_worlds.h"

namespace arcway::internal {
namespace {

bool are_equal(const World& a, const World& b, VertexId v) {
  return a.vertex(v) == b.vertex(v) && a.next(v) == b.next(v) && a.previous(v) == b.previous(v);
}

bool is_in(const std::vector<World::VertexRange>& ranges, VertexId v) {
  return std::ranges::any_of(ranges, [v](const auto& range) { return range.first <= v && v < range.last; });
}

// Worlds that come from one by changes, each from any before it, so that obstacles cover vertices here and not there.
TEST(WorldHistory, TellsWhatWorldsOfOneOriginHaveInCommon) {
  std::size_t in_common = 0, flipped = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    test::RandomInputs random(seed);
    std::vector<World> worlds{test::nasty_world(seed, 12)};
    for (int step = 0; step < 8; ++step) {
      const World& before = worlds[static_cast<std::size_t>(random.integer(0, step))];
      worlds.push_back(before.changed(test::draw_obstacles(before, 6, random),
                                      to_map_file(test::nasty_world(random.bits(), 2)).obstacles));
    }
    for (const World& a : worlds)
      for (const World& b : worlds) {
        const VertexId aligned = a.history().aligned_with(b.history());
        EXPECT_EQ(aligned, b.history().aligned_with(a.history()));
        const std::vector<World::VertexRange> added = a.history().map().added_in_either(b.history().map());
        const std::vector<VertexId> differing = a.history().flipped_from(b.history());
        ASSERT_TRUE(std::ranges::is_sorted(differing));
        for (VertexId v = 0; v < std::min<std::size_t>({aligned, a.vertices().size(), b.vertices().size()}); ++v) {
          if (is_in(added, v)) continue;
          ASSERT_TRUE(are_equal(a, b, v));
          ASSERT_EQ(std::ranges::binary_search(differing, v), a.is_covered(v) != b.is_covered(v));
          ++in_common;
        }
        flipped += differing.size();
      }
    for (const World& world : worlds) {
      EXPECT_EQ(world.history().aligned_with(world.history()), kNone);
      EXPECT_EQ(world.graph_vertex_count(), world.convex_vertices().size());
    }
  }
  EXPECT_GT(in_common, 5000u);
  EXPECT_GT(flipped, 500u);
}

TEST(WorldHistory, HasNothingInCommonWithThatOfAnotherOrigin) {
  const World world = test::nasty_world(3, 12), same = test::nasty_world(3, 12);
  for (VertexId v = 0; v < world.vertices().size(); ++v) ASSERT_TRUE(are_equal(world, same, v));
  EXPECT_EQ(world.history().aligned_with(same.history()), 0u);
  EXPECT_TRUE(world.history().flipped_from(same.history()).empty());
  EXPECT_FALSE(world.history().has_origin_of(same.history()));
  const World changed = world.changed({}, {}), again = changed.changed({}, {});
  EXPECT_TRUE(world.history().has_origin_of(changed.history()));
  EXPECT_TRUE(changed.history().follows_at_once(world.history()));
  EXPECT_TRUE(again.history().follows_at_once(changed.history()));
  EXPECT_FALSE(again.history().follows_at_once(world.history()));
  EXPECT_FALSE(world.history().follows_at_once(world.history()));
  EXPECT_FALSE(WorldHistory().has_origin_of(WorldHistory()));
}

}  // namespace
}  // namespace arcway::internal

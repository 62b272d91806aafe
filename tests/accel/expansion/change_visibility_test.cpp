#include "accel/expansion/change_visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "accel/graphs/lazy_rows.h"
#include "arcway/datasets/catalog.h"
#include "arcway/world_change.h"
#include "core/model/vertex_map.h"
#include "tests/support/nasty_worlds.h"
#include "tests/support/opened_triangles.h"

namespace arcway::internal {
namespace {

// Opens every third obstacle and returns them; nothing if one is refused.
std::optional<std::vector<ObstacleId>> open_some(test::OpenedTriangles& t) {
  std::vector<ObstacleId> opened;
  for (ObstacleId o = 0; o < t.world.obstacle_count(); o += 3) {
    if (!t.opened.open(t.world, o)) return std::nullopt;
    opened.push_back(o);
  }
  return opened;
}

// The neighbors of each vertex in the world without opened obstacles are marked as those that see it.
TEST(ChangeVisibility, MissesNoNeighborPastOpenedObstacles) {
  std::size_t worlds = 0, neighbors = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    test::OpenedTriangles t(test::nasty_world(seed, 12));
    if (!t.world.self_contacts().empty()) continue;
    const auto opened = open_some(t);
    if (!opened) continue;
    ++worlds;
    const World after = t.world.changed(*opened, {});
    const VertexMap map(WorldChange(t.world, after, *opened));
    const auto rows = make_lazy_rows(after);
    for (std::uint32_t n = 0; n < t.triangulation.nodes().size(); ++n) {
      const FreeSpaceTriangulation::Node& node = t.triangulation.nodes()[n];
      const VertexId v = map.after(node.vertex);
      if (v == kNone) continue;
      const Box place{node.at, node.at};
      ChangeVisibility viewers(t.opened);
      viewers.mark_viewers({&place, 1});
      for (std::uint32_t m = 0; m < t.triangulation.nodes().size(); ++m) {
        const VertexId w = map.after(t.triangulation.nodes()[m].vertex);
        if (w == kNone || !std::ranges::binary_search(rows->of(v), w)) continue;
        ASSERT_TRUE(viewers.viewers().has(m)) << v << " and " << w;
        ++neighbors;
      }
    }
  }
  EXPECT_GT(worlds, 100u);
  EXPECT_GT(neighbors, 2000u);
}

// Around a place that lies on several opened obstacles, few cones are followed more than once.
TEST(ChangeVisibility, MarksNotAllWhereNeighborsAreOpened) {
  test::OpenedTriangles t(catalog_world("clutter/convex/n1000/m10/f30/s1"));
  const Box place = t.world.box_of(500).grown(0.1);
  for (const ObstacleId o : t.world.regions_meeting(std::vector<Box>{place.grown(10.0)}))
    ASSERT_TRUE(t.opened.open(t.world, o));
  ASSERT_GT(t.opened.opened_vertices(), 50u);
  ChangeVisibility viewers(t.opened);
  viewers.mark_viewers({&place, 1});
  EXPECT_LT(viewers.viewers().all().size(), t.triangulation.nodes().size() / 4);
}

}  // namespace
}  // namespace arcway::internal

#include "arcway/visibility_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace arcway::internal {
namespace {

TEST(VisibilityRows, HaveEachEdgeAtBothEnds) {
  const VisibilityGraph graph({0, 3, 4, 4, 5, 5}, {1, 2, 4, 3, 4});
  const World pentagon({{{{2, 0}, {1, 2}, {-1, 1}, {-1, -1}, {1, -2}}, {}}});
  const auto rows = rows_of(pentagon, graph);
  const std::vector<std::vector<VertexId>> expected{{1, 2, 4}, {0, 3}, {0}, {1, 4}, {0, 3}};
  for (VertexId v = 0; v < expected.size(); ++v) EXPECT_TRUE(std::ranges::equal(rows->of(v), expected[v])) << v;
}

TEST(VisibilityRows, HaveTheShortEdgesOnce) {
  const World world({{{{0, 0}, {4, 0}, {1, 1}}, {}}});
  const auto rows = rows_of(world, VisibilityGraph({0, 2, 3, 3}, {1, 2, 2}));
  using Pairs = std::vector<VisibilityRows::Pair>;
  EXPECT_EQ(rows->pairs_within(
                4.0, [](VertexId, VertexId) { return true; }, SerialExecutor()),
            (Pairs{{0, 1}, {0, 2}, {1, 2}}));
  EXPECT_EQ(rows->pairs_within(
                2.0, [](VertexId, VertexId) { return true; }, SerialExecutor()),
            (Pairs{{0, 2}}));
  EXPECT_EQ(rows->pairs_within(
                4.0, [](VertexId u, VertexId) { return u == 1; }, SerialExecutor()),
            (Pairs{{1, 2}}));
}

TEST(VisibilityRows, AreThoseOfTheWorldsOwnGraph) {
  EXPECT_THROW((void)rows_of(World({}), VisibilityGraph({0, 1, 1}, {1})), std::invalid_argument);
  const World dart({{{{0, 0}, {4, 0}, {1, 1}, {0, 4}}, {}}});  // (1, 1) is reflex
  EXPECT_NO_THROW((void)rows_of(dart, VisibilityGraph({0, 1, 1, 1, 1}, {1})));
  try {
    (void)rows_of(dart, VisibilityGraph({0, 2, 2, 2, 2}, {1, 2}));
    ADD_FAILURE() << "no error";
  } catch (const SnapshotError& error) {
    EXPECT_EQ(error.array(), SnapshotArray::kTargets);
    EXPECT_EQ(error.index(), 1u);
  }
}

TEST(VisibilityRows, OfNothing) { EXPECT_NE(rows_of(World({}), VisibilityGraph()), nullptr); }

}  // namespace
}  // namespace arcway::internal

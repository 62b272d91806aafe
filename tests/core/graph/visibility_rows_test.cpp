#include "core/graph/visibility_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace arcway {
namespace {

TEST(VisibilityRows, HaveEachEdgeAtBothEnds) {
  const VisibilityGraph graph({0, 3, 4, 4, 5, 5}, {1, 2, 4, 3, 4});
  const auto rows = rows_of(World({}), graph);
  const std::vector<std::vector<VertexId>> expected{{1, 2, 4}, {0, 3}, {0}, {1, 4}, {0, 3}};
  for (VertexId v = 0; v < expected.size(); ++v) EXPECT_TRUE(std::ranges::equal(rows->of(v), expected[v])) << v;
}

TEST(VisibilityRows, OfNothing) { EXPECT_NE(rows_of(World({}), VisibilityGraph()), nullptr); }

}  // namespace
}  // namespace arcway

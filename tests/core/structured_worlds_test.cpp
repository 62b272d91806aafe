#include <gtest/gtest.h>

#include <ostream>

#include "arcway/datasets/catalog.h"
#include "arcway/planner.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

// Random poses may stand in a dead end that cannot be left forwards: not all of the queries have a path.
struct WorldCase {
  const char* world;
  std::size_t solved;  // of 10 queries, at least
};
std::ostream& operator<<(std::ostream& out, const WorldCase& c) { return out << c.world; }

class StructuredWorlds : public testing::TestWithParam<WorldCase> {};

TEST_P(StructuredWorlds, HaveTheirPathsFound) {
  const World world = catalog_world(GetParam().world);
  const Planner eager(world, Vehicle());
  const Planner lazy(world, Vehicle(), {.graph_mode = GraphMode::kLazy});
  std::size_t solved = 0;
  for (const PlanRequest& request : catalog_queries(GetParam().world, 10, 1)) {
    const PlanResult result = eager.plan(request);
    const PlanResult again = lazy.plan(request);
    EXPECT_EQ(again.status, result.status);
    EXPECT_EQ(again.travel_time, result.travel_time);
    if (!result.solved()) continue;
    ++solved;
    test::expect_valid(eager, result);
  }
  EXPECT_GE(solved, GetParam().solved);
}

INSTANTIATE_TEST_SUITE_P(Catalog, StructuredWorlds,
                         testing::Values(WorldCase{"maze/v100/s1", 7}, WorldCase{"corridor/v300/s1", 7},
                                         WorldCase{"coastline/v300/s2", 9}, WorldCase{"coastline/v1000/s2", 9}));

}  // namespace
}  // namespace arcway::internal

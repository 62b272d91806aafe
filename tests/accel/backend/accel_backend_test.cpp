#include "arcway/accel/accel_backend.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "arcway/accel/parallel.h"
#include "arcway/datasets/catalog.h"
#include "arcway/planner.h"
#include "core/roadmap/feasible_graph.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

constexpr const char* kName = "clutter/star/n40/m9/f30/s5";

TEST(AccelBackend, PlansLazilyAndAsTheReference) {
  const World world = catalog_world(kName);
  const Planner reference(world, Vehicle{}), planner(world, Vehicle{}, accel_backend(world));
  EXPECT_EQ(planner.feasible_graph().finished(), nullptr);
  EXPECT_EQ(planner.visibility_graph().vertex_count(), 0u);
  for (const PlanRequest& request : catalog_queries(kName, 5, 1))
    test::expect_same_plan(planner.plan(request), reference.plan(request));
}

TEST(AccelBackend, HasTheBuilderThatIsAskedFor) {
  const World world = catalog_world(kName);
  const Backend pairwise = accel_backend(world, kSerialExecutor, {.builder = GraphBuilder::kPairwise});
  const Backend cones = accel_backend(world, kSerialExecutor, {.builder = GraphBuilder::kTangentCones});
  EXPECT_FALSE(pairwise.has_lazy_rows());
  EXPECT_TRUE(cones.has_lazy_rows());
  EXPECT_EQ(*pairwise.reduced_graph(), *reference_backend(world).reduced_graph());
  EXPECT_EQ(*cones.reduced_graph(), *pairwise.reduced_graph());
}

TEST(AccelBackend, ChangesGraphs) {
  const World world = catalog_world(kName);
  const std::vector<ObstacleId> removed{3, 11};
  const World after = world.changed(removed, {});
  const WorldChange change(world, after, removed);
  const Backend backend = accel_backend(after);
  EXPECT_EQ(*backend.changed_graph(*accel_backend(world).reduced_graph(), change), *backend.reduced_graph());
}

TEST(AccelBackend, EndsWhenItsExecutorsClockIsOver) {
  const World world = catalog_world("clutter/convex/n1000/m10/f15/s1");
  const TbbExecutor threads;
  const StoppableExecutor over(threads, StopClock(0.0));
  EXPECT_THROW(Planner(world, Vehicle{}, accel_backend(world, over)), Canceled);
}

}  // namespace
}  // namespace arcway::internal

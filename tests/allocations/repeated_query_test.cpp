#include <gtest/gtest.h>

#include <cstdint>
#include <ostream>
#include <vector>

#include "accel/backend/make_queries.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/planner.h"
#include "bench/suites/allocations.h"
#include "tests/allocations/counting.h"

// In a program of its own, as it counts all that asks the heap for memory.
namespace arcway::internal {
namespace {

struct Case {
  std::uint32_t trials;               // of refinement
  double lateral_acceleration = 0.0;  // if there is one, circles have several radii
  std::uint32_t obstacles = 300;
  std::size_t queries = 60;

  friend void PrintTo(const Case& c, std::ostream* out) {
    *out << c.trials << " trials" << (c.lateral_acceleration > 0.0 ? ", several radii" : "");
  }
};

class RepeatedQuery : public testing::TestWithParam<Case> {};

TEST_P(RepeatedQuery, AsksTheHeapForNothing) {
  if (!test::counts_memory()) GTEST_SKIP() << "a sanitizer's operator new does not count";
  const Case& c = GetParam();
  const World world = random_world({.obstacles = c.obstacles, .vertices = 10, .fill = 0.3, .seed = 2});
  const Vehicle vehicle =
      c.lateral_acceleration > 0.0
          ? Vehicle({.turn_speed = LateralAccelerationLimit{c.lateral_acceleration}, .max_acceleration = 2.0})
          : Vehicle();
  const QuerySet queries = make_embree_queries(world);
  const Planner planner(world, vehicle, backend_of(world, queries), {.refinement = {.max_trials = c.trials}});
  ASSERT_EQ(planner.options().radii.size() > 1, c.lateral_acceleration > 0.0);
  std::vector<PlanRequest> requests = random_queries(world, queries, vehicle, {.count = c.queries, .seed = 3});
  // Where single arcs reach no path, the planner looks for the bottleneck, which takes memory.
  const Planner plain(world, vehicle, backend_of(world, queries, planner.visibility_graph()),
                      {.radii = {vehicle.min_turning_radius()}, .maneuver_poses = 0, .gap_circles = false});
  std::erase_if(requests, [&](const PlanRequest& request) { return !plain.plan(request).solved(); });
  ASSERT_GT(requests.size(), c.queries / 2);

  // Trees take memory of their own, and only where a plan may be far from the best one.
  const PlanLimits limits{.tree_poses = 0};
  PlanResult result;
  // Where memory goes back and forth between two places, both have grown only after a few times.
  for (int round = 0; round < 4; ++round)
    for (const PlanRequest& request : requests) planner.plan(request, limits, result);
  std::uint64_t maneuvers = 0;
  for (const PlanRequest& request : requests) {
    const std::uint64_t before = bench::heap_use().allocations;
    planner.plan(request, limits, result);
    EXPECT_EQ(bench::heap_use().allocations, before) << "query " << &request - requests.data();
    EXPECT_TRUE(result.solved());
    maneuvers += result.statistics.maneuver_poses;
  }
  EXPECT_GT(maneuvers, 0U);  // they have memory of their own
}

// What a planner's first query asks for, most of it memory of the search.
TEST(WarmedUp, AsksTheHeapForLess) {
  if (!test::counts_memory()) GTEST_SKIP() << "a sanitizer's operator new does not count";
  const World world = random_world({.obstacles = 300, .vertices = 10, .fill = 0.3, .seed = 2});
  const QuerySet queries = make_embree_queries(world);
  const PlannerOptions options{.refinement = {.max_trials = 0}};
  const PlanRequest request = random_queries(world, queries, Vehicle(), {.count = 1, .seed = 3}).front();
  const auto bytes_of_first_query = [&](const Planner& planner) {
    const std::int64_t before = bench::heap_use().live_bytes;
    EXPECT_TRUE(planner.plan(request).solved());
    return bench::heap_use().live_bytes - before;
  };
  const Planner cold(world, Vehicle(), backend_of(world, queries), options);
  const Planner warm(world, Vehicle(), backend_of(world, queries), options);
  warm.warm_up();
  EXPECT_LT(4 * bytes_of_first_query(warm), bytes_of_first_query(cold));
}

INSTANTIATE_TEST_SUITE_P(RefinedOrNot, RepeatedQuery,
                         testing::Values(Case{0}, Case{4000, 0.0, 300, 20}, Case{0, 4.0, 60, 10},
                                         Case{200, 4.0, 60, 10}));

}  // namespace
}  // namespace arcway::internal

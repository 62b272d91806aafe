#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "accel/backend/make_queries.h"
#include "accel/graphs/lazy_rows.h"
#include "arcway/planner.h"
#include "bench/suites/allocations.h"
#include "tests/allocations/counting.h"

// In a program of its own, as it counts all that asks the heap for memory.
namespace arcway::internal {
namespace {

// Every other cell of a square field, each of which touches four others at its corners.
World touching_cells(int side) {
  std::vector<Polygon> cells;
  for (int x = 0; x < side; ++x)
    for (int y = (x + 1) % 2; y < side; y += 2)
      cells.push_back({{{1.0 * x, 1.0 * y}, {x + 1.0, 1.0 * y}, {x + 1.0, y + 1.0}, {1.0 * x, y + 1.0}}, {}});
  return World(std::move(cells));
}

// Poses of maneuvers in the open see nearly all of the cells near them, as each hides next to nothing.
TEST(QueryMemory, IsBoundedWhereManyPosesSeeManyObstacles) {
  if (!test::counts_memory()) GTEST_SKIP() << "a sanitizer's operator new does not count";
  constexpr int kSide = 200;
  const World world = touching_cells(kSide);
  const Planner planner(world, Vehicle{}, backend_of(world, make_embree_queries(world), make_lazy_rows(world)),
                        {.graph_mode = GraphMode::kLazy});
  bench::reset_heap_peak();
  const std::int64_t before = bench::heap_use().live_bytes;
  const PlanResult result = planner.plan({{-30.0, 0.5 * kSide, kPi}, {kSide + 30.0, 0.5 * kSide, kPi}});
  ASSERT_TRUE(result.solved());
  ASSERT_GT(result.statistics.maneuver_poses, 400u);
  const auto bytes = static_cast<std::size_t>(bench::heap_use().peak_bytes - before);
  EXPECT_LT(bytes, 500 * world.vertices().size() + 300 * result.statistics.maneuver_poses);
}

}  // namespace
}  // namespace arcway::internal

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "arcway/accel/accel_backend.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/planner.h"
#include "bench/live/live_drive.h"
#include "bench/live/live_planner.h"
#include "bench/suites/allocations.h"
#include "tests/allocations/counting.h"

// In a program of its own, as it counts all that asks the heap for memory.
namespace arcway::internal {
namespace {

TEST(LiveMemory, DoesNotGrowInADriveThroughAMapThatChanges) {
  if (!test::counts_memory()) GTEST_SKIP() << "a sanitizer's operator new does not count";
  constexpr std::size_t kWarmUp = 150, kCycles = 300;
  const World world = random_world({.obstacles = 20, .vertices = 6, .fill = 0.1, .seed = 2});
  const Vehicle vehicle({.max_speed = 3.0, .max_acceleration = 1.0});
  std::vector<Pose> goals;
  const std::vector<PlanRequest> requests =
      random_queries(world, make_reference_queries(world), vehicle, {.count = 4, .seed = 3});
  for (const PlanRequest& request : requests) goals.push_back(request.goal);
  bench::ChangedPlanner planner(
      Planner(world, vehicle, accel_backend(world, kSerialExecutor), {.refinement = {.max_trials = 20}}));
  const Trajectory first = planner.planner().plan(requests.front()).trajectory();
  bench::LiveDrive drive(planner, first, goals, {.within = std::numeric_limits<double>::infinity()});
  std::int64_t most_early = 0, most = 0;
  for (std::size_t i = 0; i < kCycles; ++i) {
    (void)drive.next_cycle();
    std::int64_t& largest = i < kWarmUp ? most_early : most;
    largest = std::max(largest, bench::heap_use().live_bytes);
  }
  EXPECT_LT(most, most_early + most_early / 10);
}

}  // namespace
}  // namespace arcway::internal

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "arcway/accel/accel_backend.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/map_file.h"
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
  constexpr std::size_t kWarmUp = 1500, kCycles = 4000;  // until all obstacles have moved; of all
  const World world = random_world({.obstacles = 20, .vertices = 6, .fill = 0.1, .seed = 2});
  const Vehicle vehicle({.max_speed = 3.0, .max_acceleration = 1.0});
  std::vector<Pose> goals;
  const std::vector<PlanRequest> requests =
      random_queries(world, make_reference_queries(world), vehicle, {.count = 4, .seed = 3});
  for (const PlanRequest& request : requests) goals.push_back(request.goal);
  // Without maneuvers: a search keeps the memory of its largest query, which a rare one with maneuvers would be.
  bench::ChangedPlanner planner(Planner(world, vehicle, accel_backend(world, kSerialExecutor),
                                        {.maneuver_poses = 0, .refinement = {.max_trials = 20}}));
  const Trajectory first = planner.planner().plan(requests.front()).trajectory();
  bench::LiveDrive drive(planner, first, goals, {.within = std::numeric_limits<double>::infinity()});
  std::int64_t most_early = 0, most = 0;
  for (std::size_t i = 0; i < kCycles; ++i) {
    (void)drive.next_cycle();
    std::int64_t& largest = i < kWarmUp ? most_early : most;
    largest = std::max(largest, bench::heap_use().live_bytes);
  }
  EXPECT_LT(most, most_early + most_early / 4);
}

TEST(LiveMemory, KeepsLittleOfEachChange) {
  if (!test::counts_memory()) GTEST_SKIP() << "a sanitizer's operator new does not count";
  constexpr int kChanges = 32;                  // of which what was found is kept
  constexpr std::int64_t kOfOneChange = 75000;  // 54 kB today; 102 kB with a box for each vertex that may differ
  const World world = random_world({.obstacles = 60, .vertices = 10, .fill = 0.15, .seed = 2});
  const Vehicle vehicle({.max_speed = 3.0, .max_acceleration = 1.0});
  const PlanRequest request =
      random_queries(world, make_reference_queries(world), vehicle, {.count = 1, .seed = 3}).front();
  Planner planner(world, vehicle, accel_backend(world, kSerialExecutor), {.refinement = {.max_trials = 20}});
  Polygon moving = to_map_file(world).obstacles.back();
  std::int64_t before = 0;
  for (int i = 0; i <= kChanges; ++i) {
    (void)planner.plan(request);
    if (i == 0) before = bench::heap_use().live_bytes;
    for (Vec2& p : moving.outer) p.x() += i % 2 == 0 ? 0.01 : -0.01;
    const auto last = static_cast<ObstacleId>(planner.world().obstacle_count() - 1);
    planner.change_obstacles(std::vector{planner.world().key_of(last)}, {moving});
  }
  EXPECT_LT(bench::heap_use().live_bytes - before, kChanges * kOfOneChange);
}

}  // namespace
}  // namespace arcway::internal

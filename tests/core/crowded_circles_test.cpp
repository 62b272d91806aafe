// Tight places where, with turns of several radii, many paths to one circle take nearly the same time.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "arcway/datasets/read_map.h"
#include "arcway/datasets/robot.h"
#include "arcway/planner.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

namespace fs = std::filesystem;

World square_posts(int count, double pitch, double size) {
  std::vector<Polygon> posts;
  const double half = 0.5 * size;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      const double x = (i + 0.5) * pitch, y = (j + 0.5) * pitch;
      posts.push_back({{{x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}}, {}});
    }
  const double side = count * pitch;
  return World(posts, Ring{{0.0, 0.0}, {side, 0.0}, {side, side}, {0.0, side}});
}

TEST(CrowdedCircles, HaveFewArrivalsAmongPosts) {
  const World world = square_posts(4, 4.0, 2.5);
  VehicleParameters parameters;
  parameters.turn_speed = LateralAccelerationLimit{8.0};
  parameters.max_acceleration = 4.0;
  PlannerOptions options;
  options.refinement.max_trials = 0;
  const Planner planner(world, Vehicle(parameters), options);
  const PlanResult result = planner.plan({{4.0, 2.0, kPi / 2.0}, {12.0, 14.0, kPi / 2.0}});
  ASSERT_TRUE(result.solved());
  test::expect_valid(planner, result);
  // The exact comparison of all arrivals gives the same path after 21,142 of them.
  EXPECT_LT(result.statistics.nodes_expanded, 14'000u);
  EXPECT_NEAR(result.travel_time, 5.389, 1e-3);
}

TEST(CrowdedCircles, HaveFewArrivalsInAStaircase) {
  const char* shared = std::getenv("ARCWAY_SHARED_DATA");
  const fs::path folder = fs::path(shared != nullptr ? shared : "") / "faults" / "19_slow";
  if (shared == nullptr || !fs::is_directory(folder)) GTEST_SKIP() << "ARCWAY_SHARED_DATA names no folder of maps";
  const MapFile map = read_map(folder / "s1085.geojson");
  const Planner planner(to_world(map, "s1085"), Vehicle(read_robot_file(folder / "s1085.robot.json")),
                        {.graph_mode = GraphMode::kLazy});
  const PlanResult result = planner.plan({*map.start, *map.goal});
  ASSERT_TRUE(result.solved());
  test::expect_valid(planner, result);
  EXPECT_LT(result.statistics.nodes_expanded, 8000u);  // 20,317 if all are compared exactly
  EXPECT_LT(result.travel_time, 4.18);
}

}  // namespace
}  // namespace arcway::internal

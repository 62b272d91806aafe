#include "bench/peers/shortcut.h"

#include <gtest/gtest.h>

#include <array>

#include "arcway/angle.h"

namespace arcway::internal::peers {
namespace {

Path detour(const Vehicle& vehicle) {
  Path path;
  const Pose poses[] = {{2, 2, 0}, {20, 2, kPi / 2}, {20, 20, kPi}, {4, 18, 0}, {30, 30, 0}};
  for (std::size_t i = 1; i < std::size(poses); ++i) {
    const Path motion = shortest_dubins_path(poses[i - 1], poses[i], vehicle.min_turning_radius());
    path.insert(path.end(), motion.begin(), motion.end());
  }
  return path;
}

const auto kNever = [] { return false; };

TEST(Shortcut, FindsTheDubinsPathInAnEmptyWorld) {
  const World world({});
  const Vehicle vehicle;
  const QuerySet queries = make_reference_queries(world);
  const Problem problem{world, vehicle, *queries.sweep, {{2, 2, 0}, {30, 30, 0}}};
  Random random(1);
  const Path path = shortcut(detour(vehicle), problem, {std::array{vehicle.min_turning_radius()}, 500, kNever}, random);
  const double best = travel_time(
      shortest_dubins_path(problem.request.start, problem.request.goal, vehicle.min_turning_radius()), vehicle);
  EXPECT_LT(travel_time(path, vehicle), 1.01 * best);
  EXPECT_TRUE(is_valid(problem, path));
}

TEST(Shortcut, KeepsOutOfObstaclesAndIsNeverSlower) {
  const World world({Polygon{{{8, 5}, {14, 5}, {14, 16}, {8, 16}}, {}}});
  const Vehicle vehicle;
  const QuerySet queries = make_reference_queries(world);
  const Problem problem{world, vehicle, *queries.sweep, {{2, 2, 0}, {30, 30, 0}}};
  const Path given = detour(vehicle);
  ASSERT_TRUE(is_valid(problem, given));
  const double smallest = vehicle.min_turning_radius();
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random random(seed);
    const Path path = shortcut(given, problem, {std::array{smallest, 2.0 * smallest}, 50, kNever}, random);
    EXPECT_TRUE(is_valid(problem, path)) << "seed " << seed;
    EXPECT_LE(travel_time(path, vehicle), travel_time(given, vehicle)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace arcway::internal::peers

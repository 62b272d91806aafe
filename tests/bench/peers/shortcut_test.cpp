#include "bench/peers/shortcut.h"

#include <gtest/gtest.h>

#include "bench/peers/comparison.h"
#include "core/geometry/angle.h"

namespace arcway::peers {
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
  const Path path = shortcut(detour(vehicle), problem, random, 500, kNever);
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
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random random(seed);
    const Path path = shortcut(given, problem, random, 50, kNever);
    EXPECT_TRUE(is_valid(problem, path)) << "seed " << seed;
    EXPECT_LE(travel_time(path, vehicle), travel_time(given, vehicle)) << "seed " << seed;
  }
}

TEST(Comparison, CountsWhatOneOfTwoPlannersSolves) {
  const std::vector<std::string> planners{"arcway", "peer"};
  std::vector<Row> rows(3);
  const Answer fast{0.001, 10.0, {}, true}, slow{0.5, 15.0, {}, true};
  rows[0] = {"w", 0, {}, 9.0, {fast, slow}};
  rows[1] = {"w", 1, {}, 9.0, {fast, std::nullopt}};
  rows[2] = {"w", 2, {}, 9.0, {std::nullopt, slow}};
  const std::string table = comparison_table(planners, rows);
  EXPECT_NE(table.find("| w | peer | 2 / 3 | 2 | 500 | 1.500 / 1.500 / 1.500 / 1.500 / 1.500 | 1 | 1 |"),
            std::string::npos)
      << table;
  EXPECT_NE(comparison_csv(planners, rows).find("w,2,arcway,0,,,,9\n"), std::string::npos);
}

}  // namespace
}  // namespace arcway::peers

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "arcway/datasets/catalog.h"
#include "arcway/planner.h"
#include "arcway/query_set.h"
#include "core/planner/planner_inputs.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

// The graph alone, by single arcs.
PlannerOptions graph_alone(double suboptimality) {
  PlannerOptions options;
  options.suboptimality = suboptimality;
  options.maneuver_poses = 0;
  options.gap_circles = false;
  options.refinement.max_trials = 0;
  return options;
}

TEST(Suboptimality, BoundsHowMuchSlowerThePathIs) {
  const std::vector<std::string> worlds = {"clutter/convex/n60/m8/f30/s2", "clutter/star/n60/m10/f15/s3",
                                           "clutter/star/n60/m10/f45/s4", "corridor/v300/s1", "maze/v300/s2"};
  VehicleParameters gentle;  // carries its speed through many segments
  gentle.turn_speed = LateralAccelerationLimit{2.0};
  gentle.max_acceleration = 2.0;
  int solved = 0, slower = 0;
  for (const Vehicle& vehicle : {Vehicle(), Vehicle(gentle)})
    for (const std::string& name : worlds) {
      const World world = catalog_world(name);
      const auto queries = catalog_queries(name, 12, 1);
      const Planner exact(world, vehicle, graph_alone(0.0));
      std::uint64_t fewest = std::numeric_limits<std::uint64_t>::max();
      for (const double w : {0.02, 0.1, 0.5}) {
        const Planner loose(world, vehicle, graph_alone(w));
        std::uint64_t expanded = 0;
        for (const PlanRequest& request : queries) {
          const PlanResult best = exact.plan(request), found = loose.plan(request);
          EXPECT_EQ(found.status, best.status) << name << " " << w;
          EXPECT_EQ(found.statistics.suboptimality, w);
          EXPECT_EQ(best.statistics.suboptimality, 0.0);
          if (!best.solved() || !found.solved()) continue;
          test::expect_valid(loose, found);
          const double least = best.statistics.unrefined_travel_time;
          EXPECT_GE(found.statistics.unrefined_travel_time, least * (1.0 - 1e-9)) << name << " " << w;
          EXPECT_LE(found.statistics.unrefined_travel_time, (1.0 + w) * least * (1.0 + 1e-12)) << name << " " << w;
          slower += found.statistics.unrefined_travel_time > least * (1.0 + 1e-9) ? 1 : 0;
          expanded += found.statistics.nodes_expanded;
          ++solved;
        }
        EXPECT_LE(expanded, fewest) << name << " " << w;
        fewest = expanded;
      }
    }
  EXPECT_GT(solved, 200);
  EXPECT_GT(slower, 20);
}

TEST(Suboptimality, IsAllowedOnLargeMapsUnlessToldOtherwise) {
  const auto squares = [](std::size_t count) {
    std::vector<Polygon> obstacles;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 at(3.0 * static_cast<double>(i % 300), 3.0 * static_cast<double>(i / 300));
      obstacles.push_back({{at, at + Vec2(1, 0), at + Vec2(1, 1), at + Vec2(0, 1)}, {}});
    }
    return World(std::move(obstacles));
  };
  constexpr std::size_t kMostSquares = PlannerOptions::kExactVertices / 4;
  const World small = squares(kMostSquares), large = squares(kMostSquares + 1);
  EXPECT_EQ(checked_options(small, Vehicle(), {}).suboptimality, 0.0);
  EXPECT_EQ(checked_options(large, Vehicle(), {}).suboptimality, PlannerOptions::kLargeMapSuboptimality);
  EXPECT_EQ(checked_options(large, Vehicle(), graph_alone(0.0)).suboptimality, 0.0);
  EXPECT_EQ(checked_options(small, Vehicle(), graph_alone(0.1)).suboptimality, 0.1);
  EXPECT_EQ(Planner(squares(4), Vehicle()).options().suboptimality, 0.0);
}

TEST(Suboptimality, IsNeitherNegativeNorBeyondAMillion) {
  const World world = catalog_world("clutter/convex/n4/m4/f15");
  for (const double w :
       {-0.1, 1.1e6, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    try {
      const Planner planner(world, Vehicle(), graph_alone(w));
      ADD_FAILURE() << w;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("suboptimality"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace arcway::internal

#include "core/search/tree_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/query_set.h"
#include "core/planner/strategy.h"
#include "tests/support/boxes.h"
#include "tests/support/lazy_maps.h"
#include "tests/support/narrow_queries.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

using test::car;
using test::NarrowQuery;
using test::planner_of;
using test::Variant;

VehicleParameters bus() {
  return {.length = 12.0,
          .width = 2.55,
          .wheelbase = 6.0,
          .max_steering_angle = 0.7,
          .max_speed = 8.0,
          .turn_speed = ConstantTurnSpeed{3.0},
          .max_acceleration = 1.0,
          .safety_margin = 0.05};
}

std::vector<NarrowQuery> narrow_queries() {
  return {
      {"bus pulls up 20 cm from a curb",
       bus(),
       {test::ring_of_box(-60.0, -4.0, 200.0, -1.475)},
       test::ring_of_box(-60.0, -4.0, 200.0, 12.0),
       {0.0, 3.5, 0.0},
       {80.0, 0.0, 0.0}},
      {"bus pulls out",
       bus(),
       {test::ring_of_box(-60.0, -4.0, 200.0, -1.475)},
       test::ring_of_box(-60.0, -4.0, 200.0, 12.0),
       {0.0, 0.0, 0.0},
       {80.0, 3.5, 0.0}},
      {"car leaves a wall at 2 cm",
       car(),
       {test::ring_of_box(-30.0, -3.0, 80.0, -0.92)},
       test::ring_of_box(-30.0, -3.0, 80.0, 15.0),
       {0.0, 0.0, 0.0},
       {40.0, 3.0, 0.0}},
      {"car pulls up 15 cm from a curb within 20 m",
       car(),
       {test::ring_of_box(-30.0, -3.0, 80.0, -1.05)},
       test::ring_of_box(-30.0, -3.0, 80.0, 15.0),
       {0.0, 3.0, 0.0},
       {20.0, 0.0, 0.0}},
      {"car turns round in a hall of 12.3 m",
       car(),
       {test::ring_of_box(-80.0, 6.15, 20.0, 9.15), test::ring_of_box(-80.0, -9.15, 20.0, -6.15),
        test::ring_of_box(18.0, -6.15, 20.0, 6.15)},
       test::ring_of_box(-80.0, -9.15, 20.0, 9.15),
       {-50.0, 0.0, 0.0},
       {-55.0, 0.0, kPi}},
  };
}

class NarrowWays : public testing::TestWithParam<Variant> {};

TEST_P(NarrowWays, AreFoundForwards) {
  for (const NarrowQuery& query : narrow_queries()) {
    SCOPED_TRACE(query.name);
    const Planner planner = planner_of(query, GetParam());
    const PlanResult result = planner.plan({.start = GetParam()(query.start), .goal = GetParam()(query.goal)});
    EXPECT_TRUE(result.solved()) << result.reason;
    if (result.solved()) test::expect_valid(planner, result);
  }
}

INSTANTIATE_TEST_SUITE_P(Variants, NarrowWays, testing::ValuesIn(test::variants()),
                         [](const auto& param_info) { return std::string(param_info.param.name); });

// No motion leads out of a bay that is as long as the body: the trees run dry.
TEST(TreeSearch, EndsWhereNothingLeadsOn) {
  const NarrowQuery query{"shut in",
                          car(),
                          {test::ring_of_box(3.75, -1.0, 5.0, 1.0), test::ring_of_box(-2.0, -3.0, 5.0, -1.0),
                           test::ring_of_box(-2.0, 1.0, 5.0, 3.0)},
                          test::ring_of_box(-10.0, -10.0, 30.0, 10.0),
                          {0.0, 0.0, 0.0},
                          {20.0, 0.0, 0.0}};
  const Planner planner = planner_of(query, {"plain", 1.0, 0.0, false, {0.0, 0.0}});
  const PlanResult result = planner.plan({.start = query.start, .goal = query.goal});
  EXPECT_EQ(result.status, PlanStatus::kStartBlocked) << result.reason;
}

TEST(TreeSearch, CanBeStopped) {
  const NarrowQuery query = narrow_queries().back();
  const Planner planner = planner_of(query, {"plain", 1.0, 0.0, false, {0.0, 0.0}});
  std::stop_source stopped;
  stopped.request_stop();
  const PlanResult result = planner.plan({.start = query.start, .goal = query.goal}, {.stop = stopped.get_token()});
  EXPECT_EQ(result.status, PlanStatus::kCanceled);
}

// A path that was refused is not offered again. In a narrow lane most poses of the trees lead to the same line.
TEST(TreeSearch, OffersNoPathTwice) {
  const Vehicle vehicle;
  const World world({test::box(-2.0, 0.402, 14.0, 2.0), test::box(-2.0, -2.0, 14.0, -0.402)});
  const Roadmap map = test::lazy_map(world, vehicle);
  std::vector<double> offered;
  const auto refuse = [&](const Path& path) -> std::optional<Path> {
    offered.push_back(length_of(path));
    return std::nullopt;
  };
  ArrivalSearch arrivals;
  TreesEnd end;
  const TreeLimits limits{
      .poses = 4000, .passes = std::span(kTreePasses).first<1>(), .effort = kTreeEffort, .accept = refuse};
  const FoundPath found = search_trees({map, {0.0, 0.0, 0.0}, {12.0, 0.0, 0.0}, limits}, {}, arrivals, end);
  EXPECT_FALSE(found.search.path);
  ASSERT_FALSE(offered.empty());
  EXPECT_EQ(end.refused, offered.size());
  for (std::size_t i = 0; i < offered.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_GT(std::abs(offered[i] - offered[k]), 1e-9 * offered[k]) << i << ' ' << k;
}

// The end of a search between two poses of a world, and its path.
struct Trees {
  TreesEnd end;
  std::optional<Path> path;
};
Trees grown(const World& world, const Pose& start, const Pose& goal, const SurroundingsEffort* effort) {
  const Vehicle vehicle;
  const Roadmap map = test::lazy_map(world, vehicle);
  const TreeLimits limits{.poses = 4000,
                          .passes = std::span(kTreePasses).first<1>(),
                          .effort = kTreeEffort,
                          .surroundings_effort = effort,
                          .dead_end_passes = kDeadEndPasses};
  ArrivalSearch arrivals;
  Trees trees;
  trees.path = search_trees({map, start, goal, limits}, {}, arrivals, trees.end).search.path;
  return trees;
}

// Where trees find a path, nothing else grows.
TEST(TreeSearch, ExploresNoSurroundingsOfAPath) {
  const World lane({test::box(-2.0, 0.402, 14.0, 2.0), test::box(-2.0, -2.0, 14.0, -0.402)});
  const Pose start{0.0, 0.0, 0.0}, goal{12.0, 0.0, 0.0};
  const Trees alone = grown(lane, start, goal, nullptr), exploring = grown(lane, start, goal, &kSurroundingsEffort);
  ASSERT_TRUE(alone.path && exploring.path);
  EXPECT_EQ(exploring.end.poses, alone.end.poses);
  EXPECT_EQ(length_of(*exploring.path), length_of(*alone.path));
}

// The tree of the end that is shut in has no more poses. The other one need not grow on.
TEST(TreeSearch, ExploresSurroundingsWhereATreeRunsDry) {
  const World wall({test::box(1.6, -40.0, 2.6, 40.0)});
  const Pose shut_in{0.0, 0.0, 0.0}, outside{40.0, 60.0, 0.0};
  const Trees trees = grown(wall, shut_in, outside, &kSurroundingsEffort);
  EXPECT_FALSE(trees.path);
  EXPECT_EQ(trees.end.surroundings, Surroundings::kClosed);
  EXPECT_TRUE(trees.end.ran_dry && trees.end.start_in_dead_end);
  EXPECT_FALSE(trees.end.goal_in_dead_end);
  EXPECT_EQ(grown(wall, shut_in, outside, nullptr).end.surroundings, Surroundings::kOpen);
}

}  // namespace
}  // namespace arcway::internal

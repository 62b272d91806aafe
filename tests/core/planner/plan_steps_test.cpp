#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include "arcway/datasets/catalog.h"
#include "arcway/datasets/driven_world.h"
#include "core/planner/strategy.h"
#include "tests/support/boxes.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

// A driven world, whose drive proves that a way exists, and the row of the strategy that finds one.
struct Narrow {
  std::string world, row;
  bool reverse;
  friend void PrintTo(const Narrow& narrow, std::ostream* out) { *out << narrow.world; }
};

PlanResult plan(const Narrow& narrow, std::vector<std::string> leave_out) {
  const DrivenWorld driven = *catalog_driven_world(narrow.world);
  const Planner planner(to_world(driven.map, "driven"), Vehicle(driven.robot), {.leave_out = std::move(leave_out)});
  PlanResult result = planner.plan({.start = *driven.map.start, .goal = *driven.map.goal, .reverse = narrow.reverse});
  if (result.solved()) test::expect_valid(planner, result, narrow.reverse);
  return result;
}

class NarrowWay : public testing::TestWithParam<Narrow> {};

TEST_P(NarrowWay, IsFoundByItsRowAlone) {
  const PlanResult found = plan(GetParam(), {});
  EXPECT_TRUE(found.solved()) << found.reason;
  const PlanResult missed = plan(GetParam(), {GetParam().row});
  EXPECT_FALSE(missed.solved());
  EXPECT_EQ(missed.certainty, Certainty::kGaveUp);
}

INSTANTIATE_TEST_SUITE_P(
    Driven, NarrowWay,
    testing::Values(
        // The shortest route misleads the trees for thousands of poses.
        Narrow{"driven/hugging/r9/g1/c50/s2121", "trees of a slim body", false},
        // No motion of the real body that trees find leads out of the end; one of the slimmer body does.
        Narrow{"driven/hugging/r3/g1/c2/s2169", "trees of a less slim body", false},
        Narrow{"driven/rooms/r9/g2/c50/s2087", "narrow trees in both gears", true}),
    [](const testing::TestParamInfo<Narrow>& test) {
      std::string name = test.param.row;
      std::ranges::replace(name, ' ', '_');
      return name;
    });

// There is one way between long walls, which all roadmaps lead along. Its first path is refined, and in the end the
// best one at length: other roadmaps add no trials, though they are searched.
TEST(PlanSteps, RefineAWayOnce) {
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0});
  const World world(
      {test::box(0.0, -3.0, 1.0, 60.0), test::box(10.0, -60.0, 11.0, 3.0), test::box(20.0, -3.0, 21.0, 60.0)});
  const PlanRequest request{.start = {-15.0, 0.0, 0.0}, .goal = {35.0, 0.0, 0.0}};
  const PlanResult all = Planner(world, vehicle, {}).plan(request);
  std::vector<std::string> other_radii;
  for (const StrategyRow& row : kStrategy)
    if (std::holds_alternative<TryOtherRadii>(row.step)) other_radii.emplace_back(row.name);
  ASSERT_FALSE(other_radii.empty());
  const PlanResult few = Planner(world, vehicle, {.leave_out = other_radii}).plan(request);
  ASSERT_TRUE(all.solved());
  EXPECT_EQ(all.travel_time, few.travel_time);
  EXPECT_EQ(all.statistics.refine_trials, few.statistics.refine_trials);
  EXPECT_GT(all.statistics.nodes_expanded, few.statistics.nodes_expanded);
}

}  // namespace
}  // namespace arcway::internal

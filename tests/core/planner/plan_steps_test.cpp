#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "arcway/datasets/catalog.h"
#include "arcway/datasets/driven_world.h"
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

}  // namespace
}  // namespace arcway::internal

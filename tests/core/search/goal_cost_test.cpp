#include "core/search/goal_cost.h"

#include <gtest/gtest.h>

#include <memory>
#include <span>

#include "core/attach/roadmap.h"
#include "core/collision/clearance_cost.h"
#include "core/search/arrival_search.h"
#include "tests/support/graph_case.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal::goal_cost_test {
namespace {

double least_cost_to(const Roadmap& map, const Pose& start_pose, const Pose& goal_pose) {
  const Attachment start{start_pose, {}}, goal{goal_pose, {}};
  SearchResult result;
  const SearchOptions options;
  SearchContext context(map, {&start, 1}, {&goal, 1}, options, result);
  SearchAttachments attachments;
  attachments.begin(context);
  return least_goal_cost(context, attachments);
}

TEST(GoalCost, IsNoMoreThanPathsCostAndMoreThanNothingInClosePlaces) {
  const test::GraphCase in;
  const Roadmap plain(in.world, in.vehicle, in.queries, in.radii, in.finished(),
                      std::make_shared<const Outlines>(in.world));
  const auto cost = std::make_shared<const ClearanceCost>(in.vehicle, plain.outlines,
                                                          ClearancePreference{.distance = 0.4, .cost = 20.0});
  const Roadmap map = plain.with_cost(cost);
  test::RandomInputs random(2);
  const double side = in.world.box().max.x();
  ArrivalSearch search;
  int free = 0, close = 0;
  for (int i = 0; i < 120; ++i) {
    const Pose start{random.uniform(0, side), random.uniform(0, side), random.uniform(-3.0, 3.0)};
    const Pose goal{random.uniform(0, side), random.uniform(0, side), random.uniform(-3.0, 3.0)};
    const Attachment from{start, {}}, to{goal, {}};
    const SearchResult found = search.find(map, {&from, 1}, {&to, 1}, {});
    if (!found.path || found.last_circle == kNone) continue;
    const double least = least_cost_to(map, start, goal);
    // The last line and the last arc; a line and the one before it where there is no arc.
    const std::span<const PathSegment> end = std::span<const PathSegment>(*found.path).last(2);
    EXPECT_LE(least, cost->of(end) * (1.0 + 1e-9)) << "query " << i;
    EXPECT_EQ(least_cost_to(plain, start, goal), 0.0);
    ++(least > 1.0 ? close : free);
  }
  EXPECT_GT(close, 5);
  EXPECT_GT(free, 5);
}

}  // namespace
}  // namespace arcway::internal::goal_cost_test

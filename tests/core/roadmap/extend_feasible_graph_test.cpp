#include "core/roadmap/extend_feasible_graph.h"

#include <gtest/gtest.h>

#include <vector>

#include "arcway/executor.h"
#include "arcway/stop_clock.h"
#include "core/gaps/gap_circles.h"
#include "core/gaps/vehicle_gaps.h"
#include "tests/support/graph_case.h"

namespace arcway::internal {
namespace {

TEST(ExtendFeasibleGraph, KeepsTheLinksOfTheBaseAmongMoreCircles) {
  const test::GraphCase c({.kind = ClutterKind::kStar, .obstacles = 30, .vertices = 8, .fill = 0.45, .seed = 3});
  const auto base = c.finished();
  const AddedCircles added =
      find_gap_circles(c.world, VehicleGaps(c.world, c.vehicle, c.radii[0]).map(), c.vehicle, c.radii[0]);
  ASSERT_FALSE(added.around_vertices.empty());
  ASSERT_FALSE(added.gap_straights.empty());
  const auto more = extend_feasible_graph(base, c.vehicle, added);
  const std::size_t count = base->circles().size();
  const TurnCircles& circles = more->turn_circles();
  ASSERT_EQ(circles.base_count(), count);
  std::size_t gap_straight_circles = 0;
  for (const GapStraight& straight : added.gap_straights)
    gap_straight_circles += straight.entries.size() + straight.exits.size();
  ASSERT_EQ(more->circles().size(), count + added.around_vertices.size() + gap_straight_circles);

  const Footprint body = c.vehicle.footprint(0.5 * c.vehicle.safety_margin());
  std::vector<FeasibleLink> among_base;
  std::size_t onto = 0, through = 0, off = 0, round = 0;
  for (const FeasibleLink& link : test::kept_links(*more)) {
    if (link.from < count && link.to < count) {
      among_base.push_back(link);
      continue;
    }
    EXPECT_TRUE(c.queries.sweep->straight_free(
        swept_rectangle(pose_on(more->circles()[link.from], link.heading), link.length, body)));
    EXPECT_TRUE(more->free_headings(link.from).contains(link.heading));
    EXPECT_TRUE(more->free_headings(link.to).contains(link.heading));
    const bool from_gap_straight = circles.is_of_gap_straight(link.from),
               to_gap_straight = circles.is_of_gap_straight(link.to);
    const bool in_gap_straight = from_gap_straight && !circles.is_exit(link.from);
    EXPECT_EQ(in_gap_straight,
              to_gap_straight &&
                  circles.is_exit(link.to));  // an entry leads to its gap straight's exits, and nothing else does
    (in_gap_straight ? through : to_gap_straight ? onto : from_gap_straight ? off : round) += 1;
  }
  test::expect_same(among_base, base->links());
  for (const std::size_t kind : {onto, through, off, round}) EXPECT_GT(kind, 0u);
}

TEST(ExtendFeasibleGraph, EndsOnceTheClockIsOver) {
  const test::GraphCase c({.kind = ClutterKind::kStar, .obstacles = 30, .vertices = 8, .fill = 0.45, .seed = 3});
  const auto base = c.finished();
  AddedCircles added;
  EXPECT_THROW((void)extend_feasible_graph(base, c.vehicle, added, StopClock(0.0)), Canceled);
  EXPECT_EQ(extend_feasible_graph(base, c.vehicle, added)->circles().size(), base->circles().size());
}

}  // namespace
}  // namespace arcway::internal

#include "arcway/text.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "arcway/arcway.h"
#include "core/base/shortest_text.h"
#include "tests/support/boxes.h"

namespace arcway::internal {
namespace {

template <class T>
std::string streamed(const T& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

TEST(Text, IsWhatStreamsShow) {
  const PathSegment line{{1.0, 2.0, 0.5}, 3.0, 0.0};
  EXPECT_EQ(streamed(line.start), "(1, 2, 0.5)");
  EXPECT_EQ(streamed(line), "line of 3 m forwards from (1, 2, 0.5)");
  const PathSegment arc{{}, 2.0, -0.5, Gear::kReverse};
  EXPECT_EQ(streamed(arc), "right arc of 2 m with radius 2 m backwards from (0, 0, 0)");
  EXPECT_EQ(streamed(Path{line, arc}), "2 segments, 5 m, 1 gear change");
  EXPECT_EQ(streamed(Path{line}), "1 segment, 3 m, 0 gear changes");
  EXPECT_EQ(streamed(TimedSegment{line, 0.0, 1.5, 4.0}),
            "line of 3 m forwards from (1, 2, 0.5), from 0 to 1.5 m/s in 4 s");
  EXPECT_EQ(streamed(Side::kLeft) + streamed(Side::kRight), "leftright");
  EXPECT_EQ(streamed(Gear::kForward) + streamed(Gear::kReverse), "forwardsbackwards");
}

TEST(Text, RoundsToThreeDecimals) {
  EXPECT_EQ(rounded_text(1.0 / 3.0), "0.333");
  EXPECT_EQ(rounded_text(1200.0), "1200");
  EXPECT_EQ(rounded_text(-2.5), "-2.5");
  EXPECT_EQ(rounded_text(-1e-9), "0");
  EXPECT_EQ(rounded_text(-0.0), "0");
}

TEST(Text, DescribesWorldsAndVehicles) {
  EXPECT_EQ(streamed(test::box(0, 0, 1, 1)), "polygon of 4 vertices");
  EXPECT_EQ(streamed(Polygon{test::box_ring(0, 0, 9, 9), {test::box_ring(1, 1, 2, 2)}}),
            "polygon of 4 vertices with 1 hole");
  EXPECT_EQ(streamed(World({test::box(0, 0, 1, 1)})), "1 obstacle of 4 vertices");
  EXPECT_EQ(streamed(World({}, test::box_ring(0, 0, 1, 1))), "0 obstacles of 4 vertices within bounds");
  EXPECT_EQ(streamed(Vehicle{}), "1.5 m x 0.8 m, front steering, turning radius 1.3 m, 12 m/s, 50 m/s^2");
  EXPECT_EQ(streamed(Steering::kRear) + streamed(Steering::kSymmetric), "rearsymmetric");
  EXPECT_EQ(streamed(VisibilityGraph({0, 1, 1}, {1})), "2 vertices, 1 edges");
}

TEST(Text, SumsUpPlans) {
  const PlanRequest request{.start = {0, 0, 0}, .goal = {30, 0, 0}, .reverse = true, .max_gear_changes = 2};
  EXPECT_EQ(streamed(request), "from (0, 0, 0) to (30, 0, 0) in both gears, at most 2 gear changes");
  const Planner planner(World({}), Vehicle{});
  const PlanResult plan = planner.plan({.start = {0, 0, 0}, .goal = {30, 0, 0}});
  EXPECT_EQ(streamed(plan.status), "solved");
  EXPECT_EQ(streamed(plan).find("solved: 2.74 s, 1 segment, 30 m, 0 gear changes, at most "), 0u) << plan;
  EXPECT_EQ(streamed(plan.trajectory()), "2.74 s, 30 m, 1 segment");
  EXPECT_EQ(streamed(plan.trajectory().at_distance(15.0)),
            "1.37 s, 15 m: (15, 0, 0) at 12 m/s forwards, 0 m/s^2, curvature 0 1/m");
  PlanResult none;
  none.status = PlanStatus::kNoPassage;
  none.certainty = Certainty::kProved;
  none.reason = "no gap is wide enough";
  EXPECT_EQ(streamed(none), "no passage (proved): no gap is wide enough");
  EXPECT_EQ(streamed(Certainty::kGaveUp), "gave up");
  const Tour tour = plan_tour(planner, {.start = {0, 0, 0}, .waypoints = {{{15, 0}, 0.0}}, .goals = {{{30, 0}, 0.0}}});
  EXPECT_NE(streamed(tour).find(", to goal 0 over 1 waypoint"), std::string::npos) << tour;
}

TEST(Text, NamesWhatIsWrongWithAPath) {
  const World world({test::box(8, -4, 12, 4)});
  const TimedPath through{{{{0, 0, 0}, 20.0, 0.0}}, {}, {}, {}};
  const ValidationReport report = validate(world, Vehicle{}, {0, 0, 0}, {20, 0, 0}, through);
  EXPECT_EQ(streamed(report).find("1 issue\ncollision in segment 0 after "), 0u) << report;
  EXPECT_EQ(streamed(Violation::kCollision), "collision");
  EXPECT_EQ(streamed(validate(World({}), Vehicle{}, {0, 0, 0}, {20, 0, 0}, through)),
            "valid: 20 m, 0 s, clearance inf m");
}

}  // namespace
}  // namespace arcway::internal

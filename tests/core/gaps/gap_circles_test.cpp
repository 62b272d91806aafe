#include "core/gaps/gap_circles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "arcway/angle.h"
#include "arcway/query_set.h"
#include "core/gaps/vehicle_gaps.h"
#include "tests/support/boxes.h"

namespace arcway::internal {
namespace {

const Vehicle kGapVehicle;
const double kRadius = kGapVehicle.min_turning_radius();
const Footprint kGrown = kGapVehicle.footprint(kGapVehicle.safety_margin());

// A door between two walls that reach far up and down.
World door(double width, double thickness) {
  return World({test::box(0, -20, thickness, 0), test::box(0, width, thickness, 20 + width)});
}

AddedCircles circles_of(const World& world) {
  return find_gap_circles(world, VehicleGaps(world, kGapVehicle, kRadius).map(), kGapVehicle, kRadius);
}

// How far a path may turn on a circle that leaves a gap straight at a heading, or comes onto it.
double turn_at(const World& world, const TurnCircle& circle, double heading, bool exit) {
  const QuerySet queries = make_reference_queries(world);
  const HeadingSet free = queries.sweep->free_headings(
      {circle.center, circle.radius, circle.side, kGapVehicle.footprint(0.5 * kGapVehicle.safety_margin())});
  return free.reach(heading, exit ? circle.side : opposite(circle.side));
}

TEST(GapCircles, LeadThroughADoorThatIsTooNarrowToTurnIn) {
  const World world = door(0.85, 1.0);
  const AddedCircles added = circles_of(world);
  for (const double ahead : {0.0, kPi})
    for (const Side side : {Side::kLeft, Side::kRight}) {
      double most_off = -1.0, most_onto = -1.0;
      const auto widest = [&](const std::vector<TurnCircle>& circles, bool exit, double& most) {
        for (const TurnCircle& c : circles) {
          EXPECT_EQ(c.radius, kRadius);
          // The door's middle line touches the circle.
          const double heading = std::abs(pose_on(c, 0.0).y - 0.425) < 1e-9 ? 0.0 : kPi;
          EXPECT_NEAR(pose_on(c, heading).y, 0.425, 1e-9);
          if (c.side == side && heading == ahead) most = std::max(most, turn_at(world, c, heading, exit));
        }
      };
      for (const GapStraight& straight : added.gap_straights) {
        widest(straight.exits, true, most_off);
        widest(straight.entries, false, most_onto);
      }
      EXPECT_GE(most_off, 0.5 * kPi);
      EXPECT_GE(most_onto, 0.5 * kPi);
    }
}

TEST(GapCircles, HaveTheRadiusThatANarrowPlaceDemands) {
  // A corner faces a long wall: too near for the tightest turn.
  const double width = 1.1;
  ASSERT_LT(width, swept_annulus(kGrown, Side::kLeft, kRadius).width());
  const World world({test::box(-40, -41, 40, -40), {{{0, -40 + width}, {10, -20}, {-10, -20}}, {}}});
  const AddedCircles added = circles_of(world);
  ASSERT_EQ(added.around_vertices.size(), 2u);  // to the left and to the right
  const TurnCircle& circle = added.around_vertices.front();
  EXPECT_GT(circle.radius, kRadius);
  const SweptAnnulus swept = swept_annulus(kGrown, Side::kLeft, circle.radius);
  EXPECT_LE(swept.width(), width);
  EXPECT_GT(swept.width(), width - 0.01);
  EXPECT_NEAR((circle.center - Vec2(0, -40 + width)).norm(), swept.inner, 1e-9);
  EXPECT_GE(circle.center.y() + 40.0, swept.outer);
}

TEST(GapCircles, TouchWhatTheirVertexFaces) {
  // The bisector of the corner points at 45 degrees, and the circle there would collide with the wall below.
  const SweptAnnulus swept = swept_annulus(kGrown, Side::kLeft, kRadius);
  const double width = 0.5 * (swept.width() + swept.outer - swept.inner * std::sqrt(0.5));
  const World world({test::box(-40, -41, 40, -40), test::box(0, -40 + width, 30, 0)});
  const AddedCircles added = circles_of(world);
  const auto touching =
      std::ranges::find_if(added.around_vertices, [](const TurnCircle& c) { return c.center.x() < 15.0; });
  ASSERT_NE(touching, added.around_vertices.end());
  EXPECT_NEAR((touching->center - Vec2(0, -40 + width)).norm(), swept.inner, 1e-9);
  EXPECT_NEAR(touching->center.y() + 40.0, swept.outer, 1e-9);
  EXPECT_GT(touching->center.x(), 0.0);
}

TEST(GapCircles, AreNotMadeWhereTheBodyDoesNotFitOrHasRoom) {
  for (const double width : {0.0, 0.5, 0.8, kGrown.width(), 2.3}) {
    const AddedCircles added = circles_of(door(width, 1.0));
    EXPECT_TRUE(added.around_vertices.empty()) << width;
    EXPECT_TRUE(added.gap_straights.empty()) << width;
  }
  const double most = swept_annulus(kGrown, Side::kLeft, kRadius).outer;
  EXPECT_FALSE(circles_of(door(0.99 * most, 1.0)).gap_straights.empty());
  EXPECT_TRUE(circles_of(door(1.01 * most, 1.0)).gap_straights.empty());
  EXPECT_TRUE(circles_of(World({})).gap_straights.empty());
}

TEST(GapCircles, KnowVerticesNearBy) {
  const AddedCircles added = circles_of(door(0.9, 30.0));
  ASSERT_FALSE(added.gap_straights.empty());
  const World world = door(0.9, 30.0);
  for (const GapStraight& straight : added.gap_straights)
    for (const auto& circles : {straight.entries, straight.exits})
      for (const TurnCircle& c : circles) {
        ASSERT_NE(c.vertex, kNone);
        EXPECT_LT((c.center - world.vertex(c.vertex)).norm(), 7.0);
      }
}

}  // namespace
}  // namespace arcway::internal

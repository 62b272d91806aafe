#include "core/attach/maneuvers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "arcway/datasets/catalog.h"
#include "arcway/planner.h"
#include "arcway/query_set.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

// Goals that are entered through a narrow range of headings only: between a wall and a corner, and along the bounds.
TEST(Maneuvers, ReachGoalsBesideAWall) {
  const Planner planner(catalog_world("clutter/convex/n100/m10/f45"), Vehicle());
  const PlanRequest requests[] = {
      {{7.390247560079878, 71.2415520058915, -0.3152196150963773},
       {92.07973811590975, 106.02145761459767, -1.131966038614141}},
      {{14.129946945134208, 51.599898635543376, 1.7445171392715775},
       {0.552278813532845, 105.24671320632633, 1.475693762743628}},
  };
  for (const PlanRequest& request : requests) {
    const PlanResult result = planner.plan(request);
    ASSERT_TRUE(result.solved()) << result.reason;
    EXPECT_EQ(result.start.position(), request.start.position());
    EXPECT_EQ(result.goal.position(), request.goal.position());
    test::expect_valid(planner, result);
  }
}

// Goals that are entered after turning back in the open, round no vertex.
TEST(Maneuvers, TurnBackWhereThereIsRoom) {
  struct Case {
    const char* world;
    std::size_t query;
  };
  for (const Case& c : {Case{"corridor/v300/s1", 5}, Case{"maze/v300/s2", 45}}) {
    const Planner planner(catalog_world(c.world), Vehicle());
    const PlanResult result = planner.plan(catalog_queries(c.world, c.query + 1, 1).back());
    ASSERT_TRUE(result.solved()) << c.world << ": " << result.reason;
    test::expect_valid(planner, result);
  }
}

// A circle that a pose shares is looked at once, from where most of it lies ahead.
TEST(Maneuvers, ShareCirclesWithPosesThatTurnOnThemEarlier) {
  const World world = catalog_world("clutter/star/n100/m10/f30");
  const Vehicle vehicle;
  const QuerySet queries = make_reference_queries(world);
  const double radius = vehicle.min_turning_radius();
  const Footprint body = vehicle.footprint(0.5 * vehicle.safety_margin());
  std::size_t shared = 0;
  for (const PlanRequest& request : catalog_queries("clutter/star/n100/m10/f30", 6, 1))
    for (const Direction direction : {Direction::kFromStart, Direction::kToGoal}) {
      const bool forwards = direction == Direction::kFromStart;
      ManeuverSearch search;
      const auto attachments = search.find(forwards ? request.start : request.goal, direction,
                                           {vehicle, radius, *queries.sweep}, {.most = 60});
      for (const Attachment& attachment : attachments) {
        if (!attachment.shared) continue;
        ++shared;
        const Side side = *attachment.shared;
        const TurnCircle circle = turn_circle(attachment.pose, radius, side);
        const HeadingSet free = queries.sweep->free_headings({circle.center, radius, side, body});
        EXPECT_TRUE(std::ranges::any_of(attachments, [&](const Attachment& other) {
          const Vec2 center = turn_circle(other.pose, radius, side).center;
          const double turn = forwards ? turn_between(other.pose.heading, attachment.pose.heading, side)
                                       : turn_between(attachment.pose.heading, other.pose.heading, side);
          return other.shared != side && (center - circle.center).norm() < 1e-9 &&
                 turn <= free.reach(other.pose.heading, forwards ? side : opposite(side)) + 1e-9;
        }));
      }
    }
  EXPECT_GT(shared, 50u);
}

// Poses that face away from their way, with room to turn beside them.
TEST(Maneuvers, MakePathsFaster) {
  const std::string name = "clutter/star/n100/m10/f15";
  const World world = catalog_world(name);
  const Planner planner(world, Vehicle());
  const Planner without(world, Vehicle(), {.maneuver_poses = 0});
  const auto queries = catalog_queries(name, 40, 1);
  for (const std::size_t q : {1, 2, 3, 11, 35, 39}) {
    const PlanResult result = planner.plan(queries[q]);
    const PlanResult plain = without.plan(queries[q]);
    ASSERT_TRUE(result.solved() && plain.solved());
    test::expect_valid(planner, result);
    EXPECT_LE(result.travel_time, plain.travel_time);
    if (q > 10) {
      EXPECT_LT(result.travel_time, 0.95 * plain.travel_time) << q;
    }
  }
}

TEST(Maneuvers, AreFurtherApartWhereSparse) {
  const World world = catalog_world("corridor/v300/s1");
  const Vehicle vehicle;
  const QuerySet queries = make_reference_queries(world);
  const auto count_near = [&](Spread spread) {
    ManeuverSearch search;
    const auto found = search.find({5.0, 2.5, 0.0}, Direction::kFromStart,
                                   {vehicle, vehicle.min_turning_radius(), *queries.sweep}, {400, spread});
    return std::count_if(found.begin(), found.end(), [](const Attachment& t) { return length_of(t.connection) < 3.0; });
  };
  EXPECT_GT(count_near(Spread::kSparse), 10);
  EXPECT_LT(2 * count_near(Spread::kSparse), count_near(Spread::kDense));
}

// The corner of the nose that swings outwards meets a wall ahead before the turn is whole.
TEST(Maneuvers, EndATurnWhereAnObstacleDoes) {
  const Vehicle vehicle;
  const double wall = vehicle.footprint().front + 0.2;
  const World world({{{{wall, -50}, {wall + 1, -50}, {wall + 1, 50}, {wall, 50}}, {}}});
  const Pose pose{0.0, 0.0, 0.0};
  const QuerySet queries = make_reference_queries(world);
  ManeuverSearch search;
  const auto found =
      search.find(pose, Direction::kFromStart, {vehicle, vehicle.min_turning_radius(), *queries.sweep}, {.most = 50});
  bool partial = false;
  for (const Attachment& attachment : found)
    for (const PathSegment& segment : attachment.connection)
      partial |= segment.curvature > 0.0 && segment.length * segment.curvature < 0.39;
  EXPECT_TRUE(partial);
}

}  // namespace
}  // namespace arcway::internal

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/catalog.h"
#include "arcway/planner.h"
#include "tests/support/boxes.h"
#include "tests/support/plans.h"

// Plans through places where the circles on the bisectors of vertices collide.
namespace arcway::internal {
namespace {

PlanResult plan(const World& world, const PlanRequest& request, bool gap_circles = true,
                GraphMode mode = GraphMode::kEager) {
  const Planner planner(world, Vehicle(), {.graph_mode = mode, .gap_circles = gap_circles});
  PlanResult result = planner.plan(request, {.tree_poses = 0});
  if (result.solved()) test::expect_valid(planner, result);
  return result;
}

void expect_same(const PlanResult& a, const PlanResult& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.travel_time, b.travel_time);
  ASSERT_EQ(a.segments.size(), b.segments.size());
  for (std::size_t i = 0; i < a.segments.size(); ++i) {
    const PathSegment &s = a.segments[i].segment, &t = b.segments[i].segment;
    EXPECT_TRUE(s.start.x == t.start.x && s.start.y == t.start.y && s.start.heading == t.start.heading);
    EXPECT_TRUE(s.length == t.length && s.curvature == t.curvature);
  }
}

// Two rooms of 10 m by 20 m with doors of a width in the walls between them, at these heights.
struct Rooms {
  World world;
  PlanRequest request;
};
Rooms rooms(double width, double thickness, const std::vector<double>& doors) {
  std::vector<Polygon> walls;
  double x = 10.0;
  for (const double y : doors) {
    walls.push_back(test::box(x, 0, x + thickness, y));
    walls.push_back(test::box(x, y + width, x + thickness, 20));
    x += thickness + 8.0;
  }
  return {World(walls, Ring{{0, 0}, {x + 2, 0}, {x + 2, 20}, {0, 20}}),
          {.start = {4, 4, 0.5 * kPi}, .goal = {x - 3.0, 16, -0.5 * kPi}}};
}

TEST(NarrowPlaces, LeadThroughADoorAsWideAsTheRobotForwards) {
  for (const double width : {0.803, 0.85, 1.0})
    for (const double thickness : {0.5, 1.0, 4.0}) {
      const auto [world, request] = rooms(width, thickness, {10.0});
      if (width < 1.0 && thickness >= 1.0) {
        EXPECT_FALSE(plan(world, request, false).solved()) << width << " " << thickness;
      }
      const PlanResult result = plan(world, request);
      EXPECT_TRUE(result.solved()) << width << " " << thickness << " " << result.reason;
      expect_same(plan(world, request, true, GraphMode::kLazy), result);
    }
}

TEST(NarrowPlaces, DoNotLeadThroughADoorThatIsNoWider) {
  for (const double width : {0.5, 0.8, 0.8005}) {
    const auto [world, request] = rooms(width, 1.0, {10.0});
    EXPECT_EQ(plan(world, request).status, PlanStatus::kNoPassage) << width;
  }
  const auto [world, request] = rooms(0.801, 1.0, {10.0});  // contact of the body with half of the margin
  EXPECT_FALSE(plan(world, request).solved());
}

TEST(NarrowPlaces, LeadThroughARowOfDoors) {
  const auto [world, request] = rooms(0.9, 1.0, {5.0, 14.0, 6.0, 12.0});
  EXPECT_FALSE(plan(world, request, false).solved());
  const PlanResult result = plan(world, request);
  ASSERT_TRUE(result.solved()) << result.reason;
  EXPECT_LT(result.travel_time, 1.5 * result.lower_bound);
  expect_same(plan(world, request, true, GraphMode::kLazy), result);
}

TEST(NarrowPlaces, LeadThroughDoorsOfRotatedWalls) {
  const auto rotate = [](const Vec2& p, double angle) {
    return Vec2(std::cos(angle) * p.x() - std::sin(angle) * p.y(), std::sin(angle) * p.x() + std::cos(angle) * p.y());
  };
  for (const double angle : {0.3, 1.1, 2.5}) {
    const auto [upright, request] = rooms(0.85, 1.0, {10.0});
    std::vector<Polygon> walls;
    for (const auto& [bottom, top] : {std::pair(0.0, 10.0), std::pair(10.85, 20.0)}) {
      Ring ring;
      for (const Vec2& p : test::box(10, bottom, 11, top).outer) ring.push_back(rotate(p, angle));
      walls.push_back({ring, {}});
    }
    Ring bounds;
    for (const Vec2& p : test::box(0, -1, 21, 21).outer) bounds.push_back(rotate(p, angle));
    const auto moved = [&](const Pose& pose) {
      const Vec2 p = rotate(pose.position(), angle);
      return Pose{p.x(), p.y(), pose.heading + angle};
    };
    // The walls leave gaps of 1 m to the bounds at their ends.
    const PlanResult result =
        plan(World(walls, bounds), {.start = moved({4, 10, 0.4 * kPi}), .goal = moved({17, 11, -0.4 * kPi})});
    EXPECT_TRUE(result.solved()) << angle << " " << result.reason;
  }
}

// A corridor of one width that turns to the right into one of another.
TEST(NarrowPlaces, LeadRoundACornerAsNarrowAsItCanBe) {
  const Vehicle vehicle;
  const SweptAnnulus swept =
      swept_annulus(vehicle.footprint(vehicle.safety_margin()), Side::kLeft, vehicle.min_turning_radius());
  for (const double angle : {0.25 * kPi, 0.3 * kPi, 0.4 * kPi}) {
    // Of the smallest widths for a circle whose center lies in this direction from the corner.
    const double first = swept.outer - swept.inner * std::cos(angle) + 1e-3;
    const double second = swept.outer - swept.inner * std::sin(angle) + 1e-3;
    const World world({test::box(first, -20, 20, 0)}, Ring{{0, -20.5}, {20.5, -20.5}, {20.5, second}, {0, second}});
    const PlanRequest request{.start = {0.5 * first, -15, 0.5 * kPi}, .goal = {15, 0.5 * second, 0.0}};
    // By circles alone: without maneuvers.
    const Planner with(world, Vehicle(), {.maneuver_poses = 0});
    const Planner without(world, Vehicle(), {.maneuver_poses = 0, .gap_circles = false});
    const PlanResult result = with.plan(request);
    EXPECT_EQ(without.plan(request).solved(), angle == 0.25 * kPi);
    if (result.solved()) test::expect_valid(with, result);
    EXPECT_TRUE(result.solved()) << angle << " " << result.reason;
    expect_same(plan(world, request, true, GraphMode::kLazy), plan(world, request));
  }
}

TEST(NarrowPlaces, AreReachedByManeuvers) {
  // Beside the door, too near for an arc from the start and one onto the door's line.
  Rooms near = rooms(0.9, 1.0, {10.0});
  const Planner planner(near.world, Vehicle()), single(near.world, Vehicle(), {.maneuver_poses = 0});
  for (const Pose& start : {Pose{8.0, 9.0, 0.5 * kPi}, Pose{8.0, 8.0, 0.25 * kPi}, Pose{7.5, 12.0, -0.5 * kPi}}) {
    near.request.start = start;
    EXPECT_FALSE(single.plan(near.request).solved());
    const PlanResult result = planner.plan(near.request);
    ASSERT_TRUE(result.solved()) << result.reason;
    test::expect_valid(planner, result);
  }
}

TEST(NarrowPlaces, TakeObstaclesThatTouchOrOverlap) {
  // Walls in pieces that share edges, overlap or touch at corners; one door of 0.85 m.
  const World world(
      {test::box(10, 0, 11, 4), test::box(10, 4, 11, 7), test::box(10.2, 6, 11, 10), test::box(10, 7, 10.5, 10),
       test::box(10, 10.85, 11, 15), test::box(10.5, 14, 11.5, 20), test::box(9, 15, 10, 20)},
      Ring{{0, 0}, {21, 0}, {21, 20}, {0, 20}});
  const PlanRequest request{.start = {4, 4, 0.5 * kPi}, .goal = {17, 16, -0.5 * kPi}};
  const PlanResult result = plan(world, request);
  EXPECT_TRUE(result.solved()) << result.reason;
  expect_same(plan(world, request, true, GraphMode::kLazy), result);
}

TEST(NarrowPlaces, GiveTheSamePlanWhateverWasAskedBefore) {
  const std::string name = "clutter/star/n60/m10/f45/s2";
  const World world = catalog_world(name);
  const std::vector<PlanRequest> requests = catalog_queries(name, 12, 1);
  const Planner forwards(world, Vehicle()), backwards(world, Vehicle());
  const Planner parallel(world, Vehicle(), backend_of(world, make_reference_queries(world), ThreadExecutor(3)));
  std::vector<PlanResult> results, threaded(requests.size());
  for (const PlanRequest& request : requests) {
    results.push_back(forwards.plan(request));
    if (results.back().solved()) test::expect_valid(forwards, results.back());
  }
  for (std::size_t i = requests.size(); i-- > 0;) expect_same(backwards.plan(requests[i]), results[i]);
  ThreadExecutor(3).for_ranges(requests.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) threaded[i] = parallel.plan(requests[i]);
  });
  for (std::size_t i = 0; i < requests.size(); ++i) expect_same(threaded[i], results[i]);
}

TEST(NarrowPlaces, LoseNoPathOfClutters) {
  std::size_t faster = 0;
  for (const char* name : {"clutter/convex/n60/m10/f45/s1", "clutter/star/n60/m10/f45/s1"}) {
    const World world = catalog_world(name);
    const Planner with(world, Vehicle()), without(world, Vehicle(), {.gap_circles = false});
    for (const PlanRequest& request : catalog_queries(name, 10, 1)) {
      const PlanResult before = without.plan(request), now = with.plan(request);
      if (now.solved()) test::expect_valid(with, now);
      EXPECT_TRUE(now.solved() || !before.solved());
      faster += now.solved() && (!before.solved() || now.travel_time < before.travel_time) ? 1 : 0;
    }
  }
  EXPECT_GT(faster, 0u);
}

}  // namespace
}  // namespace arcway::internal

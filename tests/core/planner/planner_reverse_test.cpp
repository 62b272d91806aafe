// Plans that may drive backwards.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <tuple>

#include "arcway/angle.h"
#include "arcway/datasets/catalog.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/datasets/read_map.h"
#include "arcway/datasets/robot.h"
#include "arcway/planner.h"
#include "core/motion/speed_profile.h"
#include "tests/support/boxes.h"
#include "tests/support/narrow_queries.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

using test::expect_valid;

using test::box;

double cost_of(const PlanResult& result, double cusp_cost) {
  return result.travel_time + cusp_cost * static_cast<double>(cusps_of(result.path()));
}

// A lane with a dead end. It is wide enough for the paper's robot to drive in, and too narrow to turn.
World dead_end() {
  return World({box(0.0, 1.0, 8.0, 2.0), box(0.0, -2.0, 8.0, -1.0), box(8.0, -2.0, 9.0, 2.0)},
               box(-20.0, -20.0, 20.0, 20.0).outer);
}

TEST(PlannerReverse, BacksOutOfADeadEndAndIntoIt) {
  const Planner planner(dead_end(), Vehicle{});
  const Pose inside{6.0, 0.0, 0.0}, outside{-10.0, 5.0, 0.0};
  for (const auto& [start, goal] : {std::pair{inside, outside}, std::pair{outside, inside}}) {
    const PlanResult plan = planner.plan({.start = start, .goal = goal, .reverse = true});
    ASSERT_TRUE(plan.solved()) << plan.reason;
    expect_valid(planner, plan, true);
  }
  const PlanResult forwards = planner.plan({.start = inside, .goal = outside});
  EXPECT_EQ(forwards.status, PlanStatus::kStartBlocked);
  EXPECT_NE(forwards.reason.find("forward motion"), std::string::npos);
}

TEST(PlannerReverse, IsNeverDearerThanForwards) {
  const World world = random_world({.obstacles = 40, .vertices = 6, .fill = 0.25, .seed = 9});
  const Vehicle vehicle;
  const QuerySet queries = make_reference_queries(world);
  const Planner planner(world, vehicle);
  int faster = 0;
  for (PlanRequest request : random_queries(world, queries, vehicle, {.count = 12, .min_distance = 0.3})) {
    const PlanResult forwards = planner.plan(request);
    request.reverse = true;
    for (const double cusp_cost : {0.0, 0.5, 1000.0}) {
      request.cusp_cost = cusp_cost;
      const PlanResult both = planner.plan(request);
      if (forwards.solved()) {
        ASSERT_TRUE(both.solved());
        EXPECT_LE(cost_of(both, cusp_cost), forwards.travel_time);
      }
      if (!both.solved()) continue;
      expect_valid(planner, both, true);
      EXPECT_EQ(both.travel_time, speed_profile(both.path(), vehicle).total_time);
      faster += cusp_cost == 0.0 && both.travel_time < forwards.travel_time ? 1 : 0;
    }
  }
  EXPECT_GT(faster, 0);
}

// A car stops 3 cm from a wall. It gets there forwards, by small angles that only trees find, and sooner than with a
// change of gear.
TEST(PlannerReverse, IsNotDearerThanForwardsBesideAWall) {
  const World world({box(-90.0, -6.0, 135.0, -0.936)}, box(-90.0, -6.0, 135.0, 36.0).outer);
  const Planner planner(world, Vehicle(test::car()));
  PlanRequest request{.start = {0, 3.826, 0}, .goal = {26.33, 0, 0}};
  const PlanResult forwards = planner.plan(request);
  ASSERT_TRUE(forwards.solved());
  request.reverse = true;
  for (const double cusp_cost : {0.0, 10.0, 100.0}) {
    request.cusp_cost = cusp_cost;
    const PlanResult both = planner.plan(request);
    ASSERT_TRUE(both.solved());
    expect_valid(planner, both, true);
    EXPECT_LE(cost_of(both, cusp_cost), 1.05 * forwards.travel_time) << cusp_cost;
  }
}

// A goal beside the start on an open field: gear changes lead there, or a loop driven forwards.
TEST(PlannerReverse, TheCostOfAChangeOfGearChangesThePlan) {
  const Planner planner(World({box(50.0, 50.0, 51.0, 51.0)}), Vehicle{});
  PlanRequest request{.start = {0, 0, 0}, .goal = {0, 2, 0}, .reverse = true};
  const PlanResult cheap = planner.plan(request);
  ASSERT_TRUE(cheap.solved());
  EXPECT_GT(cusps_of(cheap.path()), 0u);
  request.cusp_cost = 10.0;
  const PlanResult dear = planner.plan(request);
  ASSERT_TRUE(dear.solved());
  EXPECT_EQ(cusps_of(dear.path()), 0u);
  EXPECT_GT(dear.travel_time, cheap.travel_time);
}

TEST(PlannerReverse, ChangesGearNoMoreOftenThanAllowed) {
  const Planner field(World({box(50.0, 50.0, 51.0, 51.0)}), Vehicle{});
  PlanRequest request{.start = {0, 0, 0}, .goal = {0, 2, 0}, .reverse = true};
  double before = std::numeric_limits<double>::infinity();
  for (const std::uint32_t most : {0u, 1u, 2u, 100u}) {
    request.max_gear_changes = most;
    const PlanResult plan = field.plan(request);
    ASSERT_TRUE(plan.solved()) << most << plan.reason;
    expect_valid(field, plan, true);
    EXPECT_LE(cusps_of(plan.path()), most);
    EXPECT_LE(plan.travel_time, before);
    before = plan.travel_time;
  }
  // Out of a dead end.
  const Planner lane(dead_end(), Vehicle{});
  request = {.start = {6.0, 0.0, 0.0}, .goal = {-10.0, 5.0, 0.0}, .reverse = true, .max_gear_changes = 1};
  const PlanResult out = lane.plan(request);
  EXPECT_TRUE(out.solved());
  EXPECT_LE(cusps_of(out.path()), 1u);
  // A lane with two dead ends.
  const Planner closed(World({box(-1.0, 1.0, 8.0, 2.0), box(-1.0, -2.0, 8.0, -1.0)}, box(-1.0, -2.0, 8.0, 2.0).outer),
                       Vehicle{});
  request = {.start = {2.0, 0.0, 0.0}, .goal = {2.0, 0.15, 0.0}, .reverse = true, .max_gear_changes = 0};
  const PlanResult none = closed.plan(request);
  EXPECT_FALSE(none.solved());
  EXPECT_EQ(none.certainty, Certainty::kGaveUp);
  EXPECT_NE(none.reason.find("at most 0 changes of gear"), std::string::npos) << none.reason;
  request.max_gear_changes = std::nullopt;
  EXPECT_TRUE(closed.plan(request).solved());
}

// A lane that the vehicle leaves backwards, with a speed limit of its own for reversing.
TEST(PlannerReverse, KeepsToTheSpeedLimitForReversing) {
  VehicleParameters parameters{.max_acceleration = 2.0};
  const Pose inside{6.0, 0.0, 0.0}, outside{-10.0, 5.0, 0.0};
  double before = 0.0;
  for (const double speed : {12.0, 3.0, 1.0}) {
    parameters.max_reverse_speed = speed;
    const Planner planner(dead_end(), Vehicle(parameters));
    for (const auto& [start, goal] : {std::pair{inside, outside}, std::pair{outside, inside}}) {
      const PlanResult plan = planner.plan({.start = start, .goal = goal, .reverse = true});
      ASSERT_TRUE(plan.solved()) << plan.reason;
      expect_valid(planner, plan, true);
      if (start.x != inside.x) continue;
      EXPECT_GT(plan.travel_time, before);
      before = plan.travel_time;
      double fastest_back = 0.0;
      for (const TimedSegment& s : plan.segments)
        if (s.segment.gear == Gear::kReverse) fastest_back = std::max({fastest_back, s.speed_in, s.speed_out});
      EXPECT_LE(fastest_back, speed);
      EXPECT_GT(fastest_back, 0.0);
    }
  }
}

// A vehicle with its gears swapped, turned around at start and goal, drives as the vehicle itself does.
TEST(PlannerReverse, FasterBackwardsThanForwards) {
  const Vehicle forwards({.max_speed = 6.0, .max_reverse_speed = 2.0, .max_acceleration = 2.0});
  const Vehicle backwards = forwards.with_gears_swapped();
  const World world({box(8.0, -3.0, 9.0, 3.0)});
  const Pose start{0, 0, 0}, goal{20, 0, 0};
  const Pose turned_start{0, 0, kPi}, turned_goal{20, 0, kPi};
  for (const auto& [vehicle, from, to] :
       {std::tuple{forwards, start, goal}, std::tuple{backwards, turned_start, turned_goal}}) {
    const Planner planner(world, vehicle);
    const PlanResult plan = planner.plan({.start = from, .goal = to, .reverse = true});
    ASSERT_TRUE(plan.solved()) << plan.reason;
    expect_valid(planner, plan, true);
    EXPECT_LT(plan.travel_time, 1.3 * plan.lower_bound);
  }
}

// The goal is a bay of a car park. Only gear changes further away from it save time over the drive forwards.
TEST(PlannerReverse, FindsPlacesToTurnAwayFromTheEnds) {
  const Vehicle car(read_robot_file(std::filesystem::path(ARCWAY_SOURCE_DIR) / "tests/data/robots/parking.json"));
  const MapFile map = catalog_map("parking");
  const Planner planner(to_world(map, "parking"), car);
  const PlanResult forwards = planner.plan({.start = *map.start, .goal = *map.goal});
  const PlanResult both = planner.plan({.start = *map.start, .goal = *map.goal, .reverse = true});
  ASSERT_TRUE(forwards.solved() && both.solved());
  expect_valid(planner, both, true);
  EXPECT_EQ(cusps_of(both.path()), 1u);
  EXPECT_LT(both.travel_time, 0.95 * forwards.travel_time);
}

TEST(PlannerReverse, StartAtTheGoalTakesNoTime) {
  const PlanResult plan =
      Planner(World({}), Vehicle{}).plan({.start = {1, 2, 0.5}, .goal = {1, 2, 0.5}, .reverse = true});
  EXPECT_TRUE(plan.solved());
  EXPECT_TRUE(plan.segments.empty());
}

TEST(PlannerReverse, RefusesCostsThatAreNone) {
  const Planner planner(World({}), Vehicle{});
  for (const double cost : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((void)planner.plan({.start = {}, .goal = {5, 0, 0}, .reverse = true, .cusp_cost = cost}),
                 std::invalid_argument);
  }
}

TEST(PlannerReverse, EndsInTime) {
  // A body in a cell a little larger than itself: the search would go on for long.
  const Planner planner(World({box(-0.3, 0.6, 1.7, 0.7), box(-0.3, -0.7, 1.7, -0.6), box(-0.5, -0.7, -0.3, 0.7),
                               box(1.7, -0.7, 1.9, 0.7)}),
                        Vehicle{});
  const PlanRequest request{.start = {0, 0, 0}, .goal = {10, 0, 0}, .reverse = true};
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(planner.plan(request, {.stop = stop.get_token()}).status, PlanStatus::kCanceled);
  EXPECT_EQ(planner.plan(request, {.time = 0.0}).status, PlanStatus::kTimeLimit);
  const PlanResult all = planner.plan(request);
  EXPECT_FALSE(all.solved());
  EXPECT_FALSE(all.interrupted);
  EXPECT_FALSE(all.reason.empty());
}

}  // namespace
}  // namespace arcway::internal

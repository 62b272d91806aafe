#include "arcway/tour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "arcway/angle.h"
#include "arcway/backend.h"
#include "arcway/datasets/catalog.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/random_queries.h"
#include "core/collision/path_cost.h"
#include "tests/support/boxes.h"
#include "tests/support/plans.h"
#include "tests/support/random_inputs.h"
#include "tests/support/stopping_queries.h"

namespace arcway::internal {
namespace {

using test::expect_valid;

Place place_of(const Pose& pose) { return {pose.position(), pose.heading}; }

// The least cost of all tours over one place with any of the headings that are tried there.
double least_cost(const Planner& planner, const TourRequest& request) {
  const Vec2 middle = request.waypoints[0].position, ahead = middle - request.start.position();
  const Pose goal{request.goals[0].position.x(), request.goals[0].position.y(), *request.goals[0].heading};
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 24; ++k) {
    const Pose there{middle.x(), middle.y(), wrap_signed(std::atan2(ahead.y(), ahead.x()) + kTwoPi * k / 24)};
    const auto leg = [&](const Pose& from, const Pose& to) {
      return planner.plan({.start = from, .goal = to, .reverse = request.reverse, .cusp_cost = request.cusp_cost});
    };
    const PlanResult one = leg(request.start, there), two = leg(there, goal);
    if (!one.solved() || !two.solved()) continue;
    Path way = one.path();
    for (const TimedSegment& s : two.segments) way.push_back(s.segment);
    least = std::min(least, path_cost(way, planner.vehicle(), {.cusp_cost = request.cusp_cost}));
  }
  return least;
}

const PlannerOptions kShortRefinement{.refinement = {.max_trials = 300}};

class TourInClutter : public testing::Test {
 protected:
  World world_ = random_world({.obstacles = 30, .vertices = 6, .fill = 0.2, .seed = 12});
  Planner planner_{world_, Vehicle{}, kShortRefinement};
  std::vector<PlanRequest> queries_ =
      random_queries(world_, make_reference_queries(world_), Vehicle{}, {.count = 24, .min_distance = 0.3});
};

TEST_F(TourInClutter, ToOnePoseIsThePlan) {
  for (const PlanRequest& query : queries_) {
    const PlanResult plan = planner_.plan(query);
    const Tour tour = plan_tour(planner_, {.start = query.start, .goals = {place_of(query.goal)}});
    ASSERT_EQ(tour.plan.status, plan.status);
    EXPECT_EQ(tour.plan.reason, plan.reason);
    EXPECT_EQ(tour.plan.travel_time, plan.travel_time);
    EXPECT_EQ(tour.plan.lower_bound, plan.lower_bound);
    EXPECT_EQ(tour.plan.min_clearance, plan.min_clearance);
    ASSERT_EQ(tour.plan.segments.size(), plan.segments.size());
    for (std::size_t i = 0; i < plan.segments.size(); ++i) {
      EXPECT_EQ(tour.plan.segments[i].segment.length, plan.segments[i].segment.length);
      EXPECT_EQ(tour.plan.segments[i].speed_in, plan.segments[i].speed_in);
    }
  }
}

TEST_F(TourInClutter, ToSeveralGoalsIsTheFastestOfThePlans) {
  int solved = 0;
  for (std::size_t first = 0; first + 4 <= queries_.size(); first += 4) {
    const Pose start = queries_[first].start;
    std::vector<Place> goals;
    double fastest = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      goals.push_back(place_of(queries_[first + i].goal));
      const PlanResult plan = planner_.plan({.start = start, .goal = queries_[first + i].goal});
      if (!plan.solved() || plan.travel_time >= fastest) continue;
      fastest = plan.travel_time;
      nearest = i;
    }
    const Tour tour = plan_tour(planner_, {.start = start, .goals = goals});
    ASSERT_EQ(tour.plan.solved(), std::isfinite(fastest));
    if (!tour.plan.solved()) continue;
    ++solved;
    EXPECT_EQ(tour.plan.travel_time, fastest);
    EXPECT_EQ(tour.goal, nearest);
    EXPECT_EQ(tour.plan.goal.heading, queries_[first + nearest].goal.heading);
    expect_valid(planner_, tour.plan);
  }
  EXPECT_GE(solved, 4);
}

TEST_F(TourInClutter, AnOpenHeadingIsNoSlowerThanAnyHeading) {
  test::RandomInputs random(2);
  int solved = 0;
  for (std::size_t i = 0; i < 10; ++i) {
    const Pose start = queries_[i].start, goal = queries_[i].goal;
    const Tour tour = plan_tour(planner_, {.start = start, .goals = {{goal.position()}}});
    if (tour.plan.solved()) {
      ++solved;
      expect_valid(planner_, tour.plan);
      EXPECT_EQ(tour.plan.goal.x, goal.x);
      EXPECT_EQ(tour.plan.goal.y, goal.y);
    }
    for (int k = 0; k < 12; ++k) {
      const double heading = random.uniform(-kPi, kPi);
      const PlanResult plan = planner_.plan({.start = start, .goal = {goal.x, goal.y, heading}});
      if (!plan.solved()) continue;
      ASSERT_TRUE(tour.plan.solved());
      EXPECT_LE(tour.plan.travel_time, plan.travel_time * (1.0 + 1e-4)) << i << " heading " << heading;
    }
  }
  EXPECT_GE(solved, 6);
}

TEST_F(TourInClutter, PassesAllPlacesWithoutAStop) {
  int passed = 0;
  for (std::size_t i = 0; i + 2 < queries_.size(); i += 3) {
    const Pose start = queries_[i].start, middle = queries_[i + 1].start, goal = queries_[i + 2].goal;
    const PlanResult one = planner_.plan({.start = start, .goal = middle});
    const PlanResult two = planner_.plan({.start = middle, .goal = goal});
    if (!one.solved() || !two.solved()) continue;
    const Tour fixed =
        plan_tour(planner_, {.start = start, .waypoints = {place_of(middle)}, .goals = {place_of(goal)}});
    ASSERT_TRUE(fixed.plan.solved());
    expect_valid(planner_, fixed.plan);
    EXPECT_NEAR(fixed.plan.length, one.length + two.length, 1e-9);
    EXPECT_LT(fixed.plan.travel_time, one.travel_time + two.travel_time);
    ASSERT_EQ(fixed.passed, std::vector<std::size_t>{one.segments.size()});
    const TimedSegment& next = fixed.plan.segments[fixed.passed[0]];
    EXPECT_NEAR((next.segment.start.position() - middle.position()).norm(), 0.0, 1e-9);
    EXPECT_NEAR(wrap_signed(next.segment.start.heading - middle.heading), 0.0, 1e-9);
    EXPECT_GT(next.speed_in, 0.0);
    ++passed;

    const Tour open =
        plan_tour(planner_, {.start = start, .waypoints = {{middle.position()}}, .goals = {place_of(goal)}});
    ASSERT_TRUE(open.plan.solved());
    expect_valid(planner_, open.plan);
    EXPECT_NEAR((open.plan.segments[open.passed[0]].segment.start.position() - middle.position()).norm(), 0.0, 1e-9);
    EXPECT_LT(open.plan.length, 1.2 * fixed.plan.length);
  }
  EXPECT_GE(passed, 2);
}

TEST_F(TourInClutter, TakesThePlaceOnTheWayWithTheBestOfAllHeadings) {
  const Planner planner(world_, Vehicle({.max_acceleration = 1.0}));  // to stop would take it seconds
  int passed = 0;
  for (std::size_t i = 0; i + 2 < queries_.size(); i += 6) {
    const TourRequest request{.start = queries_[i].start,
                              .waypoints = {{queries_[i + 1].start.position()}},
                              .goals = {place_of(queries_[i + 2].goal)}};
    const Tour tour = plan_tour(planner, request);
    const double least = least_cost(planner, request);
    ASSERT_EQ(tour.plan.solved(), std::isfinite(least));
    if (!tour.plan.solved()) continue;
    expect_valid(planner, tour.plan);
    EXPECT_NEAR(tour.plan.travel_time, least, 1e-9);
    ++passed;
  }
  EXPECT_GE(passed, 2);
}

TEST(Tour, CountsChangesOfGearAtAPlaceOnTheWay) {
  const Planner planner(World({}), Vehicle{}, kShortRefinement);
  for (const double cusp_cost : {0.3, 3.0}) {
    const TourRequest request{.start = {0, 0, 0},
                              .waypoints = {{Vec2(6, 0)}},
                              .goals = {place_of({1, 1, 0})},
                              .reverse = true,
                              .cusp_cost = cusp_cost};
    const Tour tour = plan_tour(planner, request);
    ASSERT_TRUE(tour.plan.solved());
    expect_valid(planner, tour.plan, true);
    const double cost = tour.plan.travel_time + cusp_cost * static_cast<double>(cusps_of(tour.plan.path()));
    EXPECT_NEAR(cost, least_cost(planner, request), 1e-9) << cusp_cost;
  }
}

TEST_F(TourInClutter, DrivesBackwardsIfAllowed) {
  const Pose start = queries_[0].start;
  Pose behind = PathSegment{start, 0.5, 0.0, Gear::kReverse}.end();
  TourRequest request{.start = start, .goals = {place_of(behind)}};
  const Tour forwards = plan_tour(planner_, request);
  request.reverse = true;
  const Tour both = plan_tour(planner_, request);
  ASSERT_TRUE(both.plan.solved());
  expect_valid(planner_, both.plan, true);
  if (forwards.plan.solved()) {
    EXPECT_LT(both.plan.travel_time, forwards.plan.travel_time);
  }
}

TEST(Tour, SaysWhereOnAllOfItsWayItIsNearest) {
  const Planner planner(World({test::box(30, 0.5, 31, 1.5)}), Vehicle{});
  const Tour tour = plan_tour(planner, {.start = {0, 0, 0}, .waypoints = {{{20, 0}, 0.0}}, .goals = {{{40, 0}, 0.0}}});
  ASSERT_EQ(tour.plan.segments.size(), 2u);
  EXPECT_NEAR(tour.plan.min_clearance, 0.1, 1e-9);
  EXPECT_EQ(tour.plan.clearance_index, 1u);
}

TEST(Tour, IsNotFasterThanItsBoundByAVehicleThatIsFasterBackwards) {
  VehicleParameters parameters;
  parameters.max_speed = 3.0;
  parameters.max_reverse_speed = 9.0;
  const Planner planner(World({}), Vehicle(parameters));
  const Tour tour = plan_tour(planner, {.start = {0, 0, 0}, .goals = {{{-40, 0}}, {{-50, 0}}}, .reverse = true});
  ASSERT_TRUE(tour.plan.solved());
  EXPECT_LE(tour.plan.lower_bound, tour.plan.travel_time);
  EXPECT_GT(tour.plan.lower_bound, 0.99 * tour.plan.travel_time);
}

// The reference point of a body that lies beside it may end in an obstacle.
TEST(Tour, IsNotFasterThanItsBoundToAGoalInAnObstacle) {
  const World world({test::box(10, -1, 11, 1)});
  const Planner planner(world, Vehicle({.length = 1.0, .width = 0.6, .wheelbase = 2.0, .steering = Steering::kRear}));
  const Tour tour = plan_tour(planner, {.start = {0, 0, 0}, .goals = {{{10.2, 0}}}});
  ASSERT_TRUE(tour.plan.solved()) << tour.plan.reason;
  expect_valid(planner, tour.plan);
  EXPECT_GT(tour.plan.lower_bound, 0.5);
}

TEST(Tour, SaysWhichLegHasNoPath) {
  const World world({{{Vec2(10, 10), Vec2(12, 10), Vec2(12, 12), Vec2(10, 12)}, {}}});
  const Planner planner(world, Vehicle{});
  const Place free{{20, 0}, 0.0}, inside{{11, 11}, 0.0};
  const Tour tour = plan_tour(planner, {.start = {0, 0, 0}, .waypoints = {free, inside}, .goals = {{{40, 0}, 0.0}}});
  EXPECT_EQ(tour.plan.status, PlanStatus::kWaypointInCollision);
  EXPECT_EQ(tour.plan.reason.rfind("leg 2 of 3: the waypoint (11, 11, 0): ", 0), 0u) << tour.plan.reason;
  EXPECT_EQ(tour.plan.start.position(), Vec2(0, 0));
  EXPECT_EQ(tour.plan.goal.position(), Vec2(40, 0));
  EXPECT_TRUE(tour.plan.segments.empty());
  // One goal of several is enough.
  const Tour other = plan_tour(planner, {.start = {0, 0, 0}, .goals = {inside, free}});
  EXPECT_TRUE(other.plan.solved());
  EXPECT_EQ(other.goal, 1u);
  EXPECT_EQ(other.plan.lower_bound, plan_tour(planner, {.start = {0, 0, 0}, .goals = {free, free}}).plan.lower_bound);
  EXPECT_EQ(plan_tour(planner, {.start = {0, 0, 0}, .goals = {inside}}).plan.status, PlanStatus::kGoalInCollision);
  // No heading is free inside.
  const Tour none = plan_tour(planner, {.start = {0, 0, 0}, .goals = {{{11, 11}}}});
  EXPECT_FALSE(none.plan.solved());
  EXPECT_EQ(none.plan.reason.rfind("the goal (11, 11): ", 0), 0u) << none.plan.reason;
  const Tour by = plan_tour(planner, {.start = {0, 0, 0}, .waypoints = {{{11, 11}}}, .goals = {free}});
  EXPECT_EQ(by.plan.reason.rfind("leg 1 of 2: the waypoint (11, 11): ", 0), 0u) << by.plan.reason;
}

TEST(Tour, CallsWhatIsWrongWithAPlaceOnTheWayByItsName) {
  // A bay closed at its left end.
  const World world({test::box(20, 20, 26, 21), test::box(20, 22, 26, 23), test::box(20, 21, 20.5, 22)},
                    Ring{{-10, -10}, {60, -10}, {60, 60}, {-10, 60}});
  const Planner planner(world, Vehicle{});
  const Place outside{{99, 0}, 0.0}, free{{40, 0}, 0.0};
  const auto by = [&](const Place& place) {
    return plan_tour(planner, {.start = {0, 0, 0}, .waypoints = {place}, .goals = {free}}).plan;
  };
  EXPECT_EQ(by(outside).status, PlanStatus::kWaypointOutsideBounds);
  EXPECT_EQ(plan_tour(planner, {.start = {0, 0, 0}, .goals = {outside}}).plan.status, PlanStatus::kGoalOutsideBounds);
  const PlanResult into = by({{23, 21.5}, kPi}), out_of = by({{23, 21.5}, 0.0});
  EXPECT_EQ(into.status, PlanStatus::kWaypointBlocked) << into.reason;
  EXPECT_EQ(into.reason.rfind("leg 2 of 2: the waypoint", 0), 0u) << into.reason;
  EXPECT_EQ(out_of.status, PlanStatus::kWaypointBlocked) << out_of.reason;
  EXPECT_EQ(out_of.reason.rfind("leg 1 of 2: the waypoint", 0), 0u) << out_of.reason;

  const auto refusal = [&](const TourRequest& request) -> std::string {
    try {
      plan_tour(planner, request);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "no error";
  };
  const Place far{{1e10, 0}};
  EXPECT_EQ(refusal({.start = {0, 0, 0}, .waypoints = {far}, .goals = {free}}).rfind("waypoint (1e+10, 0, 0): ", 0),
            0u);
  EXPECT_EQ(refusal({.start = {0, 0, 0}, .goals = {free, far}}).rfind("goal 2 (1e+10, 0, 0): ", 0), 0u);
}

// A start and goal between obstacles that only trees join, and another goal in an obstacle, so that there is a choice.
TEST(Tour, GrowsTreesWhereNoPoseOfAChoiceIsReachedWithout) {
  std::size_t needed = 0;
  for (const char* name : {"driven/hugging/r6/g1/c50/s1", "driven/hugging/r8/g1/c50/s1", "driven/rooms/r6/g1/c50/s2"}) {
    SCOPED_TRACE(name);
    const DrivenWorld driven = *catalog_driven_world(name);
    const World world = to_world(driven.map, name);
    const Planner planner(world, Vehicle(driven.robot));
    const Pose start = *driven.map.start, goal = *driven.map.goal;
    if (planner.plan({.start = start, .goal = goal}, {.tree_poses = 0}).solved()) continue;
    ++needed;
    const TourRequest request{.start = start, .goals = {{world.vertex(0), 0.0}, place_of(goal)}};
    EXPECT_FALSE(plan_tour(planner, request, {.tree_poses = 0}).plan.solved());
    const PlanLimits limits{.tree_poses = 20'000};
    const Tour tour = plan_tour(planner, request, limits);
    ASSERT_TRUE(tour.plan.solved()) << tour.plan.reason;
    EXPECT_EQ(tour.goal, 1u);
    EXPECT_GT(tour.plan.statistics.tree_poses, 0u);
    EXPECT_LE(tour.plan.statistics.tree_poses, 5u * limits.tree_poses / 2);  // twice, and those of one leg more
    expect_valid(planner, tour.plan);
  }
  EXPECT_GT(needed, 0u);
}

TEST(Tour, KeepsItsLimits) {
  const Planner planner(World({}), Vehicle{});
  EXPECT_THROW(plan_tour(planner, {.start = {}, .goals = {}}), std::invalid_argument);
  EXPECT_THROW(plan_tour(planner, {.start = {1e200, 0, 0}, .goals = {{{5, 5}, 0.0}}}), std::invalid_argument);
  EXPECT_THROW(plan_tour(planner, {.start = {}, .waypoints = {{{1e200, 0}}}, .goals = {{{5, 5}}}}),
               std::invalid_argument);
  std::stop_source stop;
  stop.request_stop();
  const Tour tour = plan_tour(planner, {.start = {}, .goals = {{{5, 5}}}}, {.stop = stop.get_token()});
  EXPECT_EQ(tour.plan.status, PlanStatus::kCanceled);
  EXPECT_TRUE(tour.plan.interrupted);
  const Tour late = plan_tour(planner, {.start = {}, .waypoints = {{{1, 5}}}, .goals = {{{5, 5}}}}, {.time = 0.0});
  EXPECT_EQ(late.plan.status, PlanStatus::kTimeLimit);
  EXPECT_EQ(late.plan.reason, "leg 1 of 2: no path was found within the time limit of 0 s");
}

// The best tour takes hundreds of plans, the first one some.
TEST_F(TourInClutter, IsTheFirstOneFoundWhereItIsStopped) {
  test::StoppingQueries stopping(world_);
  const Planner planner(world_, Vehicle{}, backend_of(world_, stopping.queries()), kShortRefinement);
  const TourRequest request{.start = queries_[1].start,
                            .waypoints = {{queries_[2].goal.position()}, {queries_[3].goal.position()}},
                            .goals = {{queries_[4].goal.position()}}};
  const Tour best = plan_tour(planner, request);  // fills the caches of the graph
  ASSERT_TRUE(best.plan.solved()) << best.plan.reason;
  const Tour whole = plan_tour(planner, request, {.stop = stopping.stop_at(test::StoppingQueries::kNever)});
  EXPECT_FALSE(whole.plan.interrupted);
  EXPECT_EQ(whole.plan.travel_time, best.plan.travel_time);
  const Tour first = plan_tour(planner, request, {.stop = stopping.stop_at(stopping.asked() / 4)});
  ASSERT_TRUE(first.plan.solved()) << first.plan.reason;
  EXPECT_TRUE(first.plan.interrupted);
  EXPECT_GE(first.plan.travel_time, best.plan.travel_time);
  EXPECT_LT(first.plan.statistics.nodes_pushed, best.plan.statistics.nodes_pushed);
  EXPECT_EQ(first.passed.size(), request.waypoints.size());
  expect_valid(planner, first.plan);
}

TEST(Tour, SaysThatItWasCanceledWhateverIsWrongWithAnotherGoal) {
  const Planner planner(World({test::box(5, 5, 8, 8)}), Vehicle{});
  std::stop_source stop;
  stop.request_stop();
  const Tour tour =
      plan_tour(planner, {.start = {}, .goals = {{{6, 6}, 0.0}, {{20, 0}, 0.0}}}, {.stop = stop.get_token()});
  EXPECT_EQ(tour.plan.status, PlanStatus::kCanceled);
  EXPECT_TRUE(tour.plan.interrupted);
}

TEST(Tour, AnOpenHeadingInAnEmptyWorldGoesStraight) {
  VehicleParameters parameters;
  parameters.turn_speed = ConstantTurnSpeed{parameters.max_speed};
  const Vehicle vehicle(parameters);
  const Planner planner(World({}), vehicle);
  const Tour ahead = plan_tour(planner, {.start = {0, 0, 0}, .goals = {{{9, 0}}}});
  EXPECT_NEAR(ahead.plan.length, 9.0, 1e-9);
  // A turn and a line: the shortest way to a point outside of the circle.
  const double r = vehicle.min_turning_radius();
  const Vec2 goal(3.0, 7.0);
  const Vec2 d = goal - Vec2(0.0, r);
  const double line = std::sqrt(d.squaredNorm() - r * r);
  const double turn = wrap_positive(std::atan2(d.y(), d.x()) + std::atan2(r, line));
  const Tour aside = plan_tour(planner, {.start = {0, 0, 0}, .goals = {{goal}}});
  EXPECT_NEAR(aside.plan.length, r * turn + line, 1e-6);
}

}  // namespace
}  // namespace arcway::internal

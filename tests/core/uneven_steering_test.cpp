// Vehicles that turn more tightly, or reach further, to one side than to the other.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/planner.h"
#include "arcway/tour.h"
#include "tests/support/mirrored.h"
#include "tests/support/plans.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

Vehicle mirrored(const Vehicle& vehicle) {
  VehicleParameters parameters = vehicle.parameters();
  parameters.min_turning_radius = vehicle.min_turning_radius(Side::kRight);
  parameters.min_turning_radius_right = vehicle.min_turning_radius(Side::kLeft);
  for (Ring& part : parameters.footprint) part = test::mirrored(std::move(part));
  parameters.footprint_origin = test::mirrored(parameters.footprint_origin);
  return Vehicle(parameters);
}

// What a planner searches alone, without what goes by grids or by the order of trials.
const PlannerOptions kGraphAlone{.maneuver_poses = 0, .gap_circles = false, .refinement = {.max_trials = 0}};

constexpr double kFarRight = 500.0;  // radius of turns to the right of a vehicle that turns to the left alone [m]

Vehicle one_radius(double left, double right) {
  return Vehicle({.turn_speed = ConstantTurnSpeed{3.0},
                  .max_acceleration = 4.0,
                  .min_turning_radius = left,
                  .min_turning_radius_right = right});
}
Vehicle several_radii(double left, double right) {
  return Vehicle({.turn_speed = LateralAccelerationLimit{2.0},
                  .max_acceleration = 2.0,
                  .min_turning_radius = left,
                  .min_turning_radius_right = right});
}

// The vehicle with another body, about F.
Vehicle with_body(const Vehicle& vehicle, std::vector<Ring> parts) {
  VehicleParameters parameters = vehicle.parameters();
  parameters.footprint = std::move(parts);
  return Vehicle(parameters);
}

std::vector<Ring> rectangle_beside() { return {{{-0.1, -0.2}, {1.4, -0.2}, {1.4, 0.6}, {-0.1, 0.6}}}; }
std::vector<Ring> cut_on_one_side() { return {{{-0.1, -0.4}, {0.9, -0.4}, {1.4, 0.1}, {1.2, 0.4}, {-0.1, 0.4}}}; }
std::vector<Ring> with_an_arm() {
  return {{{-0.1, -0.4}, {1.4, -0.4}, {1.4, 0.4}, {-0.1, 0.4}}, {{0.2, -0.7}, {0.5, -0.7}, {0.5, -0.45}, {0.2, -0.45}}};
}

std::vector<Polygon> cluttered(ClutterKind kind) {
  return generate_clutter({.kind = kind, .obstacles = 30, .vertices = 7, .fill = 0.25, .seed = 5}).obstacles;
}

class Queries {
 public:
  explicit Queries(const World& world) : box_(world.box()) {}
  PlanRequest next(bool reverse) { return {.start = pose(), .goal = pose(), .reverse = reverse}; }
  Pose pose() {
    const Vec2 size = box_.max - box_.min;
    const Vec2 p = box_.min + Vec2(random_.uniform(0, 1) * size.x(), random_.uniform(0, 1) * size.y());
    return {p.x(), p.y(), random_.uniform(-kPi, kPi)};
  }

 private:
  test::RandomInputs random_{4};
  Box box_;
};

PlanRequest mirrored(const PlanRequest& request) {
  PlanRequest other = request;
  other.start = test::mirrored(request.start);
  other.goal = test::mirrored(request.goal);
  return other;
}

// Plans a vehicle's queries, and those of its mirror image in a mirror. Returns how many are solved.
int expect_mirrored_plans(const Vehicle& vehicle, const PlannerOptions& options, bool reverse, double tolerance) {
  int solved = 0;
  for (const ClutterKind kind : {ClutterKind::kConvex, ClutterKind::kStar}) {
    const World world(cluttered(kind)), other_world(test::mirrored(cluttered(kind)));
    const Planner planner(world, vehicle, options), other(other_world, mirrored(vehicle), options);
    Queries queries(world);
    for (int i = 0; i < 12; ++i) {
      SCOPED_TRACE("query " + std::to_string(i));
      const PlanRequest request = queries.next(reverse);
      const PlanResult plan = planner.plan(request), image = other.plan(mirrored(request));
      EXPECT_EQ(plan.status, image.status);
      EXPECT_NEAR(plan.lower_bound, image.lower_bound, 1e-9 * (1.0 + plan.lower_bound));
      if (!plan.solved() || !image.solved()) continue;
      ++solved;
      EXPECT_NEAR(plan.travel_time, image.travel_time, tolerance * plan.travel_time);
      test::expect_valid(planner, plan, reverse);
      test::expect_valid(other, image, reverse);
    }
  }
  return solved;
}

TEST(UnevenSteering, GraphsInAMirrorHavePlansAsFast) {
  for (const Vehicle& vehicle :
       {one_radius(1.3, 2.4), one_radius(3.0, 1.0), several_radii(2.0, 1.2), one_radius(1.3, kFarRight)})
    EXPECT_GT(expect_mirrored_plans(vehicle, kGraphAlone, false, 1e-9), 4) << to_string(vehicle);
}

TEST(UnevenSteering, RefinedPlansInAMirrorAreAsFast) {
  // Refinement tries left before right, and ends a little elsewhere. So do trees, which then go other ways.
  const PlannerOptions no_trees{.leave_out = {"other ways by trees"}};
  EXPECT_GT(expect_mirrored_plans(one_radius(1.3, 2.4), no_trees, false, 1e-4), 4);
  EXPECT_GT(expect_mirrored_plans(one_radius(kFarRight, 1.3), no_trees, false, 1e-4), 4);
  // The optimizer's iterations and the order of trials make a difference where radii are free, or gears change.
  EXPECT_GT(expect_mirrored_plans(several_radii(1.2, 2.0), {}, false, 0.1), 4);
  EXPECT_GT(expect_mirrored_plans(one_radius(1.0, 1.8), {}, true, 0.1), 4);
}

TEST(UnevenBody, GraphsInAMirrorHavePlansAsFast) {
  for (const std::vector<Ring>& body : {rectangle_beside(), cut_on_one_side(), with_an_arm()})
    for (const Vehicle& vehicle : {one_radius(1.3, 1.3), one_radius(1.2, 2.0), several_radii(1.3, 1.3)})
      EXPECT_GT(expect_mirrored_plans(with_body(vehicle, body), kGraphAlone, false, 1e-9), 2) << to_string(vehicle);
}

TEST(UnevenBody, RefinedPlansInAMirrorAreAsFast) {
  for (const std::vector<Ring>& body : {rectangle_beside(), cut_on_one_side(), with_an_arm()}) {
    // Refinement tries left before right, and ends in other optima.
    EXPECT_GT(expect_mirrored_plans(with_body(one_radius(1.3, 1.3), body), {}, false, 0.1), 2);
    EXPECT_GT(expect_mirrored_plans(with_body(one_radius(1.0, 1.3), body), {}, true, 0.1), 2);
  }
}

// Tours over a waypoint with a heading to the nearer of two goals.
TEST(UnevenBody, ToursInAMirrorAreAsFast) {
  const Vehicle vehicle = with_body(one_radius(1.2, 2.0), with_an_arm());
  const World world(cluttered(ClutterKind::kConvex)), other_world(test::mirrored(cluttered(ClutterKind::kConvex)));
  const Planner planner(world, vehicle, kGraphAlone), other(other_world, mirrored(vehicle), kGraphAlone);
  const auto place_of = [](const Pose& pose) { return Place{pose.position(), pose.heading}; };
  Queries queries(world);
  int solved = 0;
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE("tour " + std::to_string(i));
    const Pose poses[] = {queries.pose(), queries.pose(), queries.pose(), queries.pose()};
    TourRequest request{.start = poses[0], .goals = {}}, image{.start = test::mirrored(poses[0]), .goals = {}};
    request.waypoints = {place_of(poses[1])};
    image.waypoints = {place_of(test::mirrored(poses[1]))};
    for (const Pose& goal : {poses[2], poses[3]}) {
      request.goals.push_back(place_of(goal));
      image.goals.push_back(place_of(test::mirrored(goal)));
    }
    const Tour tour = plan_tour(planner, request), mirrored_tour = plan_tour(other, image);
    EXPECT_EQ(tour.plan.status, mirrored_tour.plan.status);
    if (!tour.plan.solved() || !mirrored_tour.plan.solved()) continue;
    ++solved;
    EXPECT_EQ(tour.goal, mirrored_tour.goal);
    EXPECT_EQ(tour.passed, mirrored_tour.passed);
    EXPECT_NEAR(tour.plan.travel_time, mirrored_tour.plan.travel_time, 1e-9 * tour.plan.travel_time);
  }
  EXPECT_GT(solved, 4);
}

// A corridor with a bend to one side, of which the body takes nearly all: only one side's radius leads through.
TEST(UnevenSteering, GoesWhereTheTighterSideLeads) {
  const double width = 2.5, far = 12.0;
  const std::vector<Polygon> walls{Polygon::rectangle({width, width}, {far, far}),
                                   Polygon::rectangle({-1.0, -1.0}, {0.0, far}),
                                   Polygon::rectangle({0.0, -1.0}, {far, 0.0})};
  const World left_bend(walls), right_bend(test::mirrored(walls));
  const PlanRequest there{.start = {far - 2.0, 0.5 * width, kPi}, .goal = {0.5 * width, far - 2.0, 0.5 * kPi}};
  for (const double other : {3.0, 30.0}) {
    const PlanResult right = Planner(left_bend, one_radius(other, 1.0)).plan(there);
    EXPECT_TRUE(right.solved()) << right.reason;
    EXPECT_TRUE(Planner(right_bend, one_radius(1.0, other)).plan(mirrored(there)).solved());
  }
  EXPECT_FALSE(Planner(left_bend, one_radius(1.0, 30.0)).plan(there).solved());
  EXPECT_FALSE(Planner(right_bend, one_radius(30.0, 1.0)).plan(mirrored(there)).solved());
}

TEST(UnevenSteering, PlansTheSameOnGraphsOfAllKinds) {
  const std::vector<Polygon> obstacles = cluttered(ClutterKind::kStar);
  const World world(obstacles), fewer(std::vector<Polygon>(obstacles.begin(), obstacles.end() - 2));
  const ThreadExecutor threads(3);
  for (const Vehicle& vehicle : {one_radius(1.3, 2.4), several_radii(2.0, 1.2)}) {
    const Planner eager(world, vehicle), lazy(world, vehicle, {.graph_mode = GraphMode::kLazy});
    const Planner many(world, vehicle, backend_of(world, make_reference_queries(world), threads));
    const Planner restored = Planner::restored(world, vehicle, reference_backend(world), eager.prepared_graph());
    const Planner before(fewer, vehicle);
    const Planner changed = Planner::changed(before, WorldChange(fewer, world, {}), reference_backend(world),
                                             {.radii = eager.options().radii});
    Queries queries(world);
    int solved = 0;
    for (int i = 0; i < 12; ++i) {
      const PlanRequest request = queries.next(false);
      const PlanResult expected = eager.plan(request);
      solved += expected.solved();
      for (const Planner* planner : {&many, &restored, &changed, &lazy}) {
        const PlanResult plan = planner->plan(request);
        EXPECT_EQ(plan.status, expected.status);
        EXPECT_EQ(plan.travel_time, expected.travel_time);
      }
    }
    EXPECT_GT(solved, 2);
  }
}

}  // namespace
}  // namespace arcway::internal

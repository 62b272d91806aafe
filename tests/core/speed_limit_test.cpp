#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/map_file.h"
#include "arcway/planner.h"
#include "arcway/tour.h"
#include "arcway/validation.h"
#include "arcway/zone_stay.h"
#include "tests/support/boxes.h"
#include "tests/support/depth_in.h"
#include "tests/support/mirrored.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

using test::box;
using test::depth_in;

constexpr double kStep = 1e-3;  // between samples [m]

double cap_at(const World& world, const Vec2& p, double border) {
  double cap = INFINITY;
  for (const Zone& zone : world.zones())
    if (const auto* limit = std::get_if<SpeedLimit>(&zone.rule))
      if (depth_in(zone.area, p) > border) cap = std::min(cap, limit->max_speed);
  return cap;
}

// The limit at each millimeter of a path, in zones and outside.
struct SampledLimits {
  std::vector<double> limits, steps;
};
SampledLimits sampled_limits(const PlanResult& plan) {
  const Vehicle& vehicle = plan.scene->vehicle;
  SampledLimits sampled;
  for (const TimedSegment& timed : plan.segments) {
    const PathSegment& s = timed.segment;
    const double radius = 1.0 / std::abs(s.curvature);
    const bool ahead = s.gear == Gear::kForward;
    const double own = s.is_line() ? (ahead ? vehicle.max_speed() : vehicle.max_reverse_speed())
                                   : (ahead ? vehicle.turn_speed(radius) : vehicle.reverse_turn_speed(radius));
    const int n = std::max(1, static_cast<int>(std::ceil(s.length / kStep)));
    for (int i = 0; i < n; ++i) {
      const Vec2 p = s.at((i + 0.5) * s.length / n).position();
      sampled.limits.push_back(std::min(own, cap_at(plan.scene->world, p, 0.0)));
      sampled.steps.push_back(s.length / n);
    }
  }
  return sampled;
}

// The least time along the path of a plan without cusps, by passes over a phase plane of millimeters.
double phase_plane_time(const PlanResult& plan) {
  const auto [limits, steps] = sampled_limits(plan);
  const double a = plan.scene->vehicle.max_acceleration();
  std::vector<double> speeds(steps.size() + 1, 0.0);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double next = i + 1 < steps.size() ? std::min(limits[i], limits[i + 1]) : 0.0;
    speeds[i + 1] = std::min(next, std::sqrt(speeds[i] * speeds[i] + 2.0 * a * steps[i]));
  }
  double time = 0.0;
  for (std::size_t i = steps.size(); i-- > 0;) {
    speeds[i] = std::min(speeds[i], std::sqrt(speeds[i + 1] * speeds[i + 1] + 2.0 * a * steps[i]));
    time += 2.0 * steps[i] / (speeds[i] + speeds[i + 1]);
  }
  return time;
}

// Every millimeter obeys the limits, and the validator agrees.
void expect_obeyed(const PlanResult& plan) {
  ASSERT_TRUE(plan.solved()) << plan.reason;
  const Trajectory motion = plan.trajectory();
  for (double s = 0.0; s < motion.length(); s += kStep) {
    const TrajectoryState state = motion.at_distance(s);
    ASSERT_LE(state.speed, cap_at(plan.scene->world, state.pose.position(), 1e-6) * (1.0 + 2e-3)) << "after " << s;
  }
  const ValidationReport report =
      validate(plan.scene->world, plan.scene->vehicle, plan.start, plan.goal, plan.timed_path());
  EXPECT_TRUE(report.valid()) << to_string(report);
}

Vehicle slow_vehicle() {
  VehicleParameters parameters;
  parameters.max_acceleration = 2.0;
  parameters.max_speed = 6.0;
  parameters.turn_speed = LateralAccelerationLimit{2.0};
  return Vehicle(parameters);
}

World open_world() { return World({box(0, 30, 4, 34)}, box(-20, -40, 80, 40).outer); }

PlanResult plan_straight(std::vector<Zone> zones) {
  return Planner(open_world().with_zones(std::move(zones)), slow_vehicle()).plan({0, 0, 0}, {60, 0, 0});
}

TEST(SpeedLimit, ZonesInARowTouchOverlapAndNest) {
  const Polygon wide = box(20, -35, 30, 35);
  for (const std::vector<Zone>& zones :
       std::vector<std::vector<Zone>>{{{wide, SpeedLimit{2.0}}},
                                      {{wide, SpeedLimit{2.0}}, {box(30, -35, 40, 35), SpeedLimit{1.0}}},
                                      {{wide, SpeedLimit{2.0}}, {box(25, -35, 45, 35), SpeedLimit{3.0}}},
                                      {{box(10, -38, 50, 38), SpeedLimit{4.0}}, {wide, SpeedLimit{1.5}}},
                                      {{box(-15, -35, 5, 35), SpeedLimit{1.0}}},
                                      {{box(55, -35, 75, 35), SpeedLimit{1.0}}},
                                      {{box(-15, -39, 75, 39), SpeedLimit{1.0}}}}) {
    const PlanResult plan = plan_straight(zones);
    expect_obeyed(plan);
    EXPECT_NEAR(plan.travel_time, phase_plane_time(plan), 2e-3 * plan.travel_time);
    EXPECT_GT(plan.travel_time, plan_straight({}).travel_time + 0.5);
    EXPECT_GE(plan.travel_time, plan.lower_bound);
  }
}

TEST(SpeedLimit, ALimitAboveTheVehiclesChangesNothing) {
  const PlanResult plan = plan_straight({{box(20, -35, 30, 35), SpeedLimit{9.0}}});
  EXPECT_EQ(plan.travel_time, plan_straight({}).travel_time);
  const PlanResult elsewhere = plan_straight({{box(20, 30, 30, 35), SpeedLimit{0.1}}});
  EXPECT_EQ(elsewhere.travel_time, plan_straight({}).travel_time);
  EXPECT_EQ(elsewhere.segments.size(), plan_straight({}).segments.size());
}

TEST(SpeedLimit, StaysSayHowLongAPlanIsInAZone) {
  const PlanResult plan = plan_straight({{box(20, -35, 30, 35), SpeedLimit{2.0}, "school"},
                                         {box(0, 20, 1, 21), SpeedLimit{1.0}},
                                         {box(25, -35, 27, 35), KeepOut{{"truck"}}}});
  const std::vector<ZoneStay> stays = zone_stays(plan);
  ASSERT_EQ(stays.size(), 2u);
  EXPECT_EQ(stays[0].zone, 0u);
  EXPECT_NEAR(stays[0].length, 10.0, 1e-6);
  EXPECT_NEAR(stays[0].time, 5.0, 1e-6);
  EXPECT_EQ(stays[1].zone, 2u);
  EXPECT_NEAR(stays[1].time, 1.0, 1e-6);
  EXPECT_TRUE(zone_stays(plan_straight({})).empty());
}

// An obstacle to pass on either side, with a zone on the shorter one.
World forked(double limit) {
  return World({box(20, -10, 40, 14)}, box(-20, -40, 80, 40).outer)
      .with_zones({{box(20, -40, 40, -10), SpeedLimit{limit}, "lane"}});
}

TEST(SpeedLimit, ASlowZoneIsAvoidedWhereTheDetourPays) {
  const Planner slow(forked(0.5), slow_vehicle()), fast(forked(5.0), slow_vehicle());
  const PlanResult around = slow.plan({0, 0, 0}, {60, 0, 0}), through = fast.plan({0, 0, 0}, {60, 0, 0});
  expect_obeyed(around);
  expect_obeyed(through);
  EXPECT_TRUE(zone_stays(around).empty());
  EXPECT_FALSE(zone_stays(through).empty());
  EXPECT_LT(through.travel_time, around.travel_time);
}

// Nothing but a zone: the graph has no circles around it.
PlanResult plan_in_the_open(double limit, std::vector<std::string> left_out = {}) {
  PlannerOptions options;
  options.leave_out = std::move(left_out);
  const World world = World({}, box(-20, -40, 80, 40).outer)
                          .with_zones({{Polygon::rectangle({30, 1}, 20, 20, 0.1), SpeedLimit{limit}, "yard"}});
  return Planner(world, slow_vehicle(), options).plan({0, 0, 0}, {60, 0, 0});
}

TEST(SpeedLimit, ASlowZoneIsAvoidedInTheOpenWhereTheDetourPays) {
  const PlanResult around = plan_in_the_open(0.5), through = plan_in_the_open(5.8);
  expect_obeyed(around);
  expect_obeyed(through);
  EXPECT_TRUE(zone_stays(around).empty());
  EXPECT_FALSE(zone_stays(through).empty());
  EXPECT_LT(through.travel_time, around.travel_time);
  EXPECT_LT(around.travel_time, 0.5 * plan_in_the_open(0.5, {"routes through zones"}).travel_time);
}

TEST(SpeedLimit, ALimitAtAnEndRaisesTheLowerBound) {
  const PlanResult plan = plan_straight({{box(-15, -12, 12, 12), SpeedLimit{1.0}}});
  EXPECT_GT(plan.lower_bound, plan_straight({}).lower_bound + 5.0);
  EXPECT_LT(plan.optimality_gap(), 1e-6);
}

TEST(SpeedLimit, HoldsAmongObstaclesForAllVehicles) {
  test::RandomInputs random(9);
  int solved = 0, slowed = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const World open = random_world({.obstacles = 12, .vertices = 5, .fill = 0.1, .seed = seed});
    std::vector<Zone> zones;
    for (int i = 0; i < 14; ++i)
      zones.push_back({Polygon::regular(random.point(0.0, open.box().max.x()), random.uniform(3.0, 9.0), 6),
                       SpeedLimit{random.uniform(0.3, 4.0)}});
    const Planner planner(open.with_zones(zones), seed % 2 == 0 ? slow_vehicle() : Vehicle{});
    for (int i = 0; i < 4; ++i) {
      const double side = open.box().max.x();
      const Pose start{random.uniform(0, side), random.uniform(0, side), random.uniform(-3, 3)};
      const Pose goal{random.uniform(0, side), random.uniform(0, side), random.uniform(-3, 3)};
      const PlanResult plan = planner.plan({.start = start, .goal = goal, .reverse = seed > 4});
      if (!plan.solved()) continue;
      ++solved;
      expect_obeyed(plan);
      slowed += zone_stays(plan).empty() ? 0 : 1;
      EXPECT_GE(plan.travel_time, plan.lower_bound);
      if (cusps_of(plan.path()) > 0) continue;
      EXPECT_NEAR(plan.travel_time, phase_plane_time(plan), 5e-3 * plan.travel_time) << seed << ", " << i;
    }
  }
  EXPECT_GT(solved, 8);
  EXPECT_GT(slowed, 4);
}

TEST(SpeedLimit, MirroredWorldsHaveMirroredPlans) {
  const World world = random_world({.obstacles = 12, .vertices = 5, .fill = 0.2, .seed = 3});
  std::vector<Zone> zones{{box(5, 5, 15, 40), SpeedLimit{1.0}}, {box(12, 0, 30, 20), SpeedLimit{2.0}}};
  const MapFile map = to_map_file(world);
  std::vector<Zone> mirrored_zones = zones;
  for (Zone& zone : mirrored_zones) zone.area = test::mirrored(zone.area);
  const World mirror = World(test::mirrored(map.obstacles)).with_zones(mirrored_zones);
  const Pose start{1, 1, 0.5}, goal{35, 30, 0.2};
  // Which way parts take that are planned again, and how few arcs a path is driven in, depends on rounding here: by
  // 0.1 % of the time.
  const PlannerOptions options{.leave_out = {"parts planned again quickly", "refinement at length", "fewer arcs"}};
  const PlanResult plan = Planner(World(map.obstacles).with_zones(zones), slow_vehicle(), options).plan(start, goal);
  const PlanResult other = Planner(mirror, slow_vehicle(), options).plan(test::mirrored(start), test::mirrored(goal));
  ASSERT_TRUE(plan.solved());
  EXPECT_NEAR(plan.travel_time, other.travel_time, 1e-6 * plan.travel_time);
}

TEST(SpeedLimit, TheValidatorNamesTheZoneThatAPlanIsTooFastIn) {
  const PlanResult plan = plan_straight({});
  const World zoned = open_world().with_zones({{box(20, -35, 30, 35), SpeedLimit{2.0}, "school"}});
  const ValidationReport report = validate(zoned, slow_vehicle(), plan.start, plan.goal, plan.timed_path());
  ASSERT_EQ(report.issues.size(), 1u);
  EXPECT_EQ(report.issues[0].violation, Violation::kSpeedLimit);
  EXPECT_NE(report.issues[0].message.find("m/s in speed_limit zone \"school\", the limit 2"), std::string::npos)
      << report.issues[0].message;
}

TEST(SpeedLimit, ToursObeyIt) {
  const World world = open_world().with_zones({{box(20, -35, 30, 35), SpeedLimit{2.0}}});
  const Planner planner(world, slow_vehicle());
  const Tour tour = plan_tour(planner, {.start = {0, 0, 0},
                                        .waypoints = {{.position = {25, 5}, .heading = 0.0}},
                                        .goals = {{.position = {60, 0}, .heading = 0.0}}});
  expect_obeyed(tour.plan);
}

// A tour times segments again that a plan has cut at the zone's border.
TEST(SpeedLimit, ToursHaveSpeedsThatTheirTrajectoriesTake) {
  const World world =
      World({box(20, 0, 22, 10)}, box(0, 0, 60, 20).outer).with_zones({{box(33, 0, 39, 20), SpeedLimit{0.7}}});
  const Tour tour =
      plan_tour(Planner(world, Vehicle{}), {.start = {5, 5, 0}, .goals = {{.position = {50, 5}, .heading = 0.0}}});
  ASSERT_TRUE(tour.plan.solved());
  EXPECT_NEAR(tour.plan.trajectory().duration(), tour.plan.travel_time, 1e-9);
}

TEST(SpeedLimit, AMovingEndAboveTheLimitOfItsZoneIsSaid) {
  const World world = open_world().with_zones({{box(-10, -5, 5, 5), SpeedLimit{2.0}, "yard"}});
  const Planner planner(world, slow_vehicle());
  const PlanResult plan = planner.plan({.start = {0, 0, 0}, .goal = {60, 0, 0}, .start_speed = 3.0});
  EXPECT_EQ(plan.status, PlanStatus::kStartBlocked);
  EXPECT_EQ(plan.certainty, Certainty::kProved);
  EXPECT_EQ(plan.reason, "the start speed 3 m/s is above the limit of 2 m/s of speed_limit zone \"yard\" there");
  const PlanResult end = planner.plan({.start = {60, 0, kPi}, .goal = {0, 0, kPi}, .goal_speed = 3.0});
  EXPECT_EQ(end.status, PlanStatus::kGoalBlocked);
  expect_obeyed(Planner(world, slow_vehicle()).plan({60, 0, kPi}, {0, 0, kPi}));
}

}  // namespace
}  // namespace arcway::internal

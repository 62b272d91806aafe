// Plans, and their checks, in maps with one-way zones.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "arcway/alternatives.h"
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
#include "tests/support/plans.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal::one_way_test {
namespace {

using test::box;

constexpr double kStep = 1e-3;     // between samples [m]
constexpr double kBorder = 2e-6;   // what the planner leaves out beside it, and rounding [m]
constexpr double kHeading = 1e-8;  // likewise [rad]

// The first place along a path that is against a zone, among samples a millimeter apart; negative if there is none.
double place_against(std::span<const Zone> zones, const Path& path) {
  double driven = 0.0;
  for (const PathSegment& s : path) {
    const int n = std::max(1, static_cast<int>(std::ceil(s.length / kStep)));
    for (int i = 0; i < n; ++i) {
      const Pose pose = s.at((i + 0.5) * s.length / n);
      const double direction = s.gear == Gear::kForward ? pose.heading : pose.heading + kPi;
      for (const Zone& zone : zones)
        if (const auto* rule = std::get_if<OneWay>(&zone.rule))
          if (std::abs(std::remainder(direction - rule->heading, kTwoPi)) > rule->tolerance + kHeading &&
              test::depth_in(zone.area, pose.position()) > kBorder)
            return driven + (i + 0.5) * s.length / n;
    }
    driven += s.length;
  }
  return -1.0;
}

void expect_obeyed(const PlanResult& plan) {
  ASSERT_TRUE(plan.solved()) << plan.reason;
  EXPECT_EQ(place_against(plan.scene->world.zones(), plan.path()), -1.0);
  EXPECT_EQ(place_against(plan.scene->world.zones(), plan.first_path), -1.0);
  const ValidationReport report =
      validate(plan.scene->world, plan.scene->vehicle, plan.start, plan.goal, plan.timed_path(),
               {.start_speed = plan.start_speed, .goal_speed = plan.goal_speed});
  EXPECT_TRUE(report.valid()) << to_string(report);
}

Vehicle small_car() {
  VehicleParameters parameters;
  parameters.max_acceleration = 2.0;
  parameters.max_speed = 6.0;
  parameters.turn_speed = LateralAccelerationLimit{2.0};
  return Vehicle(parameters);
}

// A block to pass on either side, the lower one being shorter, with a zone there.
World forked(const OneWay& rule) {
  return World({box(20, -10, 40, 14)}, box(-20, -40, 80, 40).outer).with_zones({{box(20, -40, 40, -10), rule, "lane"}});
}
const Pose kLeft{0, 0, 0}, kRight{60, 0, 0};

double highest(const Path& path) {
  double y = -INFINITY;
  for (const Vec2& p : polyline(path, 0.5)) y = std::max(y, p.y());
  return y;
}

TEST(OneWay, ALaneIsDrivenInItsDirectionAndGoneRoundInTheOther) {
  const PlanResult there = Planner(forked({0.0, 0.6}), small_car()).plan(kLeft, kRight);
  const PlanResult free = Planner(forked({0.0, kPi}), small_car()).plan(kLeft, kRight);
  const PlanResult around = Planner(forked({kPi, 0.6}), small_car()).plan(kLeft, kRight);
  for (const PlanResult& plan : {there, free, around}) expect_obeyed(plan);
  EXPECT_LT(highest(there.path()), 5.0);
  EXPECT_GT(highest(around.path()), 14.0);
  EXPECT_NEAR(there.travel_time, free.travel_time, 1e-6);
  EXPECT_GT(around.travel_time, there.travel_time + 0.5);
  EXPECT_EQ(around.lower_bound, free.lower_bound);
}

// In reverse, the direction of motion counts.
TEST(OneWay, BothGearsObeyTheDirectionOfMotion) {
  const Pose left{0, 0, kPi}, right{60, 0, kPi};
  const auto plan = [&](double heading, const Pose& start, const Pose& goal) {
    return Planner(forked({heading, 0.8}), small_car()).plan({.start = start, .goal = goal, .reverse = true});
  };
  const PlanResult along = plan(0.0, left, right), against = plan(kPi, left, right), back = plan(kPi, right, left);
  for (const PlanResult& result : {along, against, back}) expect_obeyed(result);
  EXPECT_LT(highest(along.path()), 10.0);
  EXPECT_GT(highest(against.path()), 14.0);
  EXPECT_LT(highest(back.path()), 10.0);
  const auto reversed_length = [](const PlanResult& result) {
    double length = 0.0;
    for (const TimedSegment& s : result.segments) length += s.segment.gear == Gear::kReverse ? s.segment.length : 0.0;
    return length;
  };
  EXPECT_GT(reversed_length(along), 10.0);
}

// A corridor that is too narrow to turn in.
World corridor(const OneWay& rule) {
  return World({box(-20, 1, 40, 3), box(-20, -3, 40, -1)}, box(-25, -20, 60, 20).outer)
      .with_zones({{box(0, -1, 20, 1), rule, "aisle"}});
}

TEST(OneWay, AnAisleIsLeftInReverseWhereOnlyThatIsAllowed) {
  const PlanRequest forwards{.start = {10, 0, 0}, .goal = {35, 0, 0}};
  const PlanRequest backwards{.start = {15, 0, 0}, .goal = {5, 0, 0}, .reverse = true};
  expect_obeyed(Planner(corridor({0.0, 0.3}), small_car()).plan(forwards));
  expect_obeyed(Planner(corridor({kPi, 0.3}), small_car()).plan(backwards));
  const PlanResult refused = Planner(corridor({kPi, 0.3}), small_car()).plan(forwards);
  EXPECT_EQ(refused.status, PlanStatus::kStartBlocked);
  EXPECT_EQ(refused.certainty, Certainty::kProved);
  EXPECT_EQ(refused.reason,
            "the start (10, 0, 0) is inside one_way zone \"aisle\", where directions of motion are within 0.3 rad of "
            "3.142 rad: no motion from it, driven forwards, has such a direction");
  PlanRequest in = forwards;
  std::swap(in.start, in.goal);
  const PlanResult goal = Planner(corridor({kPi, 0.3}), small_car()).plan(in);
  EXPECT_EQ(goal.status, PlanStatus::kGoalBlocked);
  EXPECT_NE(goal.reason.find("no motion to it, driven forwards"), std::string::npos) << goal.reason;
  const PlanResult aside =
      Planner(corridor({0.5 * kPi, 0.3}), small_car()).plan({.start = {10, 0, 0}, .goal = {35, 0, 0}, .reverse = true});
  EXPECT_EQ(aside.status, PlanStatus::kStartBlocked);
  EXPECT_NE(aside.reason.find("in either gear"), std::string::npos) << aside.reason;
  // A moving start decides the gear.
  PlanRequest moving = backwards;
  moving.start_speed = 1.0;
  EXPECT_EQ(Planner(corridor({kPi, 0.3}), small_car()).plan(moving).status, PlanStatus::kStartBlocked);
  moving.start_speed = -1.0;
  expect_obeyed(Planner(corridor({kPi, 0.3}), small_car()).plan(moving));
}

TEST(OneWay, NoMotionIsNeededFromAPoseToItself) {
  const PlanResult plan = Planner(corridor({0.5 * kPi, 0.3}), small_car()).plan({10, 0, 0}, {10, 0, 0});
  EXPECT_TRUE(plan.solved()) << plan.reason;
}

// Without obstacles, the graph has no circles to turn at.
TEST(OneWay, ZonesInTheOpenAreCrossedAsTheyAllowOrGoneRound) {
  const World field({}, box(0, 0, 60, 40).outer);
  const World across = field.with_zones({{box(25, 0, 30, 40), OneWay{0.5 * kPi, 0.5}, "road"}});
  const World around = field.with_zones({{box(20, 10, 40, 30), OneWay{kPi, 0.3}, "square"}});
  const World both = field.with_zones(
      {{box(15, 0, 20, 40), OneWay{0.5 * kPi, 0.5}, "up"}, {box(35, 0, 40, 40), OneWay{-0.5 * kPi, 0.5}, "down"}});
  const PlanLimits no_trees{.tree_poses = 0};
  for (const World& world : {across, around, both})
    for (const bool reverse : {false, true}) {
      const PlanRequest request{.start = {5, 20, 0}, .goal = {55, 20, 0}, .reverse = reverse};
      expect_obeyed(Planner(world, Vehicle()).plan(request, no_trees));
      expect_obeyed(Planner(world, small_car()).plan(request, no_trees));
      const Planner without(world, Vehicle(), {.leave_out = {"routes through one-way zones"}});
      EXPECT_FALSE(without.plan({request.start, request.goal}, no_trees).solved());
    }
}

// Whoever leaves through a ring of zones cannot come back in.
TEST(OneWay, ARingWithoutEntryIsNamedAndNotProved) {
  const double tolerance = 0.4;
  const World world = World({box(70, 10, 72, 12)}, box(-40, -40, 80, 40).outer)
                          .with_zones({{box(10, -14, 14, 14), OneWay{0.0, tolerance}, "east"},
                                       {box(-14, 10, 14, 14), OneWay{0.5 * kPi, tolerance}, "north"},
                                       {box(-14, -14, -10, 14), OneWay{kPi, tolerance}, "west"},
                                       {box(-14, -14, 14, -10), OneWay{-0.5 * kPi, tolerance}, "south"},
                                       {box(74, -30, 76, -28), OneWay{0.0, tolerance}, "far"}});
  const Planner planner(world, small_car());
  const Pose inside{0, 0, 0}, outside{50, 0, 0};
  expect_obeyed(planner.plan(inside, outside));
  for (const bool reverse : {false, true}) {
    const PlanResult plan = planner.plan({.start = outside, .goal = inside, .reverse = reverse}, {.tree_poses = 500});
    EXPECT_FALSE(plan.solved());
    EXPECT_EQ(plan.certainty, Certainty::kGaveUp) << plan.reason;
    EXPECT_NE(plan.reason.find("motions obeyed the driving directions of one_way zone \"east\", one_way zone "),
              std::string::npos)
        << plan.reason;
    EXPECT_NE(plan.reason.find("and 1 more"), std::string::npos) << plan.reason;
    EXPECT_EQ(plan.reason.find("\"far\""), std::string::npos) << plan.reason;
  }
}

TEST(OneWay, ProofsAreAboutObstaclesAndStay) {
  const World world = World({box(10, -20, 12, -0.3), box(10, 0.3, 12, 20)}, box(-20, -20, 40, 20).outer)
                          .with_zones({{box(14, -10, 30, 10), OneWay{kPi, 0.2}, "lane"}});
  const PlanResult plan = Planner(world, small_car()).plan({0, 0, 0}, {20, 12, 0});
  EXPECT_EQ(plan.status, PlanStatus::kNoPassage);
  EXPECT_EQ(plan.certainty, Certainty::kProved);
  EXPECT_EQ(plan.reason.find("lane"), std::string::npos) << plan.reason;
}

std::vector<Zone> random_zones(test::RandomInputs& random, double side, int count) {
  std::vector<Zone> zones;
  for (int i = 0; i < count; ++i)
    zones.push_back({Polygon::regular(random.point(0.0, side), random.uniform(2.0, 7.0), 6, random.unit()),
                     OneWay{random.uniform(-kPi, kPi), random.uniform(0.4, 1.3)}});
  return zones;
}

TEST(OneWay, PlansObeyAllZonesAmongObstaclesAtEachMillimeter) {
  test::RandomInputs random(9);
  int solved = 0, constrained = 0, backwards = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const World open = random_world({.obstacles = 14, .vertices = 5, .fill = 0.1, .seed = seed});
    const double side = open.box().max.x();
    const World zoned = open.with_zones(random_zones(random, side, 8));
    const Vehicle vehicle = seed % 2 == 0 ? small_car() : Vehicle{};
    const Planner planner(zoned, vehicle), unaware(open, vehicle);
    for (int i = 0; i < 6; ++i) {
      const Pose start{random.uniform(0, side), random.uniform(0, side), random.uniform(-3, 3)};
      const Pose goal{random.uniform(0, side), random.uniform(0, side), random.uniform(-3, 3)};
      const PlanRequest request{.start = start, .goal = goal, .reverse = seed > 3};
      const PlanResult plan = planner.plan(request, {.tree_poses = 300});
      if (!plan.solved()) continue;
      ++solved;
      expect_obeyed(plan);
      backwards +=
          std::ranges::any_of(plan.segments, [](const TimedSegment& s) { return s.segment.gear == Gear::kReverse; });
      const PlanResult other = unaware.plan(request, {.tree_poses = 300});
      EXPECT_LE(plan.lower_bound, plan.travel_time);
      const bool violates = place_against(zoned.zones(), other.path()) >= 0.0;
      constrained += violates;
      // The validator sees what the samples see.
      const ValidationReport report = validate(zoned, vehicle, start, goal, other.timed_path());
      EXPECT_EQ(
          std::ranges::any_of(report.issues,
                              [](const ValidationIssue& issue) { return issue.violation == Violation::kDirection; }),
          violates);
      EXPECT_EQ(planner.is_free(other.path()), !violates);
    }
  }
  EXPECT_GT(solved, 12);
  EXPECT_GT(constrained, 1);
  EXPECT_GT(backwards, 3);
}

// A world, a request and its plan, turned by a quarter and mirrored.
TEST(OneWay, MirroredAndTurnedWorldsHaveSuchPlans) {
  const World world = random_world({.obstacles = 12, .vertices = 5, .fill = 0.2, .seed = 3});
  const std::vector<Zone> zones{{box(5, 5, 15, 40), OneWay{0.4, 0.8}}, {box(16, 0, 30, 20), OneWay{1.2, 0.9}}};
  const MapFile map = to_map_file(world);
  const Pose start{1, 1, 0.5}, goal{35, 30, 0.2};
  const PlanResult plan = Planner(World(map.obstacles).with_zones(zones), small_car()).plan(start, goal);
  expect_obeyed(plan);
  EXPECT_FALSE(zone_stays(plan).empty());

  std::vector<Zone> mirrored_zones = zones;
  for (Zone& zone : mirrored_zones) {
    zone.area = test::mirrored(zone.area);
    std::get<OneWay>(zone.rule).heading *= -1.0;
  }
  const World mirror = World(test::mirrored(map.obstacles)).with_zones(mirrored_zones);
  const PlanResult mirrored = Planner(mirror, small_car()).plan(test::mirrored(start), test::mirrored(goal));
  expect_obeyed(mirrored);
  EXPECT_NEAR(plan.travel_time, mirrored.travel_time, 1e-6 * plan.travel_time);

  const auto turned_ring = [](Ring ring) {
    for (Vec2& p : ring) p = perpendicular(p);
    return ring;
  };
  const auto turned_pose = [](const Pose& p) { return Pose{-p.y, p.x, p.heading + 0.5 * kPi}; };
  std::vector<Polygon> obstacles;
  for (const Polygon& polygon : map.obstacles) obstacles.push_back({turned_ring(polygon.outer), {}});
  std::vector<Zone> turned_zones = zones;
  for (Zone& zone : turned_zones) {
    zone.area.outer = turned_ring(zone.area.outer);
    std::get<OneWay>(zone.rule).heading += 0.5 * kPi;
  }
  const World quarter = World(obstacles).with_zones(turned_zones);
  const PlanResult turned = Planner(quarter, small_car()).plan(turned_pose(start), turned_pose(goal));
  expect_obeyed(turned);
  EXPECT_NEAR(plan.travel_time, turned.travel_time, 1e-6 * plan.travel_time);
}

TEST(OneWay, PlannersOfChangedAndPreparedMapsObeyThem) {
  const World world = forked({kPi, 0.6});
  const PlannerOptions eager{.graph_mode = GraphMode::kEager};
  const Planner planner(world, small_car(), eager);
  const PlanResult plan = planner.plan(kLeft, kRight);
  const Planner restored =
      Planner::restored(world, small_car(), reference_backend(world), planner.prepared_graph(), eager);
  test::expect_same_plan(restored.plan(kLeft, kRight), plan);
  for (const GraphMode mode : {GraphMode::kEager, GraphMode::kLazy}) {
    const Planner before(world, small_car(), {.graph_mode = mode});
    static_cast<void>(before.plan({.start = kLeft, .goal = kRight, .reverse = true}));
    const Planner after = before.with_obstacles({}, {box(28, 20, 32, 40)});
    const Planner anew(after.world(), small_car(), {.graph_mode = mode});
    for (const PlanRequest& request : {PlanRequest{.start = kLeft, .goal = kRight},
                                       PlanRequest{.start = {60, 0, 0}, .goal = {0, 0, 0}, .reverse = true}}) {
      expect_obeyed(after.plan(request));
      test::expect_same_plan(after.plan(request), anew.plan(request));
    }
  }
}

TEST(OneWay, AChangeKeepsTheZones) {
  const World world = forked({kPi, 0.6});
  const Planner planner(world, small_car());
  const auto error_of = [&](const World& after) -> std::string {
    const WorldChange change(world, after, {});
    try {
      static_cast<void>(Planner::changed(planner, change, reference_backend(after)));
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(error_of(world), "");
  EXPECT_EQ(error_of(forked({0.0, 0.6}).with_zones({})),
            "the worlds have 1 and 0 one-way zones, a change keeps them; make a planner anew for other one-way zones");
  EXPECT_NE(error_of(world.with_zones({{box(20, -40, 40, -10), OneWay{kPi, 0.5}, "lane"}})).find("one-way zone 0"),
            std::string::npos);
}

TEST(OneWay, AlternativesAndToursObeyThem) {
  const World world = World({box(10, -10, 20, 8), box(30, -8, 40, 10)}, box(-20, -40, 80, 40).outer)
                          .with_zones({{box(10, -40, 20, -10), OneWay{kPi, 0.6}, "lane"}});
  const Planner planner(world, small_car());
  const std::vector<PlanResult> plans = plan_alternatives(planner, {.start = kLeft, .goal = kRight}, 3);
  EXPECT_GE(plans.size(), 2u);
  for (const PlanResult& plan : plans) expect_obeyed(plan);
  const Tour tour = plan_tour(
      planner,
      {.start = kLeft, .waypoints = {{.position = {25, 0}}}, .goals = {{.position = {60, 0}, .heading = 0.0}}});
  expect_obeyed(tour.plan);
}

TEST(OneWay, TheValidatorNamesTheZoneThatAPathIsAgainst) {
  const PlanResult plan = Planner(forked({0.0, 0.6}), small_car()).plan(kLeft, kRight);
  const World other = forked({kPi, 0.6});
  const ValidationReport report = validate(other, small_car(), plan.start, plan.goal, plan.timed_path());
  ASSERT_FALSE(report.valid());
  for (const ValidationIssue& issue : report.issues) EXPECT_EQ(issue.violation, Violation::kDirection);
  EXPECT_NE(report.issues[0].message.find(" rad off that of one_way zone \"lane\", allowed are 0.6"), std::string::npos)
      << report.issues[0].message;
  EXPECT_STREQ(name_of(Violation::kDirection), "driving direction");
}

}  // namespace
}  // namespace arcway::internal::one_way_test

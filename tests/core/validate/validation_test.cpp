#include "arcway/validation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <stdexcept>

#include "arcway/datasets/catalog.h"
#include "core/motion/speed_profile.h"
#include "tests/support/boxes.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

// The paper's robot, front steering: 1.4 ahead of F, 0.1 behind, 0.4 to either side, rho_min = 1.3.
const Vehicle kCheckedVehicle;
constexpr double kRadius = 2.0;

using test::box;

Path straight(double length = 10.0) { return {{{0.0, 0.0, 0.0}, length, 0.0}}; }
Path half_circle() { return {{{0.0, 0.0, 0.0}, kRadius * std::numbers::pi, 1.0 / kRadius}}; }

TimedPath timed(const Path& path) {
  const SpeedProfile profile = speed_profile(path, kCheckedVehicle);
  return {path,
          {profile.speeds.begin(), profile.speeds.end() - 1},
          {profile.speeds.begin() + 1, profile.speeds.end()},
          profile.durations};
}

ValidationReport check(const World& world, const TimedPath& path) {
  return validate(world, kCheckedVehicle, path.segments.front().start, path.segments.back().end(), path);
}
ValidationReport check(const World& world, const Path& path) { return check(world, TimedPath{path, {}, {}, {}}); }

std::set<Violation> kinds(const ValidationReport& report) {
  std::set<Violation> kinds;
  for (const ValidationIssue& issue : report.issues) kinds.insert(issue.violation);
  return kinds;
}
using Kinds = std::set<Violation>;

const World kEmpty({});

TEST(Validation, AcceptsAFastestPath) {
  Path path = straight();
  path.push_back({path.back().end(), 3.0, 1.0 / kRadius});
  path.push_back({path.back().end(), 4.0, 0.0});
  const ValidationReport report = check(World({box(4.0, 0.5, 6.0, 1.5)}), timed(path));
  EXPECT_TRUE(report.valid()) << report.issues.front().message;
  EXPECT_DOUBLE_EQ(report.length, 17.0);
  EXPECT_DOUBLE_EQ(report.travel_time, speed_profile(path, kCheckedVehicle).total_time);
  EXPECT_NEAR(report.min_clearance, 0.1, 1e-6);
  EXPECT_LE(report.min_clearance, 0.1);
}

TEST(Validation, AcceptsASegmentThatIsLeftAtSpeed) {
  // From rest beyond the speed that it is left at, and down to that again.
  const double a = kCheckedVehicle.max_acceleration();
  const TimedPath path{{straight(1.0)[0], {{1, 0, 0}, 0.5, 0.0}},
                       {0.0, std::sqrt(a)},
                       {std::sqrt(a), 0.0},
                       {(2.0 * std::sqrt(1.5 * a) - std::sqrt(a)) / a, std::sqrt(a) / a}};
  const ValidationReport report = check(kEmpty, path);
  EXPECT_TRUE(report.valid()) << report.issues.front().message;
}

TEST(Validation, AcceptsRoundingOfSpeedsWithinNoLength) {
  const double speed = 5.0;
  Path path = straight(1.0);
  path.push_back({path.back().end(), 0.0, 0.0});
  path.push_back({path.back().end(), 1.0, 0.0});
  TimedPath times = timed(path);
  times.speed_out[0] = times.speed_in[1] = speed;
  times.speed_out[1] = times.speed_in[2] = std::nextafter(speed, 6.0);
  times.durations = {1.0, 0.0, 1.0};
  const ValidationReport report = check(kEmpty, times);
  EXPECT_TRUE(report.valid()) << report.issues.front().message;
  times.speed_out[1] = times.speed_in[2] = 5.1;
  EXPECT_EQ(kinds(check(kEmpty, times)), Kinds{Violation::kAcceleration});
}

TEST(Validation, EmptyWorldHasInfiniteClearance) {
  EXPECT_EQ(check(kEmpty, straight()).min_clearance, std::numeric_limits<double>::infinity());
}

TEST(Validation, EmptyPathStaysAtTheStart) {
  const Pose here{1.0, 1.0, 0.0};
  EXPECT_TRUE(validate(kEmpty, kCheckedVehicle, here, here, {}).valid());
  EXPECT_EQ(kinds(validate(kEmpty, kCheckedVehicle, here, {2.0, 1.0, 0.0}, {})), Kinds{Violation::kGoalPose});
  EXPECT_EQ(kinds(validate(World({box(0.0, 0.0, 3.0, 3.0)}), kCheckedVehicle, here, here, {})),
            Kinds{Violation::kCollision});
}

// As the paper's robot, times a factor, and turning on a circle of this radius.
Vehicle scaled_robot(double scale, double radius) {
  VehicleParameters parameters;
  for (double* length : {&parameters.length, &parameters.width, &parameters.wheelbase}) *length *= scale;
  parameters.max_steering_angle = std::atan(parameters.wheelbase / radius);
  return Vehicle(parameters);
}

TEST(Validation, EmptyPathMayEndWithinTheTolerancesForARobotOfAnySize) {
  for (const double scale : {1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    SCOPED_TRACE(scale);
    const Vehicle robot = scaled_robot(scale, scale);
    const World world({box(3.0 * scale, -scale, 4.0 * scale, scale)});
    const Pose here{scale, scale, 0.3};
    EXPECT_TRUE(validate(world, robot, here, here, {}).valid());
    EXPECT_TRUE(validate(world, robot, here, {here.x + 9e-7, here.y, here.heading}, {}).valid());
    EXPECT_TRUE(
        validate(world, robot, here, {here.x, here.y, here.heading + 9e-7 + 2.0 * std::numbers::pi}, {}).valid());
    EXPECT_EQ(kinds(validate(world, robot, here, {here.x + 2e-6, here.y, here.heading}, {})),
              Kinds{Violation::kGoalPose});
    EXPECT_EQ(kinds(validate(world, robot, {2.0 * scale, 0, 0}, {2.0 * scale, 0, 0}, {})),
              Kinds{Violation::kCollision});
  }
}

TEST(Validation, NoticesThatAJointLeadsIntoAnObstacle) {
  const TimedPath path{{{{0, 0, 0}, 1.0, 0.0}, {{15, 0, 0}, 1.0, 0.0}}, {}, {}, {}};
  EXPECT_EQ(kinds(check(World({box(5, -5, 30, 5)}), path)), (Kinds{Violation::kPositionJump, Violation::kCollision}));
}

TEST(Validation, OfManyPathsIsThatOfEach) {
  const World world = catalog_world("clutter/star/n60/m10/f30/s3");
  const Validator validator(world);
  test::RandomInputs random(5);
  int valid = 0, invalid = 0;
  for (int i = 0; i < 200; ++i) {
    Path path{{{random.uniform(0, 60), random.uniform(0, 60), random.uniform(0, 6)}, random.uniform(0, 4), 0.0}};
    path.push_back({path.back().end(), random.uniform(0, 4), random.uniform(-1, 1) / kRadius});
    const TimedPath timed{path, {}, {}, {}};
    const ValidationReport once = check(world, timed);
    const ValidationReport kept = validator(kCheckedVehicle, path.front().start, path.back().end(), timed);
    EXPECT_EQ(kinds(once), kinds(kept));
    EXPECT_EQ(once.min_clearance, kept.min_clearance);
    ++(once.valid() ? valid : invalid);
  }
  EXPECT_GT(valid, 10);
  EXPECT_GT(invalid, 10);
}

TEST(Validation, Numbers) {
  TimedPath path{straight(), {}, {}, {}};
  path.segments[0].length = -1.0;
  EXPECT_EQ(kinds(validate(kEmpty, kCheckedVehicle, {}, {}, path)), Kinds{Violation::kNegativeLength});
  const double nan = std::nan("");
  for (const PathSegment& bad :
       {PathSegment{{}, nan, 0.0}, PathSegment{{}, 1.0, nan}, PathSegment{{0, 0, nan}, 1.0, 0.0},
        PathSegment{{}, 1.0, std::numeric_limits<double>::infinity()}, PathSegment{{1e308, 0, 0}, 1e308, 0.0}}) {
    path.segments[0] = bad;
    EXPECT_EQ(kinds(validate(kEmpty, kCheckedVehicle, {}, {}, path)), Kinds{Violation::kNotFinite});
  }
  path.segments = straight();
  EXPECT_EQ(kinds(validate(kEmpty, kCheckedVehicle, {std::nan(""), 0, 0}, {10, 0, 0}, path)),
            Kinds{Violation::kNotFinite});
  TimedPath speeds = timed(straight());
  speeds.durations[0] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(kinds(check(kEmpty, speeds)), Kinds{Violation::kNotFinite});
}

TEST(Validation, RefusesOtherNumbersOfTimesWhateverElseIsWrong) {
  TimedPath path = timed(straight());
  path.durations.push_back(1.0);
  EXPECT_THROW((void)check(kEmpty, path), std::invalid_argument);
  path.segments[0].length = std::nan("");
  EXPECT_THROW((void)check(kEmpty, path), std::invalid_argument);
}

// Far from the map doubles are coarse: 1.2e-7 m at 1e9 m.
TEST(Validation, ClearanceIsABoundWhereThePathIsFarFromTheMapsOrigin) {
  const World wall({box(2, -1, 3, 1)});
  const TimedPath path{{{{-1e9, 0, 0}, 1e9, 0.0}}, {}, {}, {}};
  const ValidationReport report = validate(wall, kCheckedVehicle, {-1e9, 0, 0}, {0, 0, 0}, path);
  const double clearance = 2.0 - kCheckedVehicle.footprint().front;
  EXPECT_GT(report.min_clearance, clearance - 1e-4);
  EXPECT_LT(report.min_clearance, clearance - 1e-7);
}

TEST(Validation, EndPoses) {
  const TimedPath path{straight(), {}, {}, {}};
  const double turn = 2.0 * std::numbers::pi;
  EXPECT_TRUE(validate(kEmpty, kCheckedVehicle, {0, 0, turn}, {10, 0, -turn}, path).valid());
  EXPECT_EQ(kinds(validate(kEmpty, kCheckedVehicle, {1e-5, 0, 0}, {10, 0, 0}, path)), Kinds{Violation::kStartPose});
  EXPECT_EQ(kinds(validate(kEmpty, kCheckedVehicle, {0, 0, 1e-5}, {10, 0, 0}, path)), Kinds{Violation::kStartPose});
  EXPECT_EQ(kinds(validate(kEmpty, kCheckedVehicle, {0, 0, 0}, {10, 1e-5, 0}, path)), Kinds{Violation::kGoalPose});
  EXPECT_EQ(kinds(validate(kEmpty, kCheckedVehicle, {0, 0, 0}, {10, 0, 3.14}, path)), Kinds{Violation::kGoalPose});
}

TEST(Validation, Joints) {
  Path path = straight();
  path.push_back({{10.0, 1e-5, 0.0}, 1.0, 0.0});
  const ValidationReport jump = check(kEmpty, path);
  EXPECT_EQ(kinds(jump), Kinds{Violation::kPositionJump});
  EXPECT_EQ(jump.issues[0].segment, 1u);
  path[1].start = {10.0, 0.0, 1e-5};
  EXPECT_EQ(kinds(check(kEmpty, path)), Kinds{Violation::kHeadingJump});
  path[1].start = {10.0, 0.0, 4.0 * std::numbers::pi};
  EXPECT_TRUE(check(kEmpty, path).valid());
}

TEST(Validation, Curvature) {
  EXPECT_TRUE(check(kEmpty, Path{{{}, 1.0, -1.0 / 1.3}}).valid());
  EXPECT_EQ(kinds(check(kEmpty, Path{{{}, 1.0, -1.0 / 1.299}})), Kinds{Violation::kCurvature});
}

TEST(Validation, Speeds) {
  const Path path{{{0, 0, 0}, 50.0, 0.0}, {{50, 0, 0}, 50.0, 0.0}};
  const TimedPath good = timed(path);
  EXPECT_TRUE(check(kEmpty, good).valid());

  TimedPath bad = good;
  bad.speed_out[0] = bad.speed_in[1] = 12.1;
  EXPECT_EQ(kinds(check(kEmpty, bad)), Kinds{Violation::kSpeedLimit});
  bad = good;
  bad.speed_out[0] = bad.speed_in[1] = -1.0;
  EXPECT_TRUE(kinds(check(kEmpty, bad)).contains(Violation::kSpeedLimit));
  bad = good;
  bad.speed_in[1] = 11.9;
  bad.durations[1] = 10.0;
  EXPECT_EQ(kinds(check(kEmpty, bad)), Kinds{Violation::kSpeedJump});
  bad = good;
  bad.speed_in[0] = 1.0;
  EXPECT_EQ(kinds(check(kEmpty, bad)), Kinds{Violation::kSpeedJump});  // not at rest at the start
  bad = good;
  bad.speed_out[1] = 1.0;
  EXPECT_EQ(kinds(check(kEmpty, bad)), Kinds{Violation::kSpeedJump});  // nor at the goal
  bad = good;
  bad.durations[0] *= 0.99999;
  EXPECT_EQ(kinds(check(kEmpty, bad)), Kinds{Violation::kDuration});
  bad.durations[0] = 100.0;
  EXPECT_TRUE(check(kEmpty, bad).valid());
  bad.durations.pop_back();
  EXPECT_THROW(check(kEmpty, bad), std::invalid_argument);
}

TEST(Validation, EndSpeedsAreThoseAskedFor) {
  const auto look = [](const Path& path, const EndSpeeds& driven, const ValidationOptions& asked) {
    const SpeedProfile profile = speed_profile(path, kCheckedVehicle, driven);
    const TimedPath timed{path,
                          {profile.speeds.begin(), profile.speeds.end() - 1},
                          {profile.speeds.begin() + 1, profile.speeds.end()},
                          profile.durations};
    return validate(kEmpty, kCheckedVehicle, path.front().start, path.back().end(), timed, asked);
  };
  const Path ahead = straight(), back = reversed(ahead);
  EXPECT_TRUE(look(ahead, {3.0, 2.0}, {.start_speed = 3.0, .goal_speed = 2.0}).valid());
  EXPECT_TRUE(look(back, {-3.0, -2.0}, {.start_speed = -3.0, .goal_speed = -2.0}).valid());
  EXPECT_EQ(kinds(look(ahead, {3.0, 2.0}, {.start_speed = 3.0})), Kinds{Violation::kSpeedJump});
  EXPECT_EQ(kinds(look(ahead, {3.0, 2.0}, {.goal_speed = 2.0})), Kinds{Violation::kSpeedJump});
  EXPECT_EQ(kinds(look(ahead, {3.0, 2.0}, {.start_speed = 3.0, .goal_speed = 2.001})), Kinds{Violation::kSpeedJump});
  EXPECT_EQ(kinds(look(ahead, {3.0, 0.0}, {.start_speed = -3.0})), Kinds{Violation::kSpeedJump});
  EXPECT_EQ(kinds(look(back, {-3.0, 0.0}, {.start_speed = 3.0})), Kinds{Violation::kSpeedJump});
  const Pose here{1.0, 1.0, 0.0};
  EXPECT_TRUE(validate(kEmpty, kCheckedVehicle, here, here, {}, {.start_speed = 1.0, .goal_speed = 1.0}).valid());
  EXPECT_EQ(kinds(validate(kEmpty, kCheckedVehicle, here, here, {}, {.start_speed = 1.0})),
            Kinds{Violation::kSpeedJump});
}

TEST(Validation, AnArcMayNotBeLeftFasterThanItIsDriven) {
  Path path{{{}, 3.0, 1.0 / kRadius}};
  path.push_back({path.back().end(), 3.0, 0.0});
  TimedPath times = timed(path);
  times.speed_out[0] = times.speed_in[1] = 0.5 * (kCheckedVehicle.turn_speed(kRadius) + kCheckedVehicle.max_speed());
  times.durations = {1.0, 1.0};
  const ValidationReport report = check(kEmpty, times);
  ASSERT_EQ(kinds(report), Kinds{Violation::kSpeedLimit});
  EXPECT_EQ(report.issues.front().segment, 0u);
  EXPECT_EQ(report.issues.front().arc_length, 3.0);
}

TEST(Validation, Acceleration) {
  TimedPath path{{{{0, 0, 0}, 1.0, 0.0}, {{1, 0, 0}, 50.0, 0.0}}, {0.0, 10.1}, {10.1, 0.0}, {10.0, 10.0}};
  EXPECT_EQ(kinds(check(kEmpty, path)), Kinds{Violation::kAcceleration});
  path.speed_out[0] = path.speed_in[1] = 10.0;
  EXPECT_TRUE(check(kEmpty, path).valid());
}

TEST(Validation, StraightContactToATenthOfAMicron) {
  EXPECT_TRUE(check(World({box(4.0, 0.4004, 6.0, 2.0)}), straight()).valid());
  EXPECT_NEAR(check(World({box(4.0, 0.4004, 6.0, 2.0)}), straight()).min_clearance, 4e-4, 1e-6);
  const ValidationReport report = check(World({box(4.0, 0.4 - 1e-7, 6.0, 2.0)}), straight());
  EXPECT_EQ(kinds(report), Kinds{Violation::kCollision});
  EXPECT_NEAR(report.issues[0].arc_length, 2.6, 1e-9);
  EXPECT_EQ(report.min_clearance, 0.0);
  EXPECT_EQ(kinds(check(World({box(4.0, 0.4, 6.0, 2.0)}), straight())), Kinds{Violation::kCollision});
}

TEST(Validation, ArcContactToATenthOfAMicron) {
  // The inner side sweeps the circle of radius 1.6 about (0, 2), the outer front corner that of hypot(1.4, 2.4).
  const auto inside = [](double reach) { return World({{{Vec2(-0.1, 1.9), Vec2(reach, 2.0), Vec2(-0.1, 2.1)}, {}}}); };
  const auto outside = [](double reach) { return World({box(reach, 1.5, 9.0, 2.0)}); };
  const double inner = 1.6;
  const double outer = std::hypot(1.4, 2.4);
  const auto valid = [](const World& world) { return check(world, half_circle()).valid(); };
  EXPECT_TRUE(valid(inside(inner - 4e-4)));
  EXPECT_FALSE(valid(inside(inner + 1e-7)));
  EXPECT_TRUE(valid(outside(outer + 4e-4)));
  EXPECT_FALSE(valid(outside(outer - 1e-7)));
  EXPECT_NEAR(check(inside(inner - 4e-4), half_circle()).min_clearance, 4e-4, 1.1e-6);
  EXPECT_NEAR(check(outside(outer + 4e-4), half_circle()).min_clearance, 4e-4, 1.1e-6);
}

// At 1e9 a double is no finer than 1e-7: bounds on distances leave microns open however short an interval is.
TEST(Validation, ArcsAroundVerticesOfAnyScaleAndFarFromTheOrigin) {
  for (const double scale : {1e-6, 1.0, 1e6})
    for (const double far : {0.0, std::min(9e8, 9e8 * scale)}) {
      SCOPED_TRACE(testing::Message() << scale << " " << far);
      VehicleParameters parameters;
      for (double* length : {&parameters.length, &parameters.width, &parameters.wheelbase, &parameters.max_speed})
        *length *= scale;
      const PathSegment arc{{far, 0.0, 0.0}, 2.0 * std::numbers::pi * scale, 0.5 / scale};
      // The inner side sweeps the circle of radius 1.6 about (0, 2), round this vertex.
      const auto clearance = [&](double tip) {
        const Ring ring{Vec2(-0.1, 1.9), Vec2(tip, 2.0), Vec2(-0.1, 2.1)};
        Ring there;
        for (const Vec2& p : ring) there.push_back(scale * p + Vec2(far, 0.0));
        return validate(World({{there, {}}}), Vehicle(parameters), arc.start, arc.end(), {{arc}, {}, {}, {}})
            .min_clearance;
      };
      EXPECT_GT(clearance(1.6 - 4e-4), 0.0);
      EXPECT_NEAR(clearance(1.6 - 4e-4), 4e-4 * scale, std::max(2e-6, 1e-5 * scale));
      EXPECT_EQ(clearance(1.6 + 1e-5), 0.0);
    }
}

// An interval ends where the body's corners hardly move: F itself travels next to nothing.
TEST(Validation, TurnsOnTheSpotToAMicron) {
  for (const double radius : {1e-3, 1e-6, 1e-9, 1e-12})
    for (const double curvature : {1.0 / radius, -1.0 / radius})
      for (const double heading : {0.0, 1.234, -2.9}) {
        SCOPED_TRACE(testing::Message() << radius << " " << curvature << " " << heading);
        const Vehicle vehicle = scaled_robot(1.0, radius);
        const PathSegment arc{{0, 0, heading}, 2.0 * std::numbers::pi * radius, curvature};
        const Vec2 center = perpendicular(direction_of(heading)) / curvature;
        const double swept = std::hypot(1.4, 0.4 + radius);  // by the outer front corner
        const auto report = [&](double gap) {
          const double right = center.x() + swept + gap;
          const World world({box(right, -1.0, right + 1.0, 1.0)});
          return validate(world, vehicle, arc.start, arc.end(), {{arc}, {}, {}, {}});
        };
        EXPECT_TRUE(report(1e-6).valid());
        EXPECT_LE(report(1e-3).min_clearance, 1e-3);
        EXPECT_GE(report(1e-3).min_clearance, 1e-3 - 1.1e-6);
        EXPECT_EQ(kinds(report(-1e-6)), Kinds{Violation::kCollision});
      }
}

// Forwards, a quarter of a turn on the spot, and on; the outer corner passes a wall while the robot turns.
TEST(Validation, RefusesWhatIsWrongWithATurnOnTheSpot) {
  constexpr double kTiny = 1e-9;
  const Vehicle vehicle = scaled_robot(1.0, kTiny);
  Path path = straight(3.0);
  path.push_back({path.back().end(), 0.5 * std::numbers::pi * kTiny, 1.0 / kTiny});
  path.push_back({path.back().end(), 3.0, 0.0});
  const SpeedProfile profile = speed_profile(path, vehicle);
  const TimedPath good{path,
                       {profile.speeds.begin(), profile.speeds.end() - 1},
                       {profile.speeds.begin() + 1, profile.speeds.end()},
                       profile.durations};
  const double reach = 3.0 + std::hypot(1.4, 0.4);
  const auto found = [&](const TimedPath& changed, double gap = 1e-6) {
    const World world({box(reach + gap, -1.0, reach + 1.0, 1.0)});
    return kinds(validate(world, vehicle, path.front().start, path.back().end(), changed));
  };
  EXPECT_EQ(found(good), Kinds{});
  EXPECT_EQ(found(good, -1e-6), Kinds{Violation::kCollision});

  TimedPath changed = good;
  for (PathSegment& segment : changed.segments) segment.start.x += 2e-6;
  EXPECT_EQ(found(changed), (Kinds{Violation::kStartPose, Violation::kGoalPose, Violation::kCollision}));
  changed = good;
  changed.segments[1].start.y += 2e-6;
  EXPECT_TRUE(found(changed).contains(Violation::kPositionJump));
  changed = good;
  changed.segments[1].curvature *= 1.001;
  EXPECT_EQ(found(changed), (Kinds{Violation::kCurvature, Violation::kHeadingJump}));
  changed = good;
  changed.segments[1].length *= 1.001;
  EXPECT_TRUE(found(changed).contains(Violation::kHeadingJump));
  changed = good;
  changed.segments[1].curvature *= -1.0;
  EXPECT_TRUE(found(changed).contains(Violation::kHeadingJump));
  changed = good;
  changed.speed_out[1] = changed.speed_in[2] = vehicle.max_speed();
  EXPECT_TRUE(found(changed).contains(Violation::kSpeedLimit));
  changed = good;
  changed.durations[2] *= 0.999;
  EXPECT_EQ(found(changed), Kinds{Violation::kDuration});
}

// What no vehicle can drive is refused within a bounded number of intervals.
TEST(Validation, EndsAtAnyCurvature) {
  for (const double curvature : {1e30, 1e150, 1e300, 1e-300}) {
    const PathSegment arc{{0, 0, 0}, 6.0 / curvature, curvature};
    if (!std::isfinite(arc.end().heading)) continue;
    const ValidationReport report = check(World({box(0.5, 0.5, 0.6, 0.6)}), Path{arc});
    EXPECT_EQ(report.valid(), false) << curvature;
  }
}

TEST(Validation, SpikeThinnerThanAnyStep) {
  const auto spike = [](double tip) {
    return World({{{Vec2(5.0, tip), Vec2(5.0 + 5e-7, 3.0), Vec2(5.0 - 5e-7, 3.0)}, {}}});
  };
  EXPECT_EQ(kinds(check(spike(0.399), straight())), Kinds{Violation::kCollision});
  EXPECT_TRUE(check(spike(0.401), straight()).valid());

  // On the arc, from outside between two poses.
  const double outer = std::hypot(1.4, 2.4);
  const auto radial = [outer](double depth) {
    const Vec2 center(0.0, 2.0);
    const Vec2 u = direction_of(0.1);
    const Vec2 tail = center + (outer + 3.0) * u;
    return World(
        {{{center + (outer - depth) * u, tail - 5e-7 * perpendicular(u), tail + 5e-7 * perpendicular(u)}, {}}});
  };
  EXPECT_EQ(kinds(check(radial(1e-3), half_circle())), Kinds{Violation::kCollision});
  EXPECT_TRUE(check(radial(-1e-3), half_circle()).valid());
}

TEST(Validation, ALongBodyHitsAtTheEndWhatItWasFarFromBefore) {
  // Its front corner moves more than three times as fast as the reference point, and something else is nearer all
  // along.
  VehicleParameters parameters;
  parameters.length = parameters.wheelbase = 10.0;
  parameters.width = 1.0;
  parameters.max_steering_angle = 1.4;
  const Vehicle vehicle(parameters);
  const PathSegment arc{{0, 0, 0}, 1.8, 1.0 / 3.0};
  const Vec2 corner = arc.end().position() + 10.0 * direction_of(0.6) + 0.5 * perpendicular(direction_of(0.6));
  const World world(
      {box(0.5, -1.0, 1.0, -0.51), box(corner.x() - 0.2, corner.y() - 0.02, corner.x() + 0.2, corner.y() + 1)});
  const ValidationReport report = validate(world, vehicle, arc.start, arc.end(), {{arc}, {}, {}, {}});
  ASSERT_EQ(kinds(report), Kinds{Violation::kCollision});
  EXPECT_GT(report.issues.front().arc_length, 1.75);
}

TEST(Validation, NothingIsTunnelledThrough) {
  EXPECT_EQ(kinds(check(World({box(50.0, -3.0, 50.0 + 1e-9, 3.0)}), straight(100.0))), Kinds{Violation::kCollision});
  EXPECT_EQ(kinds(check(World({box(5.0, 0.0, 5.0 + 1e-6, 1e-6)}), straight())), Kinds{Violation::kCollision});
  EXPECT_EQ(kinds(check(World({box(2.0, 2.0, 2.0 + 1e-6, 2.0 + 1e-6)}), half_circle())), Kinds{Violation::kCollision});
}

TEST(Validation, BodySwallowedByAnObstacle) {
  const Polygon large = box(-100.0, -100.0, 100.0, 100.0);
  const ValidationReport report = check(World({box(200.0, 200.0, 201.0, 201.0), large}), straight());
  EXPECT_EQ(kinds(report), Kinds{Violation::kCollision});
  EXPECT_EQ(report.issues[0].message, "the body is inside obstacle 1 at 0 m");
  EXPECT_EQ(report.min_clearance, 0.0);
  EXPECT_EQ(kinds(check(World({large}), half_circle())), Kinds{Violation::kCollision});

  Polygon courtyard = large;
  courtyard.holes.push_back({Vec2(-50.0, -50.0), Vec2(50.0, -50.0), Vec2(50.0, 50.0), Vec2(-50.0, 50.0)});
  EXPECT_TRUE(check(World({courtyard}), straight()).valid());
  EXPECT_FALSE(check(World({courtyard, box(-60.0, -60.0, 60.0, 60.0)}), straight()).valid());
}

TEST(Validation, Bounds) {
  const auto within = [](double x1) { return World({}, box(-5.0, -5.0, x1, 5.0).outer); };
  EXPECT_TRUE(check(within(11.4004), straight()).valid());
  EXPECT_NEAR(check(within(11.4004), straight()).min_clearance, 4e-4, 1e-6);
  const ValidationReport report = check(within(11.3), straight());
  EXPECT_EQ(kinds(report), Kinds{Violation::kOutsideBounds});
  EXPECT_NEAR(report.issues[0].arc_length, 9.9, 1e-9);
  EXPECT_EQ(kinds(check(within(2.5), half_circle())), Kinds{Violation::kOutsideBounds});
  EXPECT_EQ(kinds(check(World({}, box(20.0, 20.0, 30.0, 30.0).outer), straight())), Kinds{Violation::kOutsideBounds});
}

/// Smallest distance over many poses: an upper bound that comes near.
double sampled_clearance(const Path& path, const std::vector<Polygon>& obstacles) {
  double clearance = std::numeric_limits<double>::infinity();
  const auto to_segment = [](const Vec2& p, const Vec2& a, const Vec2& b) {
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (a + t * (b - a) - p).norm();
  };
  for (const PathSegment& s : path) {
    for (int i = 0; i <= 2000; ++i) {
      const Pose pose = s.at(s.length * i / 2000.0);
      const Vec2 u = direction_of(pose.heading);
      const Vec2 n = 0.4 * perpendicular(u);
      const std::array<Vec2, 4> body = {pose.position() - 0.1 * u - n, pose.position() + 1.4 * u - n,
                                        pose.position() + 1.4 * u + n, pose.position() - 0.1 * u + n};
      for (const Polygon& o : obstacles) {
        for (std::size_t j = 0; j < o.outer.size(); ++j) {
          const Vec2& a = o.outer[j];
          const Vec2& b = o.outer[(j + 1) % o.outer.size()];
          for (std::size_t k = 0; k < 4; ++k) {
            clearance = std::min({clearance, to_segment(body[k], a, b), to_segment(a, body[k], body[(k + 1) % 4])});
          }
        }
      }
    }
  }
  return clearance;
}

TEST(Validation, ClearanceIsThatOfSampledPosesInRandomWorlds) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-6.0, 12.0), size(0.1, 1.0), signed_one(-1.0, 1.0);
  int valid = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<Polygon> obstacles;
    for (int i = 0; i < 4; ++i) {
      const double x = place(random);
      const double y = place(random);
      obstacles.push_back(box(x, y, x + size(random), y + size(random)));
    }
    Path path;
    Pose pose{0.0, 0.0, 0.3};
    for (int i = 0; i < 3; ++i) {
      path.push_back({pose, 2.0 + signed_one(random), i == 1 ? 0.0 : signed_one(random) / 1.3});
      pose = path.back().end();
    }
    const ValidationReport report = check(World(obstacles), path);
    if (!report.valid()) continue;
    ++valid;
    const double sampled = sampled_clearance(path, obstacles);
    EXPECT_LE(report.min_clearance, sampled + 1e-12) << "round " << round;
    EXPECT_GE(report.min_clearance, sampled - 2e-3) << "round " << round;
  }
  EXPECT_GT(valid, 15);
}

TEST(Validation, ReverseHasASpeedLimitOfItsOwn) {
  const Vehicle slow({.max_speed = 6.0, .max_reverse_speed = 2.0, .max_acceleration = 4.0});
  for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
    for (const double curvature : {0.0, 0.2}) {
      TimedPath path;
      path.segments = {{{0, 0, 0}, 6.0, curvature, gear}, {}};
      path.segments[1] = {path.segments[0].end(), 6.0, curvature, gear};
      path.speed_in = {0.0, 4.0};
      path.speed_out = {4.0, 0.0};
      path.durations = {5.0, 5.0};
      const auto report = validate(kEmpty, slow, path.segments.front().start, path.segments.back().end(), path);
      if (gear == Gear::kForward) {
        EXPECT_TRUE(report.valid());
      } else {
        EXPECT_EQ(kinds(report), (Kinds{Violation::kSpeedLimit, Violation::kSpeedLimit}));
      }
    }
  }
}

// Out and back again, over the same ground.
Path out_and_back(const Path& path) {
  Path both = path;
  for (auto s = path.rbegin(); s != path.rend(); ++s) both.push_back(s->reversed());
  return both;
}

TEST(Validation, AcceptsCuspsAtRestOnly) {
  Path path = straight();
  path.push_back({path.back().end(), 3.0, 1.0 / kRadius});
  const TimedPath good = timed(out_and_back(path));
  EXPECT_TRUE(check(kEmpty, good).valid());
  EXPECT_EQ(check(kEmpty, good).length, 26.0);

  TimedPath moving = good;
  moving.speed_out[1] = moving.speed_in[2] = 0.5;
  EXPECT_EQ(kinds(check(kEmpty, moving)), Kinds{Violation::kCuspSpeed});
  EXPECT_EQ(check(kEmpty, moving).issues[0].segment, 2u);
  EXPECT_EQ(kinds(validate(kEmpty, kCheckedVehicle, good.segments.front().start, good.segments.back().end(), good,
                           {.reverse = false})),
            Kinds{Violation::kReverse});
}

TEST(Validation, WrongGearMissesTheNextJoint) {
  Path path = out_and_back(straight());
  path.push_back({path.back().end(), 2.0, 0.0});
  path[1].gear = Gear::kForward;
  EXPECT_EQ(kinds(check(kEmpty, path)), Kinds{Violation::kPositionJump});
  path = out_and_back({{{0.0, 0.0, 0.0}, kRadius, 1.0 / kRadius}});
  path[1].gear = Gear::kForward;
  EXPECT_TRUE(kinds(validate(kEmpty, kCheckedVehicle, {}, {}, {path, {}, {}, {}})).contains(Violation::kGoalPose));
  // The body's heading runs on through a cusp: it is not that of the motion.
  path = out_and_back(straight());
  path[1].start.heading = std::numbers::pi;
  EXPECT_EQ(kinds(check(kEmpty, path)), Kinds{Violation::kHeadingJump});
}

TEST(Validation, BackwardsContactToATenthOfAMicron) {
  const Path back{straight()[0].reversed()};
  EXPECT_TRUE(check(World({box(4.0, 0.4004, 6.0, 2.0)}), back).valid());
  const ValidationReport beside = check(World({box(4.0, 0.4 - 1e-7, 6.0, 2.0)}), back);
  EXPECT_EQ(kinds(beside), Kinds{Violation::kCollision});
  EXPECT_NEAR(beside.issues[0].arc_length, 10.0 - 6.0 - 0.1, 1e-9);  // where the tail comes to it
  EXPECT_TRUE(check(World({box(-2.0, -1.0, -0.1004, 1.0)}), back).valid());
  const ValidationReport behind = check(World({box(-2.0, -1.0, -0.1 + 1e-7, 1.0)}), back);
  EXPECT_EQ(kinds(behind), Kinds{Violation::kCollision});
  EXPECT_NEAR(behind.issues[0].arc_length, 10.0, 1e-6);
  EXPECT_FALSE(check(World({box(11.3, -1.0, 12.0, 1.0)}), back).valid());  // the nose at the start

  const double outer = std::hypot(1.4, 2.4);
  const auto wall = [](double reach) { return World({box(reach, 1.5, 9.0, 2.0)}); };
  EXPECT_TRUE(check(wall(outer + 4e-4), Path{half_circle()[0].reversed()}).valid());
  EXPECT_FALSE(check(wall(outer - 1e-7), Path{half_circle()[0].reversed()}).valid());
}

TEST(Validation, BackwardsIsValidWhereForwardsIs) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-6.0, 12.0), size(0.1, 1.0), signed_one(-1.0, 1.0);
  int valid = 0;
  for (int round = 0; round < 100; ++round) {
    std::vector<Polygon> obstacles;
    for (int i = 0; i < 4; ++i) {
      const double x = place(random);
      const double y = place(random);
      obstacles.push_back(box(x, y, x + size(random), y + size(random)));
    }
    const World world(obstacles);
    Path path;
    for (int i = 0; i < 3; ++i) {
      path.push_back({path.empty() ? Pose{0.0, 0.0, 0.3} : path.back().end(), 2.0 + signed_one(random),
                      i == 1 ? 0.0 : signed_one(random) / 1.3});
    }
    Path back;
    for (auto s = path.rbegin(); s != path.rend(); ++s) back.push_back(s->reversed());
    const ValidationReport forwards = check(world, path);
    const ValidationReport backwards = check(world, back);
    EXPECT_EQ(forwards.valid(), backwards.valid()) << "round " << round;
    EXPECT_NEAR(forwards.min_clearance, backwards.min_clearance, 2.1e-6) << "round " << round;
    valid += forwards.valid() ? 1 : 0;
  }
  EXPECT_GT(valid, 20);
}

TEST(Validation, LongPathAmongTenThousandEdges) {
  std::vector<Polygon> obstacles;
  for (int i = 0; i < 50; ++i) {
    for (int j = 0; j < 50; ++j) obstacles.push_back(box(20.0 * i, 20.0 * j, 20.0 * i + 8.0, 20.0 * j + 8.0));
  }
  const World world(obstacles);
  Path path{{{-14.0, 14.0, 0.0}, 5.0, 0.0}};
  for (int i = 0; i < 100; ++i) path.push_back({path.back().end(), 5.0, 0.0});
  path.push_back({path.back().end(), kRadius * std::numbers::pi / 2.0, 1.0 / kRadius});
  for (int i = 0; i < 50; ++i) path.push_back({path.back().end(), 6.0, 0.0});
  const ValidationReport report = check(world, timed(path));
  EXPECT_TRUE(report.valid()) << report.issues.front().message;
}

TEST(Violation, Names) {
  EXPECT_STREQ(name_of(Violation::kNotFinite), "not finite");
  EXPECT_STREQ(name_of(Violation::kNegativeLength), "negative length");
  EXPECT_STREQ(name_of(Violation::kCuspSpeed), "speed at a cusp");
}

}  // namespace
}  // namespace arcway::internal

#include "arcway/datasets/driven_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "arcway/datasets/catalog.h"
#include "arcway/datasets/plan_io.h"
#include "arcway/datasets/robot.h"
#include "arcway/validation.h"
#include "arcway/vehicle.h"
#include "datasets/generators/drive_clearance.h"

namespace arcway::internal {
namespace {

std::string name_of(const DrivenParameters& p) {
  return std::string(name_of(p.kind)) + " robot " + std::to_string(p.robot) + (p.both_gears ? " both gears" : "") +
         " seed " + std::to_string(p.seed);
}

// Every kind with every robot, each with another seed.
template <typename Check>
void for_all_worlds(double clearance, const Check& check) {
  std::uint64_t seed = 1;
  for (const DrivenKind kind : kDrivenKinds) {
    for (std::size_t robot = 1; robot <= driven_robots().size(); ++robot, ++seed) {
      const DrivenParameters parameters{
          .kind = kind, .robot = robot, .both_gears = seed % 2 == 0, .clearance = clearance, .seed = seed};
      SCOPED_TRACE(name_of(parameters));
      check(parameters, generate_driven_world(parameters));
    }
  }
}

TEST(DrivenWorld, TheValidatorTakesEveryDriveAndFindsItsClearance) {
  constexpr double kWithin = 1e-6;  // of the validator's lower bound on the clearance [m]
  for (const double clearance : {0.05, 0.002}) {
    for_all_worlds(clearance, [&](const DrivenParameters&, const DrivenWorld& made) {
      const World world = to_world(made.map, "driven");
      const PlanResult drive = plan_of_drive(made);
      const ValidationReport report =
          validate(world, Vehicle(made.robot), *made.map.start, *made.map.goal, drive.timed_path());
      EXPECT_TRUE(report.valid()) << report.issues.front().message;
      EXPECT_GE(report.min_clearance, clearance - kWithin);
      EXPECT_NEAR(report.min_clearance, drive.min_clearance, 2.0 * kWithin);
      EXPECT_DOUBLE_EQ(report.travel_time, drive.travel_time);
      EXPECT_GE(drive.travel_time, drive.lower_bound);
    });
  }
}

TEST(DrivenWorld, ObstaclesHugTheDriveAsNearAsAllowed) {
  for (std::size_t robot = 1; robot <= driven_robots().size(); ++robot) {
    const DrivenWorld made =
        generate_driven_world({.kind = DrivenKind::kHugging, .robot = robot, .clearance = 0.02, .seed = robot});
    EXPECT_LT(plan_of_drive(made).min_clearance, 0.02 + 2e-3) << driven_robots()[robot - 1].name;
    EXPECT_GE(made.map.obstacles.size(), 20u);
  }
}

TEST(DrivenWorld, DrivesChangeGearOnlyWhereTheyMay) {
  for_all_worlds(0.05, [](const DrivenParameters& parameters, const DrivenWorld& made) {
    EXPECT_EQ(cusps_of(made.drive) > 0, parameters.both_gears);
    if (!parameters.both_gears) {
      EXPECT_TRUE(std::ranges::all_of(made.drive, [](const auto& s) { return s.gear == Gear::kForward; }));
    }
    EXPECT_GE(made.map.obstacles.size(), 1u);
  });
}

TEST(DrivenWorld, RobotsTurnWithRadiiFromNineCentimetersToThirtyMeters) {
  double smallest = 1e9, widest = 0.0;
  for (const DrivenRobot& robot : driven_robots()) {
    const double radius = Vehicle(robot.parameters).min_turning_radius();
    smallest = std::min(smallest, radius), widest = std::max(widest, radius);
  }
  EXPECT_NEAR(smallest, 0.092, 0.001);
  EXPECT_NEAR(widest, 29.9, 0.1);
  const auto steers = [](Steering steering) {
    return std::ranges::any_of(driven_robots(), [=](const auto& r) { return r.parameters.steering == steering; });
  };
  EXPECT_TRUE(steers(Steering::kFront) && steers(Steering::kRear) && steers(Steering::kSymmetric));
}

TEST(DrivenWorld, IsTheSameForTheSameNameAndAnotherForAnotherSeed) {
  const auto made = catalog_driven_world("driven/carved/r3/g2/c2/s5");
  ASSERT_TRUE(made);
  const DrivenWorld same = generate_driven_world(
      {.kind = DrivenKind::kCarved, .robot = 3, .both_gears = true, .clearance = 0.002, .seed = 5});
  EXPECT_EQ(plan_to_json(plan_of_drive(*made), 0, made->robot), plan_to_json(plan_of_drive(same), 0, same.robot));
  const MapFile map = catalog_map("driven/carved/r3/g2/c2/s5");
  ASSERT_EQ(map.obstacles.size(), same.map.obstacles.size());
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) EXPECT_EQ(map.obstacles[i].outer, same.map.obstacles[i].outer);
  EXPECT_NE(catalog_map("driven/carved/r3/g2/c2/s6").goal->x, map.goal->x);
  EXPECT_FALSE(catalog_driven_world("clutter/convex"));
}

// Two draws in one call once came in the compiler's order.
TEST(ScatteredWorld, IsTheSameFromAllCompilers) {
  const DrivenWorld made = *catalog_driven_world("driven/scattered/r4/g2/c50/s5016");
  ASSERT_EQ(made.map.obstacles.size(), 50u);
  const Vec2& first = made.map.obstacles.front().outer.front();
  EXPECT_NEAR(first.x(), 0.954902, 1e-6);
  EXPECT_NEAR(first.y(), 5.617686, 1e-6);
}

TEST(DrivenWorld, RefusesWhatIsOutOfRange) {
  const auto message_of = [](std::string_view name) {
    try {
      (void)catalog_map(name);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(message_of("driven/rooms/r15"), "driven world: robot is 15, must be from 1 to 14");
  EXPECT_EQ(message_of("driven/rooms/r0"), "driven world: robot is 0, must be from 1 to 14");
  EXPECT_EQ(message_of("driven/rooms/c0"), "driven world: clearance is 0 m, must be from 1e-04 m to 10 m");
  EXPECT_EQ(message_of("driven/rooms/g3"), "catalog world \"driven/rooms/g3\": 3 gears, must be 1 or 2");
}

// A square that a turning body passes: only the nearest moment decides.
TEST(DriveClearance, DecidesByTheNearestMomentOfTheMotion) {
  const Vehicle body({.length = 3.0, .width = 1.0, .wheelbase = 1.0});  // 2 m ahead of F, 1 m behind
  const Path drive{{{0.0, 0.0, 0.0}, 6.0, 0.25, Gear::kForward}};
  const auto square_at = [](double x) { return Polygon{{{x, -0.1}, {x + 0.2, -0.1}, {x + 0.2, 0.1}, {x, 0.1}}, {}}; };
  // The front right corner is hypot(2, 4.5) from the center (0, 4), where it is nearest to the square's upper left
  // corner.
  const Vec2 center(0.0, 4.0);
  const double outer = std::hypot(2.0, 4.5);
  const double x = 4.0;
  const double gap = (Vec2(x, 0.1) - center).norm() - outer;
  ASSERT_GT(gap, 0.1);
  EXPECT_TRUE(detail::keeps_away(square_at(x), drive, body, gap - 1e-5));
  EXPECT_FALSE(detail::keeps_away(square_at(x), drive, body, gap + 1e-9));
  EXPECT_FALSE(detail::keeps_away(square_at(1.0), drive, body, 1e-3));
  EXPECT_FALSE(detail::keeps_away({{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, {}}, drive, body, 1e-3));
}

// A pole between the tines of a fork, and one that the bounding rectangle alone would meet.
TEST(DriveClearance, DecidesByTheOutline) {
  VehicleParameters parameters;
  parameters.footprint = {
      {{0.0, -0.5}, {1.0, -0.5}, {1.0, -0.3}, {0.3, -0.3}, {0.3, 0.3}, {1.0, 0.3}, {1.0, 0.5}, {0.0, 0.5}}};
  const Vehicle fork(parameters);
  const Path drive{{{0.0, 0.0, 0.0}, 0.2, 0.0, Gear::kForward}};
  const Polygon pole{{{0.8, -0.05}, {0.9, -0.05}, {0.9, 0.05}, {0.8, 0.05}}, {}};
  EXPECT_TRUE(detail::keeps_away(pole, drive, fork, 0.2));  // the tines are 0.25 m beside it
  EXPECT_FALSE(detail::keeps_away(pole, drive, fork, 0.26));
  const Path further{{{0.0, 0.0, 0.0}, 0.55, 0.0, Gear::kForward}};
  EXPECT_FALSE(detail::keeps_away(pole, further, fork, 0.01));  // the fork's back has come to it
}

TEST(DriveClearance, TheBoxContainsTheBodyAllAlongTheDrive) {
  for_all_worlds(0.05, [](const DrivenParameters&, const DrivenWorld& made) {
    const Footprint body = Vehicle(made.robot).footprint();
    const Box box = detail::box_of(made.drive, body, 0.25);
    const Polygon left{
        {{box.min.x() - 1, box.min.y()}, box.min, {box.min.x(), box.max.y()}, {box.min.x() - 1, box.max.y()}}, {}};
    const Polygon above{
        {{box.min.x(), box.max.y()}, box.max, {box.max.x(), box.max.y() + 1}, {box.min.x(), box.max.y() + 1}}, {}};
    EXPECT_TRUE(detail::keeps_away(left, made.drive, Vehicle(made.robot), 0.25));
    EXPECT_TRUE(detail::keeps_away(above, made.drive, Vehicle(made.robot), 0.25));
  });
}

}  // namespace
}  // namespace arcway::internal

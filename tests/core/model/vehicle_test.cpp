#include "arcway/vehicle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace arcway::internal {
namespace {

constexpr double kEighthTurn = std::numbers::pi / 4.0;

Vehicle with(void (*change)(VehicleParameters&)) {
  VehicleParameters parameters;
  change(parameters);
  return Vehicle(parameters);
}

std::string refusal_of(void (*change)(VehicleParameters&)) {
  try {
    with(change);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Vehicle, PapersRobotWithFrontSteering) {
  const Vehicle vehicle;
  EXPECT_DOUBLE_EQ(vehicle.reference_offset(), -0.65);
  EXPECT_DOUBLE_EQ(vehicle.min_turning_radius(), 1.3);
  const Footprint body = vehicle.footprint();
  EXPECT_DOUBLE_EQ(body.front, 1.4);
  EXPECT_NEAR(body.rear, 0.1, 1e-15);
  EXPECT_DOUBLE_EQ(body.left, 0.4);
  EXPECT_DOUBLE_EQ(body.right, 0.4);
  const SweptAnnulus swept = swept_annulus(body, Side::kLeft, 1.3);
  EXPECT_DOUBLE_EQ(swept.inner, 0.9);
  EXPECT_DOUBLE_EQ(swept.outer, std::sqrt(1.4 * 1.4 + 1.7 * 1.7));
}

TEST(Vehicle, PapersRobotWithRearSteering) {
  const Vehicle vehicle = with([](VehicleParameters& p) { p.steering = Steering::kRear; });
  EXPECT_DOUBLE_EQ(vehicle.reference_offset(), 0.65);
  EXPECT_DOUBLE_EQ(vehicle.min_turning_radius(), 1.3);
  EXPECT_NEAR(vehicle.footprint().front, 0.1, 1e-15);
  EXPECT_DOUBLE_EQ(vehicle.footprint().rear, 1.4);
  EXPECT_DOUBLE_EQ(swept_annulus(vehicle.footprint(), Side::kLeft, 1.3).outer, std::sqrt(1.4 * 1.4 + 1.7 * 1.7));
}

TEST(Vehicle, PapersRobotWithSymmetricSteering) {
  const Vehicle vehicle = with([](VehicleParameters& p) { p.steering = Steering::kSymmetric; });
  EXPECT_EQ(vehicle.reference_offset(), 0.0);
  EXPECT_DOUBLE_EQ(vehicle.min_turning_radius(), 0.65);
  EXPECT_DOUBLE_EQ(vehicle.footprint().front, 0.75);
  EXPECT_DOUBLE_EQ(vehicle.footprint().rear, 0.75);
  EXPECT_DOUBLE_EQ(swept_annulus(vehicle.footprint(), Side::kLeft, 0.65).inner, 0.25);
  EXPECT_DOUBLE_EQ(swept_annulus(vehicle.footprint(), Side::kLeft, 0.65).outer, std::hypot(0.75, 1.05));
}

TEST(Vehicle, IsTheSameIfAllParametersAre) {
  VehicleParameters parameters;
  parameters.turn_speed = TurnSpeedTable{{{1.5, 2.0}, {6.0, 5.0}}};
  const Vehicle vehicle(parameters);
  EXPECT_EQ(Vehicle(parameters), vehicle);
  parameters.max_reverse_speed = 1.0;
  EXPECT_NE(Vehicle(parameters), vehicle);
  EXPECT_EQ(Vehicle(parameters).with_gears_swapped().with_gears_swapped(), Vehicle(parameters));
  parameters.max_reverse_speed.reset();
  parameters.turn_speed = TurnSpeedTable{{{1.5, 2.0}, {6.0, 5.5}}};
  EXPECT_NE(Vehicle(parameters), vehicle);
  parameters.turn_speed = ConstantTurnSpeed{2.0};
  EXPECT_NE(Vehicle(parameters), vehicle);
}

TEST(Vehicle, FootprintGrowsOnEverySide) {
  const Footprint body = Vehicle().footprint(0.5);
  EXPECT_DOUBLE_EQ(body.front, 1.9);
  EXPECT_DOUBLE_EQ(body.rear, 0.6);
  EXPECT_DOUBLE_EQ(body.left, 0.9);
  EXPECT_DOUBLE_EQ(body.right, 0.9);
}

TEST(Vehicle, OverhangsAreMeasuredFromTheAxles) {
  VehicleParameters parameters{.wheelbase = 2.5, .front_overhang = 0.75, .rear_overhang = 0.5};
  EXPECT_EQ(Vehicle(parameters).footprint().front, 3.25);  // F lies on the rear axle
  EXPECT_EQ(Vehicle(parameters).footprint().rear, 0.5);
  EXPECT_EQ(Vehicle(parameters).footprint(0.25).rear, 0.75);
  EXPECT_EQ(Vehicle(parameters).footprint().left, 0.4);
  parameters.steering = Steering::kRear;
  EXPECT_EQ(Vehicle(parameters).footprint().front, 0.75);
  EXPECT_EQ(Vehicle(parameters).footprint().rear, 3.0);
  parameters.steering = Steering::kSymmetric;
  EXPECT_EQ(Vehicle(parameters).footprint().front, 2.0);
  EXPECT_EQ(Vehicle(parameters).footprint().rear, 1.75);
}

TEST(Vehicle, FootprintIsAboutItsOrigin) {
  VehicleParameters parameters;
  parameters.footprint = {{{0.5, 0.0}, {0.0, 0.25}, {-0.5, 0.0}, {0.0, -0.25}}};
  parameters.footprint_origin = {0.25, 0.125};
  const Vehicle vehicle(parameters);
  ASSERT_NE(vehicle.shape(), nullptr);
  EXPECT_EQ(vehicle.footprint().front, 0.75);
  EXPECT_EQ(vehicle.footprint().rear, 0.25);
  EXPECT_EQ(vehicle.footprint().left, 0.375);
  EXPECT_EQ(vehicle.footprint().right, 0.125);
  EXPECT_EQ(vehicle.outline().front().front(), Vec2(0.75, 0.125));
  EXPECT_EQ(vehicle.body(0.1).shape, vehicle.body(0.1).shape);
  EXPECT_NE(vehicle.body(0.1).shape, vehicle.body(0.2).shape);
  EXPECT_GT(vehicle.footprint(0.1).front, 0.85);  // the miter of an acute corner
  EXPECT_TRUE(vehicle.body().covers_reference());
  EXPECT_TRUE(vehicle.body().covers({0.7, 0.125}));
  EXPECT_FALSE(vehicle.body().covers({0.7, 0.2}));
  const Vehicle swapped = vehicle.with_gears_swapped();
  EXPECT_EQ(swapped.body(0.1).shape, vehicle.body(0.1).shape);
  parameters.footprint_origin = {0.5, 0.125};
  EXPECT_NE(Vehicle(parameters), vehicle);
}

TEST(Vehicle, IsTheSameWhateverTheBodyTakesThePlaceOf) {
  VehicleParameters parameters;
  parameters.footprint = {{{0, 0}, {1, 0}, {0, 1}}};
  VehicleParameters other = parameters;
  other.length = 3.0, other.width = 2.0;
  EXPECT_EQ(Vehicle(other), Vehicle(parameters));
}

TEST(Vehicle, RefusalsOfBodiesNameTheParameter) {
  EXPECT_EQ(refusal_of([](VehicleParameters& p) { p.front_overhang = 0.5; }),
            "vehicle: rear_overhang is missing, give both overhangs or neither");
  EXPECT_EQ(refusal_of([](VehicleParameters& p) { p.rear_overhang = 0.5; }),
            "vehicle: front_overhang is missing, give both overhangs or neither");
  EXPECT_EQ(refusal_of([](VehicleParameters& p) { p.front_overhang = 0.5, p.rear_overhang = 1e51; }),
            "vehicle: rear_overhang is 1e+51, must be of a magnitude up to 1e+50");
  EXPECT_EQ(
      refusal_of([](VehicleParameters& p) { p.wheelbase = 1.0, p.front_overhang = -1.0, p.rear_overhang = -0.5; }),
      "vehicle: front_overhang + wheelbase + rear_overhang is -0.5, must be from 1e-50 to 1e+50");
  EXPECT_EQ(refusal_of([](VehicleParameters& p) {
              p.footprint = {{{0, 0}, {1, 0}, {0, 1}}};
              p.footprint_origin.x() = std::numeric_limits<double>::quiet_NaN();
            }),
            "vehicle: footprint_origin is nan, must be of a magnitude up to 1e+50");
  EXPECT_EQ(refusal_of([](VehicleParameters& p) {
              p.footprint = {{{0, 0}, {1, 0}, {0, 1}}};
              p.front_overhang = p.rear_overhang = 0.5;
            }),
            "vehicle: both footprint and overhangs are given, leave one out");
  EXPECT_EQ(refusal_of([](VehicleParameters& p) {
              p.footprint = {{{0, 0}, {1, 0}}};
            }),
            "vehicle: footprint[0] has 2 corners, must have >= 3");
}

TEST(RotationCenter, LiesOnTheAxleThatDoesNotSteer) {
  const Vec2 front = rotation_center(1.3, kEighthTurn, 0.0).value();
  EXPECT_NEAR(front.x(), -0.65, 1e-15);
  EXPECT_NEAR(front.y(), 1.3, 1e-15);
  const Vec2 rear = rotation_center(1.3, 0.0, -kEighthTurn).value();
  EXPECT_NEAR(rear.x(), 0.65, 1e-15);
  EXPECT_NEAR(rear.y(), 1.3, 1e-15);
  const Vec2 symmetric = rotation_center(1.3, kEighthTurn, -kEighthTurn).value();
  EXPECT_NEAR(symmetric.x(), 0.0, 1e-15);
  EXPECT_NEAR(symmetric.y(), 0.65, 1e-15);
  EXPECT_LT(rotation_center(1.3, -kEighthTurn, 0.0).value().y(), 0.0);
  EXPECT_FALSE(rotation_center(1.3, 0.0, 0.0));
  EXPECT_FALSE(rotation_center(1.3, 0.3, 0.3));
}

// The wheels of both axles roll about the center of (1): their axles' lines meet there.
TEST(RotationCenter, IsWhereTheAxlesMeet) {
  const double alpha = 0.5;
  const double beta = -0.2;
  const Vec2 center = rotation_center(1.3, alpha, beta).value();
  EXPECT_NEAR((center - Vec2(0.65, 0.0)).dot(direction_of(alpha)), 0.0, 1e-14);
  EXPECT_NEAR((center - Vec2(-0.65, 0.0)).dot(direction_of(beta)), 0.0, 1e-14);
}

// (5) has l where (1) gives l/2: 1.43 instead of 1.30 for the paper's robot at 45 degrees.
TEST(PaperSlips, SweptWidthHasHalfTheWheelbase) {
  const double a = 0.75;
  const double b = 0.4;
  const double l = 1.3;
  const double printed = std::hypot(a + l, b + 2.0 * l) - (2.0 * l - b);
  EXPECT_NEAR(printed, 1.43, 0.005);
  const Vec2 center = rotation_center(l, kEighthTurn, 0.0).value();
  const double derived = (Vec2(a, -b) - center).norm() - (center.y() - b);
  EXPECT_NEAR(derived, 1.30, 0.005);
  EXPECT_NEAR(swept_annulus(Vehicle().footprint(), Side::kLeft, 1.3).width(), derived, 1e-15);
}

// F is at (x_o, 0): with front steering the point of the rear axle moves along the body, not that of the front axle.
TEST(PaperSlips, ReferencePointIsBelowTheRotationCenter) {
  const Vec2 center = rotation_center(1.3, kEighthTurn, 0.0).value();
  const Vec2 printed(-center.x(), 0.0);
  const Vec2 corrected(center.x(), 0.0);
  EXPECT_DOUBLE_EQ(corrected.x(), Vehicle().reference_offset());
  EXPECT_NEAR(perpendicular(corrected - center).y(), 0.0, 1e-15);  // no velocity across the body
  EXPECT_GT(std::abs(perpendicular(printed - center).y()), 1.0);
}

// rho_min = l/2 tan(gamma) must be l/(2 tan(gamma)): a tighter lock turns in less room.
TEST(PaperSlips, TighterLockTurnsInLessRoom) {
  const Vehicle slack =
      with([](VehicleParameters& p) { p.steering = Steering::kSymmetric, p.max_steering_angle = 0.3; });
  const Vehicle tight =
      with([](VehicleParameters& p) { p.steering = Steering::kSymmetric, p.max_steering_angle = 0.6; });
  EXPECT_LT(tight.min_turning_radius(), slack.min_turning_radius());
  EXPECT_NEAR(tight.min_turning_radius(), rotation_center(1.3, 0.6, -0.6).value().y(), 1e-15);
  EXPECT_GT(1.3 / 2.0 * std::tan(0.6), 1.3 / 2.0 * std::tan(0.3));  // as printed it grows with the lock
}

TEST(SweptAnnulus, IsThatOfTheBodysOutline) {
  for (const Footprint& body :
       {Footprint{1.4, 0.1, 0.4, 0.4}, Footprint{2.0, -0.3, 0.4, 0.4}, Footprint{-0.2, 3.0, 0.5, 0.5},
        Footprint{1.4, 0.1, 0.9, 0.2}, Footprint{-0.2, 3.0, 0.1, 0.6}, Footprint{1.0, 0.4, -0.5, 1.2},
        Footprint{1.0, -0.4, 1.2, -0.5}}) {
    for (const auto& [radius, side] : {std::pair(0.1, Side::kLeft),
                                       {0.45, Side::kRight},
                                       {0.7, Side::kLeft},
                                       {0.7, Side::kRight},
                                       {3.0, Side::kLeft},
                                       {3.0, Side::kRight}}) {
      double inner = std::numeric_limits<double>::infinity();
      double outer = 0.0;
      for (int i = 0; i <= 1000; ++i) {
        for (int j = 0; j <= 200; ++j) {
          const double x = -body.rear + body.length() * i / 1000.0;
          const double y = -body.right + body.width() * j / 200.0;
          const double distance = std::hypot(x, y - sign_of(side) * radius);
          inner = std::min(inner, distance);
          outer = std::max(outer, distance);
        }
      }
      EXPECT_NEAR(swept_annulus(body, side, radius).inner, inner, 5e-3);
      EXPECT_NEAR(swept_annulus(body, side, radius).outer, outer, 1e-12);
    }
  }
}

// Values of the definition, by trial.
TEST(Passage, BySideIsThatOfTheSweptAnnulus) {
  const Vehicle vehicle({.max_steering_angle = 0.6, .max_steering_angle_right = 0.4});
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const double smallest = vehicle.min_turning_radius(side);
    for (const double radius : {smallest, 2.0 * smallest, 9.0}) {
      const double needed = swept_annulus(vehicle.footprint(), side, radius).width();
      EXPECT_TRUE(vehicle.fits_turn(1.0001 * needed, radius, side));
      EXPECT_FALSE(vehicle.fits_turn(0.9999 * needed, radius, side));
    }
    EXPECT_EQ(vehicle.smallest_fitting_radius(3.0, side), smallest);
  }
  EXPECT_LT(vehicle.min_turning_radius(Side::kLeft), vehicle.min_turning_radius(Side::kRight));
  EXPECT_EQ(vehicle.min_turning_radius(), vehicle.min_turning_radius(Side::kLeft));
}

TEST(Vehicle, TurnsByRadiiInPlaceOfAngles) {
  const Vehicle both({.min_turning_radius = 2.5});
  EXPECT_EQ(both.min_turning_radius(Side::kLeft), 2.5);
  EXPECT_EQ(both.min_turning_radius(Side::kRight), 2.5);
  EXPECT_EQ(both.footprint().front, Vehicle().footprint().front);
  const Vehicle uneven({.min_turning_radius = 2.5, .min_turning_radius_right = 1.5});
  EXPECT_EQ(uneven.min_turning_radius(Side::kLeft), 2.5);
  EXPECT_EQ(uneven.min_turning_radius(Side::kRight), 1.5);
  EXPECT_EQ(uneven.min_turning_radius(), 1.5);
  EXPECT_EQ(uneven.with_gears_swapped().min_turning_radius(Side::kRight), 1.5);
  EXPECT_NE(to_string(uneven).find("turning radius 2.5 m to the left and 1.5 m to the right, "), std::string::npos);
  EXPECT_NE(uneven, both);
  EXPECT_NO_THROW(Vehicle({.wheelbase = 1.0, .max_steering_angle = std::atan(0.5), .min_turning_radius = 2.0}));
}

TEST(Vehicle, RefusesLimitsOfSteeringThatContradictEachOther) {
  const auto message = [](const VehicleParameters& parameters) -> std::string {
    try {
      Vehicle{parameters};
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message({.max_steering_angle_right = 1.6}),
            "vehicle: max_steering_angle_right is 1.6, must be >= 1e-50 and < pi/2 rad");
  EXPECT_EQ(message({.min_turning_radius = -2.0}), "vehicle: min_turning_radius is -2, must be from 1e-50 to 1e+50");
  EXPECT_EQ(message({.min_turning_radius = 2.0, .min_turning_radius_right = 0.0}),
            "vehicle: min_turning_radius_right is 0, must be from 1e-50 to 1e+50");
  EXPECT_EQ(message({.min_turning_radius_right = 3.0}),
            "vehicle: min_turning_radius_right is 3 without min_turning_radius; give both, or max_steering_angle_right "
            "instead");
  EXPECT_EQ(message({.wheelbase = 1.0, .max_steering_angle = 0.5, .min_turning_radius = 3.0}).substr(0, 78),
            "vehicle: min_turning_radius is 3, but max_steering_angle of 0.5 leads to 1.830");
  EXPECT_EQ(message({.wheelbase = 1.0, .max_steering_angle_right = 0.5, .min_turning_radius = 3.0}).substr(0, 66),
            "vehicle: min_turning_radius_right is 3, but max_steering_angle_rig");
}

TEST(Passage, OfATurnAboutAPlaceWithinTheBody) {
  VehicleParameters parameters;
  parameters.width = 4.0;
  parameters.wheelbase = 0.5;
  const Vehicle vehicle(parameters);
  const double radius = vehicle.min_turning_radius();
  const double needed = swept_annulus(vehicle.footprint(), Side::kLeft, radius).width();
  ASSERT_LT(radius, 2.0);
  EXPECT_TRUE(vehicle.fits_turn(1.0001 * needed, radius, Side::kLeft));
  EXPECT_FALSE(vehicle.fits_turn(0.9999 * needed, radius, Side::kLeft));
}

TEST(Passage, StraightNeedsMoreThanTheWidth) {
  EXPECT_FALSE(Vehicle().fits_straight(0.8));
  EXPECT_TRUE(Vehicle().fits_straight(std::nextafter(0.8, 1.0)));
  EXPECT_FALSE(Vehicle().fits_straight(std::numeric_limits<double>::quiet_NaN()));
}

TEST(Passage, TurnNeedsMoreThanTheSweptWidth) {
  EXPECT_FALSE(Vehicle().fits_turn(1.302, 1.3, Side::kLeft));
  EXPECT_TRUE(Vehicle().fits_turn(1.303, 1.3, Side::kLeft));
  EXPECT_FALSE(Vehicle().fits_turn(0.8, 1e9, Side::kLeft));
  EXPECT_TRUE(Vehicle().fits_turn(0.8 + 1e-9, 1.0e9, Side::kLeft));  // w_s - 2b = 9.8e-10 there
  EXPECT_FALSE(Vehicle().fits_turn(0.8 + 9e-10, 1.0e9, Side::kLeft));
}

TEST(Passage, NarrowerOnesNeedLargerRadii) {
  const Vehicle vehicle;
  EXPECT_FALSE(vehicle.smallest_fitting_radius(0.8, Side::kLeft));
  EXPECT_DOUBLE_EQ(vehicle.smallest_fitting_radius(2.0, Side::kLeft).value(), 1.3);
  // hypot(1.4, r + 0.4) = 1 + r - 0.4  =>  1.96 = (1 - 0.8) (2 r + 1)
  EXPECT_NEAR(vehicle.smallest_fitting_radius(1.0, Side::kLeft).value(), 4.4, 1e-14);
  double last = 1.3;
  for (const double width : {1.2, 1.1, 1.0, 0.9, 0.81, 0.8001, 0.8 + 1e-9}) {
    const double radius = vehicle.smallest_fitting_radius(width, Side::kLeft).value();
    EXPECT_GT(radius, last);
    EXPECT_TRUE(vehicle.fits_turn(width, radius * (1.0 + 1e-14), Side::kLeft));
    EXPECT_FALSE(vehicle.fits_turn(width, radius * (1.0 - 1e-14), Side::kLeft));
    last = radius;
  }
}

TEST(Passage, ReferencePointOffTheBody) {
  const Vehicle vehicle = with([](VehicleParameters& p) { p.wheelbase = 2.5, p.max_steering_angle = 1.2; });
  EXPECT_LT(vehicle.footprint().rear, 0.0);
  for (const double width : {1.5, 1.2, 1.0, 0.9, 0.81, 0.8001}) {
    const double radius = vehicle.smallest_fitting_radius(width, Side::kLeft).value();
    EXPECT_TRUE(vehicle.fits_turn(width, radius * (1.0 + 1e-11), Side::kLeft));
    if (radius > vehicle.min_turning_radius()) {
      EXPECT_FALSE(vehicle.fits_turn(width, radius * (1.0 - 1e-11), Side::kLeft));
    }
    for (double larger = radius * 1.01; larger < 1e4; larger *= 1.3)
      EXPECT_TRUE(vehicle.fits_turn(width, larger, Side::kLeft));
  }
}

TEST(Passage, EveryLargerRadiusFitsWhereTheCenterLiesInTheBody) {
  const Vehicle vehicle = with([](VehicleParameters& p) { p.max_steering_angle = 1.4; });
  ASSERT_LT(vehicle.min_turning_radius(), 0.4);
  for (const double width : {1.8, 1.6, 1.55, 1.2}) {
    const double radius = vehicle.smallest_fitting_radius(width, Side::kLeft).value();
    for (double larger = radius * 1.0001; larger < 1e4; larger *= 1.1)
      EXPECT_TRUE(vehicle.fits_turn(width, larger, Side::kLeft));
  }
}

TEST(TurnSpeed, FollowsItsLawUpToTheTopSpeed) {
  EXPECT_EQ(Vehicle().turn_speed(1.3), 8.0);
  EXPECT_EQ(with([](VehicleParameters& p) { p.turn_speed = ConstantTurnSpeed{20.0}; }).turn_speed(1.3), 12.0);
  const Vehicle lateral = with([](VehicleParameters& p) { p.turn_speed = LateralAccelerationLimit{2.0}; });
  EXPECT_DOUBLE_EQ(lateral.turn_speed(8.0), 4.0);
  EXPECT_EQ(lateral.turn_speed(1e6), 12.0);
  const Vehicle table = with([](VehicleParameters& p) { p.turn_speed = TurnSpeedTable{{{2.0, 3.0}, {4.0, 7.0}}}; });
  EXPECT_EQ(table.turn_speed(1.0), 3.0);
  EXPECT_EQ(table.turn_speed(2.0), 3.0);
  EXPECT_DOUBLE_EQ(table.turn_speed(3.0), 5.0);
  EXPECT_EQ(table.turn_speed(4.0), 7.0);
  EXPECT_EQ(table.turn_speed(9.0), 7.0);
}

TEST(Vehicle, ReverseHasASpeedLimitOfItsOwn) {
  const Vehicle plain({.max_speed = 6.0, .turn_speed = LateralAccelerationLimit{2.0}});
  EXPECT_EQ(plain.max_reverse_speed(), 6.0);
  EXPECT_EQ(plain.reverse_turn_speed(2.0), plain.turn_speed(2.0));
  const Vehicle slow({.max_speed = 6.0, .turn_speed = LateralAccelerationLimit{2.0}, .max_reverse_speed = 3.0});
  EXPECT_EQ(slow.max_reverse_speed(), 3.0);
  EXPECT_DOUBLE_EQ(slow.reverse_turn_speed(2.0), 2.0);
  EXPECT_EQ(slow.reverse_turn_speed(8.0), 3.0);
  EXPECT_DOUBLE_EQ(slow.turn_speed(8.0), 4.0);
  EXPECT_EQ(slow.top_speed(), 6.0);
  const Vehicle swapped = slow.with_gears_swapped();
  EXPECT_EQ(swapped.max_speed(), 3.0);
  EXPECT_EQ(swapped.top_speed(), 6.0);
  EXPECT_EQ(swapped.turn_speed(8.0), 3.0);
  EXPECT_DOUBLE_EQ(swapped.reverse_turn_speed(8.0), 4.0);
}

TEST(Vehicle, RefusesParametersByNameValueAndLimit) {
  using P = VehicleParameters;
  EXPECT_EQ(refusal_of([](P& p) { p.length = 0.0; }), "vehicle: length is 0, must be from 1e-50 to 1e+50");
  EXPECT_EQ(refusal_of([](P& p) { p.width = -1.5; }), "vehicle: width is -1.5, must be from 1e-50 to 1e+50");
  EXPECT_EQ(refusal_of([](P& p) { p.wheelbase = std::nan(""); }),
            "vehicle: wheelbase is nan, must be from 1e-50 to 1e+50");
  EXPECT_EQ(refusal_of([](P& p) { p.max_steering_angle = 0.0; }),
            "vehicle: max_steering_angle is 0, must be >= 1e-50 and < pi/2 rad");
  EXPECT_EQ(refusal_of([](P& p) { p.max_steering_angle = 1.6; }),
            "vehicle: max_steering_angle is 1.6, must be >= 1e-50 and < pi/2 rad");
  EXPECT_EQ(refusal_of([](P& p) { p.max_steering_angle = std::nan(""); }),
            "vehicle: max_steering_angle is nan, must be >= 1e-50 and < pi/2 rad");
  EXPECT_EQ(refusal_of([](P& p) { p.max_speed = std::numeric_limits<double>::infinity(); }),
            "vehicle: max_speed is inf, must be from 1e-50 to 1e+50");
  EXPECT_EQ(refusal_of([](P& p) { p.max_reverse_speed = 0.0; }),
            "vehicle: max_reverse_speed is 0, must be from 1e-50 to 1e+50");
  EXPECT_EQ(refusal_of([](P& p) { p.max_acceleration = 0.0; }),
            "vehicle: max_acceleration is 0, must be from 1e-50 to 1e+50");
  EXPECT_EQ(refusal_of([](P& p) { p.safety_margin = 0.0; }),
            "vehicle: safety_margin is 0, must be from 1e-50 to 1e+50");
  EXPECT_EQ(refusal_of([](P& p) { p.width = 1e51; }), "vehicle: width is 1e+51, must be from 1e-50 to 1e+50");
  EXPECT_EQ(refusal_of([](P& p) { p.max_speed = 1e-308; }),
            "vehicle: max_speed is 1e-308, must be from 1e-50 to 1e+50");
  EXPECT_EQ(refusal_of([](P& p) { p.turn_speed = ConstantTurnSpeed{0.0}; }),
            "vehicle: turn_speed.speed is 0, must be from 1e-50 to 1e+50");
  EXPECT_EQ(refusal_of([](P& p) { p.turn_speed = LateralAccelerationLimit{-1.0}; }),
            "vehicle: turn_speed.lateral_acceleration is -1, must be from 1e-50 to 1e+50");
  EXPECT_EQ(refusal_of([](P& p) { p.turn_speed = TurnSpeedTable{}; }),
            "vehicle: turn_speed.entries has 0 entries, must have >= 1");
  EXPECT_EQ(refusal_of([](P& p) {
              p.turn_speed = TurnSpeedTable{{{2.0, 3.0}, {2.0, 4.0}}};
            }),
            "vehicle: turn_speed.entries[1].radius is 2, must be finite and > 2");
  EXPECT_EQ(refusal_of([](P& p) {
              p.turn_speed = TurnSpeedTable{{{0.0, 3.0}}};
            }),
            "vehicle: turn_speed.entries[0].radius is 0, must be finite and > 0");
  EXPECT_EQ(refusal_of([](P& p) {
              p.turn_speed = TurnSpeedTable{{{2.0, 0.0}}};
            }),
            "vehicle: turn_speed.entries[0].speed is 0, must be from 1e-50 to 1e+50");
}

TEST(Vehicle, SteersToTheSideOfTheTurn) {
  VehicleParameters parameters;
  EXPECT_DOUBLE_EQ(Vehicle(parameters).steering_angle(0.5), std::atan(0.65));
  parameters.steering = Steering::kRear;
  EXPECT_DOUBLE_EQ(Vehicle(parameters).steering_angle(0.5), -std::atan(0.65));
  parameters.steering = Steering::kSymmetric;
  EXPECT_DOUBLE_EQ(Vehicle(parameters).steering_angle(-0.5), -std::atan(0.325));
  EXPECT_EQ(Vehicle(parameters).steering_angle(0.0), 0.0);
}

}  // namespace
}  // namespace arcway::internal

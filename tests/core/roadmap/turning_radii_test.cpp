#include "arcway/turning_radii.h"

#include <gtest/gtest.h>

#include <cmath>

namespace arcway::internal {
namespace {

World field(double side) { return World({}, Ring{{0, 0}, {side, 0}, {side, side}, {0, side}}); }

TEST(TurningRadii, IsTheSmallestAloneWhereAWiderTurnIsNoFaster) {
  const Vehicle vehicle;
  EXPECT_EQ(turning_radii(vehicle, field(100)), std::vector<double>{vehicle.min_turning_radius()});
}

TEST(TurningRadii, DoubleUntilTheTopSpeedIsReached) {
  VehicleParameters parameters;
  parameters.turn_speed = LateralAccelerationLimit{8.0};
  const Vehicle vehicle(parameters);
  const std::vector<double> radii = turning_radii(vehicle, field(1000));
  ASSERT_EQ(radii.size(), 5u);
  for (std::size_t i = 0; i + 1 < 4; ++i) EXPECT_DOUBLE_EQ(radii[i + 1], 2.0 * radii[i]);
  EXPECT_NEAR(radii.back(), 18.0, 1e-6);  // v_ms^2 / a_lat
  EXPECT_DOUBLE_EQ(vehicle.turn_speed(radii.back()), vehicle.max_speed());
}

TEST(TurningRadii, GrowFasterWhereThereIsFurtherToGo) {
  VehicleParameters parameters;
  parameters.turn_speed = LateralAccelerationLimit{2.0};
  const std::vector<double> radii = turning_radii(Vehicle(parameters), field(1000));
  ASSERT_EQ(radii.size(), 5u);
  for (std::size_t i = 0; i + 1 < radii.size(); ++i)
    EXPECT_NEAR(radii[i + 1] / radii[i], std::pow(72.0 / 1.3, 0.25), 1e-6);
  EXPECT_NEAR(radii.back(), 72.0, 1e-6);
}

TEST(TurningRadii, EndWithTheMapAndWithTheTable) {
  VehicleParameters parameters;
  parameters.turn_speed = LateralAccelerationLimit{2.0};
  EXPECT_NEAR(turning_radii(Vehicle(parameters), field(20.0)).back(), 10.0 * std::sqrt(2.0), 1e-9);
  EXPECT_EQ(turning_radii(Vehicle(parameters), World({})).size(), 1u);
  parameters.turn_speed = TurnSpeedTable{{{1.3, 2.0}, {4.0, 5.0}}};
  EXPECT_NEAR(turning_radii(Vehicle(parameters), field(1000)).back(), 4.0, 1e-6);
  parameters.turn_speed = TurnSpeedTable{{{1.0, 2.0}, {10.0, 5.0}, {20.0, 3.0}}};  // beyond 10 m slower again
  EXPECT_NEAR(turning_radii(Vehicle(parameters), field(1000)).back(), 10.0, 1e-6);
  parameters.turn_speed = TurnSpeedTable{{{1.0, 2.0}, {10.0, 5.0}, {20.0, 1.0}}};
  EXPECT_NEAR(turning_radii(Vehicle(parameters), field(1000)).back(), 10.0, 1e-6);
}

VehicleParameters turning_within(double radius) {
  VehicleParameters parameters;
  parameters.max_steering_angle = std::atan(parameters.wheelbase / radius);
  return parameters;
}

TEST(TurningRadii, HaveOneThatLeadsRoundVertices) {
  const Vehicle vehicle(turning_within(0.3));
  const std::vector<double> radii = turning_radii(vehicle, field(100));
  ASSERT_EQ(radii.size(), 2u);
  EXPECT_DOUBLE_EQ(radii[0], vehicle.min_turning_radius());
  EXPECT_GT(radii[1], 0.5 * vehicle.parameters().width);
  EXPECT_EQ(turning_radii(Vehicle(turning_within(0.45)), field(100)).size(), 1u);
}

TEST(TightestRadii, EndWithTheFirstThatLeadsRoundVertices) {
  const Vehicle vehicle;  // 0.8 m wide
  const Footprint body = vehicle.footprint(vehicle.safety_margin());
  EXPECT_EQ(tightest_radii(body, std::vector{1.3}), 1u);
  EXPECT_EQ(tightest_radii(body, std::vector{1.3, 2.6}), 1u);
  EXPECT_EQ(tightest_radii(body, std::vector{0.1, 0.3, 0.5, 0.7}), 3u);
  EXPECT_EQ(tightest_radii(body, std::vector{0.1, 0.3}), 2u);
  // With the margin the body covers the middle of a circle of half its width.
  EXPECT_EQ(tightest_radii(body, std::vector{0.4, 0.5}), 2u);
}

}  // namespace
}  // namespace arcway::internal

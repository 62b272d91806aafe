#pragma once

#include <string>

#include "arcway/vehicle.h"

namespace arcway::internal::bench {

/// The paper's robot with limits on its acceleration, sideways and along [m/s^2]: wider turns are faster, so that
/// circles of several radii matter.
struct GentleRobot {
  int lateral_acceleration, acceleration;
  [[nodiscard]] std::string name() const {
    return "lateral" + std::to_string(lateral_acceleration) + "_along" + std::to_string(acceleration);
  }
  [[nodiscard]] Vehicle vehicle() const {
    return Vehicle(
        {.turn_speed = LateralAccelerationLimit{1.0 * lateral_acceleration}, .max_acceleration = 1.0 * acceleration});
  }
};
inline constexpr GentleRobot kGentleRobots[] = {{2, 2}, {4, 2}, {8, 4}};

/// A robot for rooms, of the size of a vacuum cleaner: for grid maps of cells of 1 m.
inline Vehicle small_robot() {
  return Vehicle({.length = 0.3,
                  .width = 0.2,
                  .wheelbase = 0.2,
                  .max_steering_angle = 0.75,
                  .max_speed = 0.5,
                  .turn_speed = ConstantTurnSpeed{0.3},
                  .max_acceleration = 1.0});
}

/// A passenger car in a town.
inline Vehicle town_car() {
  return Vehicle({.length = 4.72,
                  .width = 1.94,
                  .wheelbase = 2.8,
                  .max_steering_angle = 0.75,
                  .max_speed = 14.0,
                  .turn_speed = ConstantTurnSpeed{4.0},
                  .max_acceleration = 2.0});
}

/// A boat of 12 m with its rudder at the stern.
inline Vehicle boat() {
  return Vehicle({.length = 12.0,
                  .width = 4.0,
                  .wheelbase = 10.0,
                  .steering = Steering::kRear,
                  .max_steering_angle = 0.6,
                  .max_speed = 10.0,
                  .turn_speed = ConstantTurnSpeed{5.0},
                  .max_acceleration = 0.5});
}

/// A robot whose turns of any radius are as fast as its tightest ones. The given robot can drive all of its paths, and
/// wider turns bring it nothing.
inline Vehicle without_faster_turns(const Vehicle& vehicle) {
  VehicleParameters parameters = vehicle.parameters();
  parameters.turn_speed = ConstantTurnSpeed{vehicle.turn_speed(vehicle.min_turning_radius())};
  return Vehicle(parameters);
}

}  // namespace arcway::internal::bench

#pragma once

#include <string>

#include "core/vehicle.h"

namespace arcway::bench {

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

/// The robot whose turns of any radius are as fast as its tightest ones: what it drives, the given one drives as well,
/// and has no use for wide turns.
inline Vehicle without_faster_turns(const Vehicle& vehicle) {
  VehicleParameters parameters = vehicle.parameters();
  parameters.turn_speed = ConstantTurnSpeed{vehicle.turn_speed(vehicle.min_turning_radius())};
  return Vehicle(parameters);
}

}  // namespace arcway::bench

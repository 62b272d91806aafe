#pragma once

#include "core/vehicle.h"

namespace arcway::bench {

/// The paper's robot with limits on its acceleration, sideways and along [m/s^2]: wider turns are faster, so that
/// circles of several radii matter.
inline Vehicle gentle_robot(double lateral_acceleration, double acceleration) {
  return Vehicle({.turn_speed = LateralAccelerationLimit{lateral_acceleration}, .max_acceleration = acceleration});
}

/// The robot whose turns of any radius are as fast as its tightest ones: what it drives, the given one drives as well,
/// and has no use for wide turns.
inline Vehicle without_faster_turns(const Vehicle& vehicle) {
  VehicleParameters parameters = vehicle.parameters();
  parameters.turn_speed = ConstantTurnSpeed{vehicle.turn_speed(vehicle.min_turning_radius())};
  return Vehicle(parameters);
}

}  // namespace arcway::bench

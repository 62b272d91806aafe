#pragma once

#include "arcway/vehicle.h"

namespace arcway::internal {

/// The length of what bounds the body [m], as it is given where it is.
inline double body_length(const Vehicle& vehicle) {
  const VehicleParameters& p = vehicle.parameters();
  return p.front_overhang || !p.footprint.empty() ? vehicle.footprint().length() : p.length;
}

/// The width of what bounds the body [m], as it is given where it is.
inline double body_width(const Vehicle& vehicle) {
  const VehicleParameters& p = vehicle.parameters();
  return p.footprint.empty() ? p.width : vehicle.footprint().width();
}

}  // namespace arcway::internal

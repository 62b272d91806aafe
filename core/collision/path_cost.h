#pragma once

#include <span>

#include "arcway/path.h"
#include "arcway/vehicle.h"
#include "core/base/infinity.h"
#include "core/collision/clearance_cost.h"
#include "core/motion/end_speeds.h"
#include "core/motion/speed_profile.h"
#include "core/zones/speed_zones.h"

namespace arcway::internal {

/// What the cost of a path depends on, beside the vehicle.
struct PathCosts {
  EndSpeeds ends = {};
  const SpeedZones* zones = nullptr;         ///< whose limits hold; may be null
  const ClearanceCost* clearance = nullptr;  ///< of driving close to obstacles; may be null
  double cusp_cost = 0.0;                    ///< of each gear change, beside the time for it [s]
};

/// The cost of a path [s]: its travel time, plus that of gear changes and of driving close to obstacles. Infinity if no
/// motion along the path has these end speeds.
/// @param profile  filled with the speeds and durations.
/// @param enough  a path that costs at least this without driving close need not be known better [s].
double path_cost(std::span<const PathSegment> path, const Vehicle& vehicle, const PathCosts& costs,
                 SpeedProfile& profile, double enough = kInfinity);
/// The cost with a profile of its own.
double path_cost(std::span<const PathSegment> path, const Vehicle& vehicle, const PathCosts& costs = {});

}  // namespace arcway::internal

#pragma once

#include <cstddef>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "core/collision/clearance_cost.h"
#include "core/motion/end_speeds.h"
#include "core/zones/speed_zones.h"

namespace arcway::internal {

/// What the cost of a path depends on beside the vehicle.
struct PathLimits {
  EndSpeeds ends = {};
  const SpeedZones* zones = nullptr;         ///< may be null
  const ClearanceCost* clearance = nullptr;  ///< of driving close to obstacles; may be null
};

/// Makes a free path driven forwards cheaper: the part between two places on it becomes a Dubins word or a biarc that
/// is free by `sweep`, as long as the cost falls. That is the travel time, plus the cost of driving close to obstacles.
/// Places are ends and middles of segments. This serves paths of many short motions, which refine_path hardly improves,
/// since it moves one turn at a time. The result is as free as the input, and never costs more.
/// @param max_trials  number of paths whose travel time is computed, at most; some microseconds each.
/// @param clock  asked before each trial; once over, the path so far is the result.
/// @param limits  of the path's speeds. A path that cannot be driven within them may become one that can.
Path shorten_path(Path path, const Vehicle& vehicle, const SweepQuery& sweep, std::size_t max_trials,
                  const StopClock& clock, const PathLimits& limits = {});

}  // namespace arcway::internal

#pragma once

#include <cstddef>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "core/collision/path_cost.h"

namespace arcway::internal {

/// Makes a free path driven forwards cheaper: the part between two places on it becomes a Dubins word or a biarc that
/// is free by `sweep`, as long as the cost falls. That is the travel time, plus the cost of driving close to obstacles.
/// Places are ends and middles of segments. This serves paths of many short motions, which refine_path hardly improves,
/// since it moves one turn at a time. The result is as free as the input, and never costs more.
/// @param max_trials  number of paths whose travel time is computed, at most; some microseconds each.
/// @param clock  asked before each trial; once over, the path so far is the result.
/// @param costs  of the path. A path that cannot be driven between their end speeds may become one that can.
Path shorten_path(Path path, const Vehicle& vehicle, const SweepQuery& sweep, std::size_t max_trials,
                  const StopClock& clock, const PathCosts& costs = {});

}  // namespace arcway::internal

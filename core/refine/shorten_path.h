#pragma once

#include <cstddef>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"

namespace arcway::internal {

/// Makes a free path driven forwards faster, as long as time falls: what lies between two places on it, the ends and
/// middles of its segments, becomes a Dubins word or a biarc that is free by `sweep`. For paths of many short motions,
/// which refine_path, that moves one turn at a time, leaves as they are. As free as the input and never slower.
/// @param max_trials  paths whose travel time is computed, at most; some microseconds each.
/// @param clock  asked before each trial; once over, the path so far is the result.
Path shorten_path(Path path, const Vehicle& vehicle, const SweepQuery& sweep, std::size_t max_trials,
                  const StopClock& clock);

}  // namespace arcway::internal

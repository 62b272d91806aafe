#pragma once

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "core/collision/path_cost.h"

namespace arcway::internal {

/// Drives a free path in fewer motions, forwards as before. From each joint on, a biarc takes the place of as many
/// motions as possible, three at least, where it is free by `sweep` and hardly longer. The path costs a thousandth more
/// at most. Paths of trees turn in many short arcs, each with contacts of its own, which ChainOptimizer hardly moves.
/// Fewer arcs move further. O(n^3) for n motions, but some tens of milliseconds at most.
/// @param clock  asked before each trial; once over, the path so far is the result.
/// @param costs  of the path.
Path join_arcs(Path path, const Vehicle& vehicle, const SweepQuery& sweep, const StopClock& clock,
               const PathCosts& costs = {});

}  // namespace arcway::internal

#pragma once

#include <cstddef>
#include <limits>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "core/refine/refine_path.h"

namespace arcway::internal {

struct GearChanges {
  double cost = 0.0;                                           ///< of each, beside the time for it [s]
  std::size_t most = std::numeric_limits<std::size_t>::max();  ///< of a path
};

/// Makes a free path in both gears cheaper, its cost being its travel time and that of its changes of gear:
/// - words of Reeds and Shepp, and of Dubins in either gear, and biarcs in either gear replace what lies between two
///   places of the path, the ends of segments and the middles of long ones: words of the smallest radius, and wider
///   ones where gear changes between the places. Tried are all pairs of places that are up to 16 places apart, and
///   further ones less densely, until none makes the path cheaper. So no change of gear is left that one of these
///   saves;
/// - what lies between two cusps is refined by refine_path, which knows nothing of gears and need not: from rest to
///   rest it takes the same time either way;
/// - cusps move and turn, by steps that are halved down to the smallest, and Dubins words of the smallest radius lead
///   there from the path before them and on to the path behind.
/// A change is accepted only if the cost falls and the swept area of the body grown by half of the safety margin is
/// free by `sweep`. A local optimum of these changes, not the cheapest path. Deterministic.
/// @param changes  of gear; paths of more than the most are not taken, but for the given one.
/// @param clock  asked before each trial; once over, the refinement ends with the best path so far.
/// @throws std::invalid_argument as require_refinement does.
RefinedPath refine_reversing_path(const Path& path, const Vehicle& vehicle, const SweepQuery& sweep,
                                  const GearChanges& changes, const RefineOptions& options, const StopClock& clock);

}  // namespace arcway::internal

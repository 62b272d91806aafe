#pragma once

#include <cstddef>
#include <limits>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "core/refine/refine_path.h"

namespace arcway::internal {

/// What gear changes cost in a path, and how many there may be.
struct GearChanges {
  double cost = 0.0;                                           ///< of each, beside the time for it [s]
  std::size_t most = std::numeric_limits<std::size_t>::max();  ///< in one path
};

/// Makes a free path in both gears cheaper. Its cost is its travel time, plus that of its gear changes and of driving
/// close to obstacles. The moves are kGearMoves of moves.h:
/// 1. Words. Places are ends of segments and middles of long ones. Words are tried until none makes the path cheaper.
/// 2. Parts between two cusps are refined by refine_path, which need not know of gears: a part takes the same time in
///    either direction. With outlines of the world, their turns are optimized.
/// 3. Cusps move and turn, in steps that are halved down to the smallest. Dubins words of the smallest radius lead
///    there from the path before, and on to the path behind.
/// 4. All turns and the poses where the gear changes are optimized at once, see ChainOptimizer, for vehicles that it
///    serves and with outlines of the world. The gears stay.
/// 5. Runs between two cusps are left out, with outlines of the world. What is left is pushed free and to the goal by
///    push_free. That is tried at the optimum of the other moves and, if gear changes remain, on the given path: its
///    turns are wider. The other moves follow again.
///
/// A change is accepted only if the cost falls and the body, grown by half of the safety margin, is free by `sweep`.
/// The result is a local optimum of these changes. Deterministic.
/// End speeds stay as they are. Precondition: the path can be driven between them.
/// @param changes  paths with more gear changes than `most` are not taken, except for the given one.
/// @param clock  asked before each trial; once over, the best path so far is the result.
/// @throws std::invalid_argument as require_refinement does.
RefinedPath refine_reversing_path(const RefineQuery& query, const GearChanges& changes);

}  // namespace arcway::internal

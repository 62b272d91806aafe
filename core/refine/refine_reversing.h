#pragma once

#include <functional>

#include "core/path/path.h"
#include "core/query/sweep_query.h"
#include "core/refine/refine_path.h"
#include "core/vehicle.h"

namespace [[gnu::visibility("default")]] arcway {

/// Makes a free path in both gears cheaper, its cost being its travel time and `cusp_cost` for each change of gear:
/// - Reeds-Shepp words of the smallest radius between two places of the path replace what lies between them;
/// - what lies between two cusps is refined by refine_path, which knows nothing of gears and need not: from rest to
///   rest it takes the same time either way;
/// - cusps move and turn, by steps that are halved down to the smallest, and Dubins words of the smallest radius lead
///   there from the path before them and on to the path behind.
/// A change is accepted only if the cost falls and the swept area of the body grown by half of the safety margin is
/// free by `sweep`. A local optimum of these changes, not the cheapest path. Deterministic.
/// @param stop  asked before each trial; true ends the refinement with the best path so far.
/// @throws std::invalid_argument as require_refinement does.
RefinedPath refine_reversing_path(const Path& path, const Vehicle& vehicle, const SweepQuery& sweep, double cusp_cost,
                                  const RefineOptions& options, const std::function<bool()>& stop);

}  // namespace arcway

#pragma once

#include "core/attach/roadmap.h"
#include "core/reversing/gear_search.h"

namespace arcway::internal {

/// Finds a path in both gears like search_gears, where its trees find none because start, goal or the way are too
/// narrow. Two trees of narrow_gear_tree.h grow from start and goal in turn, guided by the routes through gaps that are
/// wide enough. New poses are joined to the other root and to near poses of the other tree by words in both gears.
/// Passes tell poses apart more and more finely until there is a path. Then as many poses again search for a cheaper
/// one. Paths are checked exactly. As the number of poses is limited, finding no path proves nothing.
/// Deterministic unless stopped.
GearSearchResult search_narrow_gears(const Roadmap& map, const Pose& start, const Pose& goal,
                                     const GearSearchOptions& options);

}  // namespace arcway::internal

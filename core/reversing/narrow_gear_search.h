#pragma once

#include "core/attach/roadmap.h"
#include "core/reversing/gear_search.h"

namespace arcway::internal {

/// As search_gears, for ends and ways so narrow that its trees have none: two trees of narrow_gear_tree.h grow from
/// start and goal, by turns, guided by the routes through gaps that are wide enough. New poses are joined to the other
/// root and to the nearest poses of the other tree by words in both gears. Passes tell poses apart more and more
/// finely, as long as there is none. After the first path as many poses again look for a cheaper one. Paths are checked
/// exactly; the number of poses is limited, so that no path proves nothing. Deterministic unless stopped.
GearSearchResult search_narrow_gears(const Roadmap& map, const Pose& start, const Pose& goal,
                                     const GearSearchOptions& options);

}  // namespace arcway::internal

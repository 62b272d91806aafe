#pragma once

#include "core/search/find_path.h"

namespace [[gnu::visibility("default")]] arcway {

/// The cheapest path found of a vehicle that may drive backwards, in travel time and `options.cusp_cost` for each
/// change of gear. Tried are
/// - the graph, driven forwards or backwards, joined by poses that motions in both gears reach from start and goal;
/// - Reeds-Shepp words and motions in both gears all the way, see search_gears.
/// @param cutoff  cost of a path that is known; only cheaper ones are of interest [s].
/// The number of tries is limited, so that no path proves nothing. Start and goal differ.
FoundPath find_reversing_path(const SearchMap& map, const Pose& start, const Pose& goal, double cutoff,
                              const SearchOptions& options, SearchWorkspace& workspace);

}  // namespace arcway

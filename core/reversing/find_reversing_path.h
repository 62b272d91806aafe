#pragma once

#include <cstddef>
#include <limits>

#include "core/search/find_path.h"

namespace arcway::internal {

struct ReversingQuery {
  Pose start, goal;  ///< that differ
  double distance;   ///< that no path of the vehicle falls below, as travel_time_lower_bound takes it [m]
  double cutoff;     ///< cost of a path that is known, driven forwards; only cheaper ones are of interest [s]
  std::size_t max_cusps = std::numeric_limits<std::size_t>::max();  ///< of paths of interest
};

/// The cheapest path found of a vehicle that may drive backwards, in travel time and `options.cusp_cost` for each
/// change of gear. Tried are
/// - the graph, driven backwards, or forwards or backwards between poses that motions in both gears reach from start
///   and goal, unless the lower bounds say that no path by way of them is cheaper;
/// - Reeds-Shepp words and motions in both gears all the way, see search_gears.
/// The number of tries is limited, so that no path proves nothing.
FoundPath find_reversing_path(const Roadmap& map, const ReversingQuery& query, const SearchOptions& options,
                              SearchWorkspace& workspace);

}  // namespace arcway::internal

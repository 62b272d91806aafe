#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "core/model/outlines.h"

namespace arcway::internal {

struct GearSearchOptions {
  double cusp_cost = 0.0;                                           ///< of a change of gear, beside the time for it [s]
  std::size_t max_poses = 8000;                                     ///< tried at most, of both ends together
  double cutoff = std::numeric_limits<double>::infinity();          ///< only paths of less cost are of interest [s]
  std::size_t max_cusps = std::numeric_limits<std::size_t>::max();  ///< of paths of interest
  StopClock clock = {};                                             ///< ends the search, with the best path so far
};

struct GearSearchResult {
  std::optional<Path> path;
  double cost = std::numeric_limits<double>::infinity();  ///< travel time of the path and cost of its cusps [s]
  bool interrupted = false;
  std::size_t poses = 0;  ///< tried
  std::uint64_t straights_checked = 0;
  std::uint64_t turns_checked = 0;
};

/// A path of arcs of the smallest radius and lines in both gears, for ends that are close to each other or parked: two
/// trees of poses grow from start and goal, by turns, and every pose of one is joined to the root of the other by a
/// free Reeds-Shepp word, if there is one. Ends some time after the first path that is found, with the best one, or
/// when all that is left costs more. Paths are checked exactly; their number is limited, so that no path proves
/// nothing. Deterministic.
GearSearchResult search_gears(const Pose& start, const Pose& goal, const Vehicle& vehicle, const SweepQuery& sweep,
                              const Outlines& outlines, const GearSearchOptions& options);

}  // namespace arcway::internal

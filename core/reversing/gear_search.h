#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "core/collision/clearance_cost.h"
#include "core/model/outlines.h"
#include "core/zones/one_way_zones.h"
#include "core/zones/speed_zones.h"

namespace arcway::internal {

/// Two poses of a vehicle, and what its motions are checked with. What is referred to must outlive the search.
struct GearQuery {
  Pose start, goal;
  const Vehicle& vehicle;
  const SweepQuery& sweep;                     ///< of the world
  const Outlines& outlines;                    ///< of the world
  const OneWayZones* one_way_zones = nullptr;  ///< that `sweep` obeys; null: none
};

/// Weight of the estimate of the rest of the route in trees for narrow places. Of 46 driven worlds that need them, 42
/// are solved with 2, 44 with 3 and 41 with 4. Trees of other weights mostly go other ways.
inline constexpr double kRestWeight = 3.0;

struct GearSearchOptions {
  double cusp_cost = 0.0;                                   ///< cost of a gear change, beside the time for it [s]
  std::size_t max_poses = 8000;                             ///< number of poses tried, of both ends together
  double cutoff = std::numeric_limits<double>::infinity();  ///< only paths of less cost are wanted [s]
  std::size_t max_cusps = std::numeric_limits<std::size_t>::max();  ///< largest number of gear changes of a path
  StopClock clock = {};  ///< may end the search; the best path so far is returned
  /// Whose limits the times of paths obey; null: none. The trees grow as if there were none.
  const SpeedZones* speed_zones = nullptr;
  /// What driving close to obstacles costs on paths; null: nothing. The trees grow as if it were nothing.
  const ClearanceCost* clearance_cost = nullptr;
  double rest_weight = kRestWeight;    ///< of trees for narrow places
  std::span<const Path> avoided = {};  ///< paths off which these trees keep, see RouteQuery
};

struct GearSearchResult {
  std::optional<Path> path;
  /// Travel time of the path, plus the cost of its gear changes and of driving close to obstacles [s].
  double cost = std::numeric_limits<double>::infinity();
  bool interrupted = false;
  std::size_t poses = 0;  ///< tried
  std::uint64_t straights_checked = 0;
  std::uint64_t turns_checked = 0;
};

/// Finds a path of arcs of the smallest radius and lines in both gears, for start and goal that are close to each other
/// or parked. Two trees of poses grow from start and goal in turn. Each pose of one is joined to the root of the other
/// by a free Reeds-Shepp word, if there is one. The search ends some time after the first path, with the best one, or
/// when everything left costs more. Paths are checked exactly. As the number of poses is limited, finding no
/// path proves nothing. Deterministic.
GearSearchResult search_gears(const GearQuery& query, const GearSearchOptions& options);

}  // namespace arcway::internal

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "arcway/planner.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "bench/report/peer_results.h"

namespace arcway::internal::peers {

/// A setting that planners are compared on.
struct PlannerSetting {
  std::string name;
  std::vector<std::string> worlds;  ///< names of the catalog
  Vehicle vehicle;
  bool scaled = false;             ///< whether the worlds are scaled to the vehicle, by world_for
  std::size_t queries = 50;        ///< a world
  std::vector<double> times{1.0};  ///< times at which the peers' best path is recorded [s]
  double long_time = 10.0;         ///< once more on the first `long_queries` of each world [s]
  std::size_t long_queries = 10;
  bool shortest_too = true;    ///< whether planners that look for the shortest path take part
  bool ompl_2_too = false;     ///< whether the planners take part that OMPL has from version 2 on
  bool ours_only = false;      ///< no peer takes part
  bool first_only = false;     ///< RRTConnect's first path and nothing else
  double first_within = 10.0;  ///< the time for that [s]; with `times`, the last of them is
  std::uint64_t seed = 1;      ///< seed of queries and peers
};

/// The standard settings:
/// - amr, forklift and so on: the real vehicles of bench/robots.h in four clutters of 100 obstacles of their size.
/// - lateral2_along2 and so on: the paper's robot with limits on its accelerations [m/s²], by which it is named, in
/// four
///   clutters of 100 obstacles.
/// - n100, n1000: the paper's robot in six clutters of 100 and of 1,000 obstacles.
std::vector<PlannerSetting> standard_settings();

/// A map and queries of anyone's.
struct PlannerMap {
  std::string name;
  World world;
  std::vector<PlanRequest> requests;
};

struct PlannerStudyProgress {
  std::function<void(const std::string&)> line;  ///< called when a map is prepared, and after each query
  /// The plan of a peer, as a file of plans has it, for a query that arcway did not solve or with a slower path.
  std::function<void(const std::string&)> lost;
  /// The queries of a world.
  std::function<void(const std::vector<report::PlannerQuery>&)> world_done;
  std::stop_token stop = {};  ///< ends compare_planners before its next query
};

/// arcway and OMPL's planners on the same queries with the same exact checks by the same queries of the map, planner
/// after planner on each query, one thread, processor time. Lower bounds are arcway's. `arcway first` is its first
/// path, before refinement; `arcway_tightest`, where wider turns are faster, what it finds if it may only turn as
/// tightly as it can.
void planner_study(const PlannerSetting& setting, const PlannerStudyProgress& progress);

/// The comparison of planner_study on one map. The worlds of the setting are not used, nor its number of queries.
std::vector<report::PlannerQuery> compare_planners(const PlannerSetting& setting, const PlannerMap& map,
                                                   const PlannerStudyProgress& progress);

}  // namespace arcway::internal::peers

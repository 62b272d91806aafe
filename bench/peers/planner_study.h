#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/report/peer_results.h"
#include "core/vehicle.h"

namespace arcway::peers {

struct PlannerStudyOptions {
  std::vector<std::string> worlds;  ///< of the catalogue
  Vehicle vehicle;
  std::size_t queries = 50;        ///< a world
  std::vector<double> times{1.0};  ///< when to look at the peers' best path [s]
  double long_time = 10.0;         ///< once more on the first `long_queries` of each world [s]
  std::size_t long_queries = 10;
  bool first_only = false;     ///< RRTConnect's first path and nothing else
  double first_within = 10.0;  ///< the time for that [s]; with `times`, the last of them is
  std::uint64_t seed = 1;      ///< of queries and peers
};

struct PlannerStudyProgress {
  std::function<void(const std::string&)> line;
  /// The plan of a peer, as a file of plans has it, for a query that arcway did not solve or with a slower path.
  std::function<void(const std::string&)> lost;
  std::function<void(const std::vector<report::PlannerQuery>&)> world_done;
};

/// arcway and OMPL's planners on the same queries with the same exact checks by the same queries of the map, planner
/// after planner on each query, one thread, processor time. Lower bounds are arcway's.
std::vector<report::PlannerQuery> planner_study(const PlannerStudyOptions& options,
                                                const PlannerStudyProgress& progress);

}  // namespace arcway::peers

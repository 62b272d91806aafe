#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <stop_token>
#include <string>
#include <vector>

#include "arcway/planner.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"

namespace arcway::internal::bench {

/// A map under the name that results have; the name has no colons.
struct StudiedMap {
  std::string name;
  World world;
};
/// A robot under the name that results have; the name has no colons and no slashes.
struct StudiedRobot {
  std::string name;
  Vehicle vehicle;
};
/// The queries of one robot on one map.
struct StudiedCase {
  std::size_t map, robot;  ///< indices
  std::vector<PlanRequest> requests;
};

/// What is measured of maps and robots of anyone's.
struct MapStudy {
  std::vector<StudiedMap> maps;
  std::vector<StudiedRobot> robots;
  std::vector<StudiedCase> cases;  ///< those of one map follow each other
  int repetitions = 5;
  double time_limit = std::numeric_limits<double>::infinity();  ///< of one query [s]
};

/// How a study is watched and ended.
struct MapStudyProgress {
  std::stop_token stop;
  /// @param benchmark  the one that runs: "RealMap/car/yard/prepared"; valid until the next call.
  std::function<void(const std::string& benchmark, std::size_t done, std::size_t total)> show;
};

/// The name of this study in the context of its results.
inline constexpr const char* kMapStudy = "maps";

struct MapStudyRun {
  std::string json;  ///< Google Benchmark's
  int failures = 0;  ///< benchmarks that did not pass their check
};

/// Measures, on one thread:
///
/// | benchmark | what |
/// |---|---|
/// | ReducedGraph/MAP | the reduced visibility graph |
/// | FeasibleGraph/ROBOT/MAP | the feasible graph, all links checked |
/// | PlanFirst/ROBOT/MAP | the first plan on a new map, nothing prepared: the first five queries |
/// | RealMap/ROBOT/MAP/prepared | all queries on a prepared map, with their quality |
///
/// The validator checks every path. After a stop request the results have what was finished before it. For one
/// call at a time.
MapStudyRun run_map_study(const MapStudy& study, const MapStudyProgress& progress);

}  // namespace arcway::internal::bench

#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "arcway/vehicle.h"
#include "bench/cli/arguments.h"
#include "bench/suites/map_study.h"

namespace arcway::internal::cli {

/// What `arcway bench` is to measure, as typed or as a scenario says.
struct StudyInput {
  struct Robot {
    std::string name;
    Vehicle vehicle;
  };
  std::vector<std::string> maps;  ///< files, or names of the catalog
  std::vector<Robot> robots;
  std::string queries = "50";  ///< how many random ones a map and robot, or a file of `plan --queries`
  std::uint64_t seed = 1;      ///< of random queries
  bool reverse = false;
  double time_limit = std::numeric_limits<double>::infinity();  ///< of one query [s]
  std::uint64_t repetitions = 5;
  double peer_time = 1.0;  ///< of each peer and query [s]; 0: no peers

  /// @throws UsageError naming the value that is out of range, as `what` calls it.
  void check() const;
};

/// A robot of a file, under the file's name; the paper's if the name is empty.
StudyInput::Robot read_studied_robot(const std::string& file);

/// Whether a file is a scenario of `arcway bench`, rather than a map.
bool is_study_file(const std::filesystem::path& file);
/// Reads such a scenario:
///
///     {"format": "arcway-benchmark", "version": 1, "maps": ["yard.geojson", "clutter/star/n100"],
///      "robots": ["car.json", {...}], "queries": 50 | "Q.csv", "seed": 1, "reverse": false, "time_limit": 10,
///      "repetitions": 5, "peer_time": 1}
///
/// All keys but the first three may be missing. Files are relative to the scenario's folder. Robots are files or as in
/// them; without any, the robot is the paper's.
/// @throws FormatError naming key and value, FileError, UsageError.
StudyInput read_study_file(const std::filesystem::path& file);

/// Reads the maps and makes or reads the queries.
/// @param notes  gets rows of the summary: notes and warnings of maps, robots and queries.
/// @throws UsageError, FormatError, FileError for a map that planning refuses, a query whose start or goal is not free,
///   or a map without room for random queries.
bench::MapStudy make_study(const StudyInput& input, const MapOptions& reading, std::string& notes);

}  // namespace arcway::internal::cli

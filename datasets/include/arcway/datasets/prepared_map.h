#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "arcway/datasets/file_io.h"
#include "arcway/export.h"
#include "arcway/path.h"
#include "arcway/planner.h"
#include "arcway/prepared_graph.h"
#include "arcway/snapshot.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"

namespace arcway {

/// A map with the graphs that planning on it needs, built once and kept in one file: datasets/README.md describes its
/// bytes.
///
///     write_prepared_map("yard.arcway", prepared_map_of(planner));
///     ...
///     PreparedMap map = read_prepared_map_file("yard.arcway");
///     const Planner planner = Planner::restored(
///         map.world, Vehicle(map.robot->parameters), accel_backend(map.world),
///         {std::move(map.reduced_graph), map.robot->radii, std::move(map.robot->feasible)});
///
/// The bytes depend on the map only, not on the numbers of threads or processes that built its graphs.
struct ARCWAY_API PreparedMap {
  World world;
  VisibilityGraph reduced_graph;
  std::optional<Pose> start, goal;

  /// The feasible graph of one robot.
  struct ForRobot {
    VehicleParameters parameters;
    std::vector<double> radii;
    FeasibleGraphSnapshot feasible;
  };
  std::optional<ForRobot> robot;

  /// Where a map was read from, so that a table found wrong when it is taken up can be pointed at.
  struct Source {
    std::string name;
    struct Section {
      std::uint64_t offset;
      std::uint32_t element_bytes;
    };
    std::map<SnapshotArray, Section> sections;
    /// "yard.arcway: byte 4711: links, entry 3: ..."
    [[nodiscard]] std::string complaint(const SnapshotError& error) const;
  };
  Source source;
};

/// The map, graphs and robot of a planner whose graph is eager.
/// @throws std::logic_error as Planner::prepared_graph does.
ARCWAY_API PreparedMap prepared_map_of(const Planner& planner, const std::optional<Pose>& start = {},
                                       const std::optional<Pose>& goal = {});

/// Whether a file begins like a prepared map.
ARCWAY_API bool is_prepared_map(std::string_view bytes);
/// Whether a regular file begins like a prepared map; false for other files, or if it cannot be read.
ARCWAY_API bool is_prepared_map_file(const std::filesystem::path& path);

/// Takes up a map, its world and reduced graph checked for ranges and order, and everything against checksums. What the
/// geometry of a file with right checksums says is believed. O(bytes).
/// @throws FormatError naming source, byte and value for what is no prepared map, one of another version or byte
///   order, cut off or changed.
ARCWAY_API PreparedMap read_prepared_map(std::string_view bytes, std::string_view name);
/// @throws FormatError, FileError
ARCWAY_API PreparedMap read_prepared_map_file(const std::filesystem::path& path);

/// The bytes of a map's file.
ARCWAY_API std::string to_bytes(const PreparedMap& map);
/// Written whole or not at all.
/// @throws FileError
ARCWAY_API void write_prepared_map(const std::filesystem::path& path, const PreparedMap& map);

}  // namespace arcway

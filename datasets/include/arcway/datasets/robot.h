#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "arcway/datasets/file_io.h"
#include "arcway/export.h"
#include "arcway/path.h"
#include "arcway/vehicle.h"

namespace arcway {

/// Robot as JSON; all keys may be missing and take the defaults of VehicleParameters, unknown and
/// repeated ones are errors.
///
///     {"format": "arcway-robot", "version": 1, "length": 1.5, "width": 0.8, "wheelbase": 1.3,
///      "steering": "front" | "rear" | "symmetric", "max_steering_angle": 0.785, "max_speed": 12,
///      "turn_speed": 8 | {"lateral_acceleration": 2} | {"table": [[radius, speed], ...]},
///      "max_reverse_speed": 3, "max_acceleration": 50, "safety_margin": 0.001}
///
/// The body may be given in three ways:
/// - "length" and "width";
/// - "front_overhang" and "rear_overhang" from the axles, and "width";
/// - "footprint": [[x, y], ...] about the reference point, or several of these, or a text of either
///   as in nav2's parameters. "footprint_origin": [x, y] is the place of the polygons' origin about
///   the reference point, such as that of a base link.
///
/// "min_turning_radius" [m] takes the place of "max_steering_angle".
///
/// A robot whose name ends in .yaml or .yml has the same keys in YAML, or is a file of parameters of
/// nav2: of these "footprint" and "minimum_turning_radius" are read.
///
/// Without "max_reverse_speed" the vehicle drives backwards as fast as forwards.
/// Values are not judged: Vehicle does that.
/// @throws FormatError naming key and value.
ARCWAY_API VehicleParameters read_robot(std::string_view text, std::string_view name);
/// @throws FormatError, FileError
ARCWAY_API VehicleParameters read_robot_file(const std::filesystem::path& path);
/// All keys that have a value, numbers that read back to the same doubles.
ARCWAY_API std::string to_json(const VehicleParameters& robot);

struct Task {
  std::string id;
  Pose start, goal;
};

/// World, robot and tasks as JSON.
///
///     {"format": "arcway-scenario", "version": 1, "world": "x.geojson", "robot": {...} | "robot.json",
///      "tasks": [{"id": "t0", "start": [x, y, heading], "goal": [x, y, heading]}]}
struct Scenario {
  std::string world;  ///< path, relative to the scenario's folder
  /// The robot itself, or the path of its file, relative to the scenario's folder. Missing: the
  /// defaults.
  std::variant<VehicleParameters, std::string> robot;
  std::vector<Task> tasks;  ///< a missing id becomes "t" and the index; ids are unique
};
/// @throws FormatError naming key and value.
ARCWAY_API Scenario read_scenario(std::string_view json, std::string_view name);
/// Reads the robot's file as well, and puts the scenario's folder before `world`.
/// @throws FormatError, FileError
ARCWAY_API Scenario read_scenario_file(const std::filesystem::path& path);
ARCWAY_API std::string to_json(const Scenario& scenario);

}  // namespace arcway

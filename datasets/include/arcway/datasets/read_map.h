#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "arcway/datasets/detect_format.h"
#include "arcway/datasets/map_file.h"
#include "arcway/datasets/occupancy_grid.h"
#include "arcway/datasets/vector_options.h"
#include "arcway/export.h"
#include "arcway/world.h"

namespace arcway {

struct MapReadOptions {
  std::optional<MapFormat> format{};  ///< none: told by the content
  VectorOptions vector{};             ///< options of formats with coordinates
  GridOptions grid{};                 ///< options of formats with cells
  /// MovingAI scenarios: index of the task that gives start and goal, from 0, and the seed of its headings.
  std::size_t task = 0;
  std::uint64_t heading_seed = 1;
};

/// Reads a map of any format, and start and goal if the file has them. A format in cells becomes polygons.
///
///     const MapFile map = read_map("maps/office.yaml", {.grid = {.tolerance = 1.0}});
///     const Planner planner(to_world(map, "office"), vehicle);
///
/// Files compressed by gzip are expanded. Files that a file names are looked for beside it, with slashes for
/// backslashes and with .gz added as well. Options that do not go with the format are warned of. An image without a
/// YAML file is occupied where it is darker than half, its lower left corner at the origin.
/// @throws FileError if a file cannot be read, FormatError naming file, place and value.
ARCWAY_API MapFile read_map(const std::filesystem::path& path, const MapReadOptions& options = {});

/// The world of a map file, checked: to_world(read_map(path, options)), for those who need no start, goal and warnings.
/// @throws FileError and FormatError as both do.
ARCWAY_API World read_world(const std::filesystem::path& path, const MapReadOptions& options = {});

}  // namespace arcway

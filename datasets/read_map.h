#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "datasets/formats/vector_map.h"
#include "datasets/grid/occupancy_grid.h"
#include "datasets/map_file.h"

namespace [[gnu::visibility("default")]] arcway {

enum class MapFormat {
  kGeoJson,
  kWkt,
  kTextPolygons,
  kTpcap,
  kMovingAiMap,
  kMovingAiScenario,
  kRosMap,
  kPgm,
  kPng,
  kSvg,
  kPrepared,
};
/// "GeoJSON", "WKT", ...
const char* name_of(MapFormat format);

/// The format of a file, told by its content alone.
/// @throws FormatError if it is none of them; `name` is of the source, for the message.
MapFormat detect_format(std::string_view content, std::string_view name);

struct MapReadOptions {
  VectorOptions vector{};  ///< of formats with coordinates
  GridOptions grid{};      ///< of formats with cells
  /// Of MovingAI scenarios: which task gives start and goal, from 0, and the seed of its headings.
  std::size_t task = 0;
  std::uint64_t heading_seed = 1;
};

/// Reads a map of any format, and start and goal if the file has them. A format in cells becomes polygons.
///
///     const MapFile map = read_map("maps/office.yaml", {.grid = {.tolerance = 1.0}});
///     const Planner planner(to_world(map, "office"), vehicle);
///
/// Files compressed by gzip are expanded. Files that a file names are looked for beside it, with .gz added as well. An
/// image without a YAML file is occupied where it is darker than half, its lower left corner at the origin.
/// @throws FileError if a file cannot be read, FormatError naming file, place and value.
MapFile read_map(const std::filesystem::path& path, const MapReadOptions& options = {});

}  // namespace arcway

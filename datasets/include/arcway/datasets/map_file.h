#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "arcway/curved_plan.h"
#include "arcway/datasets/file_io.h"
#include "arcway/export.h"
#include "arcway/path.h"
#include "arcway/polygon.h"
#include "arcway/world.h"
#include "arcway/zone.h"

namespace arcway {

/// What a file says of its coordinates, which are used as meters in any case.
enum class CoordinateFrame {
  kUnstated,
  kMeters,  ///< stated by the file or by its format, or projected
  kDegrees  ///< longitude and latitude
};

/// A planar map as a file has it: obstacles in meters, and what else the file says. Plain data: World checks it.
struct MapFile {
  std::vector<Polygon> obstacles;
  std::optional<Ring> bounds;
  std::optional<Pose> start, goal;
  /// Rings that stand for curves, which contain those within the tolerance that the file was read with.
  std::vector<CurvedRing> curves;
  std::vector<std::string> warnings;  ///< doubtful content of the file, one sentence each
  std::vector<std::string> notes;     ///< what was done to the file's content: "163,496 corners traced"
  /// Where each obstacle came from: "feature 3, polygon 1". One an obstacle, or empty if not read from a file.
  std::vector<std::string> places;
  std::string bounds_place;
  std::vector<Zone> zones;               ///< see World::zones
  std::vector<std::string> zone_places;  ///< as `places`, one a zone or empty
  CoordinateFrame frame = CoordinateFrame::kUnstated;
  std::vector<std::filesystem::path> files;  ///< files that were read: the map's, and those that it names
};

/// Whether coordinates in this box are likely to be longitude and latitude: within 180 and 90, less than 1 wide, and at
/// least 20 times as far from the origin as that. Metric maps that small lie around their origin.
ARCWAY_API bool looks_like_degrees(const Box& box);

/// World of a map file.
/// @throws FormatError with the World's complaint and the place in the file.
ARCWAY_API World to_world(const MapFile& map, std::string_view name);

/// The obstacles, bounds and zones of a world. Obstacles that stand for keep-outs are left to the zones.
ARCWAY_API MapFile to_map_file(const World& world);

}  // namespace arcway

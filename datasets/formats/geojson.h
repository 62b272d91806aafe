#pragma once

#include <filesystem>
#include <istream>
#include <string>
#include <string_view>

#include "datasets/map_file.h"

namespace arcway {

/// Reads GeoJSON [RFC 7946] with planar coordinates in metres: FeatureCollection, Feature, any geometry, or one
/// Feature a line. Polygons and MultiPolygons are obstacles, rings in the order of the file, without the
/// closing position and consecutive repetitions; GeometryCollections are opened; null geometries and empty
/// coordinates are passed over; other geometries are passed over with a warning; z is ignored.
/// `properties.role`: "obstacle" (default); "boundary" (a Polygon: its outer ring is the bounds, its holes are
/// obstacles); "start", "goal" (a Point, with the property `heading`). Top-level `properties`: `bounds` as
/// [xmin, ymin, xmax, ymax], `start` and `goal` as [x, y, heading]. Bounds, start or goal given twice are an
/// error. The polygons are not checked: World does that, and to_world says where in the file.
/// @param name  of the source, for messages.
/// @throws FormatError, "world.geojson: feature 3, ring 0, position 7: expected a number, found null".
MapFile read_geojson(std::string_view text, std::string_view name);
MapFile read_geojson(std::istream& input, std::string_view name);
/// @throws FileError if the file cannot be read.
MapFile read_geojson_file(const std::filesystem::path& path);

/// A FeatureCollection, one feature a line, that reads back to the same doubles: rings closed, outer rings and holes
/// as they are.
std::string to_geojson(const MapFile& map);

}  // namespace arcway

#pragma once

#include <string>
#include <string_view>

#include "arcway/datasets/map_file.h"
#include "arcway/datasets/vector_options.h"
#include "arcway/export.h"

namespace arcway {

/// Reads GeoJSON [RFC 7946] with planar coordinates in meters: FeatureCollection, Feature, any geometry, or one Feature
/// a line.
///
/// - Polygons and MultiPolygons are obstacles. Rings keep the order of the file, without the closing position and
///   consecutive repetitions.
/// - GeometryCollections are opened. Null geometries and empty coordinates are ignored.
/// - Line strings are walls if the options say so. Other geometries are ignored with a warning.
/// - z is ignored, also where it is null or NaN. Of repeated keys the last one counts.
/// - A `crs` member of the format's first version says whether coordinates are planar.
/// - `properties.curve` "spline": the rings are smooth curves through their positions (ClosedSpline). They become rings
///   that contain the obstacle within VectorOptions::curve_tolerance.
/// - `properties.role`: "obstacle" (default); "boundary" (a Polygon: its outer ring is the bounds, its holes are
///   obstacles); "start", "goal" (a Point, with the property `heading`).
/// - Polygons and MultiPolygons of other roles are zones with a `name`. A "keepout" may have `vehicles`, names of
///   robots; left out: all. A "speed_limit" has `max_speed` [m/s]. A "one_way" has `heading` and `tolerance` [rad].
///   A "clearance" has `distance` [m] and `cost` [s/m].
/// - Top-level `properties`: `bounds` as [xmin, ymin, xmax, ymax], `start` and `goal` as [x, y, heading]. Bounds, start
///   or goal given twice are an error.
///
/// The polygons are not checked: World does that, and to_world says where in the file. Features are read one at a time:
/// beside the map itself, memory is the text and the tree of the largest feature.
/// @param name  of the source, for messages.
/// @throws FormatError, "world.geojson: feature 3, ring 0, position 7: expected a number, found null".
ARCWAY_API MapFile read_geojson(std::string_view text, std::string_view name, const VectorOptions& options = {});

/// A FeatureCollection, one feature a line, that reads back to the same doubles: rings closed, outer rings and holes
/// as they are. Zones keep name and rule.
ARCWAY_API std::string to_geojson(const MapFile& map);

}  // namespace arcway

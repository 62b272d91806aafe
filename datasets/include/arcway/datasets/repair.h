#pragma once

#include <vector>

#include "arcway/datasets/map_file.h"
#include "arcway/export.h"

namespace arcway {

/// Whether this build can repair maps (it was built with GEOS).
ARCWAY_API bool can_repair();

/// Repairs a map so that World accepts it, with the same free space as far as the map defines one:
/// - Rings are made valid, and obstacles that overlap or share edges are joined.
/// - Exactly collinear vertices are dropped.
/// - Outer rings become counter-clockwise and holes clockwise.
/// - Points where a region touches itself stay: World judges them as they are.
///
/// Self-crossing rings become the parts that they wind round an odd number of times. Of invalid bounds the largest part
/// stays, if any has area. Crossings become vertices, rounded. Should a rounded map still cross itself, vertices are
/// moved to a grid of about 1e-9 of the map's size. Start, goal, warnings and notes stay; places and curves are
/// dropped.
/// @throws std::runtime_error without GEOS or if it fails; std::invalid_argument for coordinates that World refuses.
ARCWAY_API MapFile repaired(const MapFile& map);

/// The union of polygons, each made valid first, with outer rings and holes in any orientation.
/// @param polygons  rings of at least three positions.
/// @throws std::runtime_error without GEOS or if it fails.
ARCWAY_API std::vector<Polygon> united(const std::vector<Polygon>& polygons);

}  // namespace arcway

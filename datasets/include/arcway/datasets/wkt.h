#pragma once

#include <string>
#include <string_view>

#include "arcway/datasets/map_file.h"
#include "arcway/datasets/vector_options.h"
#include "arcway/export.h"

namespace arcway {

/// Reads well-known text [ISO 19125-1]: geometries one after the other, usually one a line, keywords in any case.
/// POLYGON and MULTIPOLYGON are obstacles, GEOMETRYCOLLECTION is opened, LINESTRING is a wall if the options say so;
/// others are passed over with a warning. Z and M are ignored, also where they are nan; EMPTY is legal, so is the
/// prefix `SRID=n;` of PostGIS.
/// @param name  of the source, for messages.
/// @throws FormatError, "map.wkt: line 3: expected a number, found "x"".
ARCWAY_API MapFile read_wkt(std::string_view text, std::string_view name, const VectorOptions& options = {});

/// A keyword in capitals, without the Z, M or ZM that may stand right behind a geometry's type.
ARCWAY_API std::string wkt_type(std::string_view keyword);

/// One POLYGON a line that reads back to the same doubles. The format has no place for bounds, start and goal.
ARCWAY_API std::string to_wkt(const MapFile& map);

}  // namespace arcway

#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "arcway/export.h"

namespace arcway {

enum class MapFormat {
  kGeoJson,
  kWkt,
  kTextPolygons,
  kVertexList,
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
ARCWAY_API const char* name_of(MapFormat format);

/// Words for the formats, as options take them: "geojson", "wkt", "text", "vertices", ...
ARCWAY_API std::span<const std::string_view> format_words();
ARCWAY_API std::optional<MapFormat> format_of_word(std::string_view word);

/// Whether coordinates of polygons are what the format holds, which VectorOptions are for.
ARCWAY_API bool has_polygons(MapFormat format);
/// Whether other formats look alike, so that the content is no proof: numbers, letters.
ARCWAY_API bool is_guess(MapFormat format);

/// The format of a file, told by its content alone.
///
/// Numbers are a TPCAP case if its counts fit, else a list of vertices if every line has two of them, else polygons of
/// one line each. Lines of letters are a MovingAI map, with its header, with `height,width`, or with none.
/// @throws FormatError if it is none of them, which names known formats that are not read; `name` is of the source.
ARCWAY_API MapFormat detect_format(std::string_view content, std::string_view name);

}  // namespace arcway

#pragma once

#include <string_view>

#include "arcway/datasets/map_file.h"
#include "datasets/formats/vector_map.h"

namespace arcway::internal {

/// Reads vertices, one a line as `x,y`; blanks, tabs, commas and semicolons separate them. A polygon ends at a blank
/// line, at a line of nan, and where its first vertex comes again. Lines that begin with # are skipped.
///
/// The first line may name the columns: x and y, or lon and lat, which are degrees. A column id, polygon, obstacle,
/// ring, feature, shape or part has the same value for all vertices of a polygon. Other columns are left out with a
/// warning.
/// @param name  of the source, for messages.
/// @throws FormatError, "map.csv: line 3: expected 2 numbers, found 3".
MapFile read_vertex_list(std::string_view text, std::string_view name, const VectorOptions& options = {});

/// Whether the text's first lines have two numbers each.
bool is_vertex_list(std::string_view text);
/// Whether the first line names the columns of a list of vertices.
bool has_vertex_header(std::string_view text);

}  // namespace arcway::internal

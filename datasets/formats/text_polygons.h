#pragma once

#include <string_view>

#include "arcway/datasets/map_file.h"
#include "datasets/formats/vector_map.h"

namespace arcway::internal {

/// Reads plain text: one polygon a line as `x y x y ...`, not closed, in either orientation. A comma or semicolon may
/// stand between any two numbers. Blank lines and lines that begin with # are skipped.
/// @param name  of the source, for messages.
/// @throws FormatError, "map.txt: line 3: expected a number, found "x"".
MapFile read_text_polygons(std::string_view text, std::string_view name, const VectorOptions& options = {});

}  // namespace arcway::internal

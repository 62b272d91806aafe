#pragma once

#include <string_view>

#include "arcway/datasets/map_file.h"
#include "datasets/formats/vector_map.h"

namespace arcway::internal {

/// Reads a world drawn as SVG, as bench-mr has them: each <path> is an obstacle, in groups moved by translate and
/// scale. Curves (C S Q T A) become rings that contain the obstacle within the tolerance of the options, of which the
/// others do not matter. One user unit is one meter; y turns up, so that a point (x, y) of the drawing is at (x, -y).
/// The view box is the bounds. A subpath inside another one is a hole, one inside a hole an obstacle again. Other
/// shapes and transforms are errors that name them; metadata and definitions are passed over. Hidden groups and shapes
/// (display: none, visibility: hidden, by attribute, style or CSS rule; layers of Inkscape) are no obstacles; a note
/// counts them. An outline that ends
/// within 1e-4 of its size from its beginning, as relative coordinates do that were rounded, is closed there.
/// @param name  of the source, for messages.
/// @throws FormatError, "w.svg: line 7, path "a": ...".
MapFile read_svg_world(std::string_view text, std::string_view name, const VectorOptions& options = {});

}  // namespace arcway::internal

#pragma once

#include <string_view>

#include "arcway/datasets/map_file.h"

namespace arcway::internal {

/// Reads a case of the TPCAP parking competition: start and goal as x, y, heading; the number of obstacles; the number
/// of vertices of each; all vertices as x, y. Numbers stand one a line or between commas. Poses are of the middle of
/// the rear axle.
///
/// The format has no bounds: they are the box of poses and obstacles, widened to at least 12 m beyond start and goal.
/// A case beyond 1,000 km from the origin is moved by whole meters to have its start near the origin. That rounds
/// nothing near the start, and a note gives the offset.
/// @param name  of the source, for messages.
/// @throws FormatError, "Case1.csv: line 1: obstacle 2: expected 8 coordinates, found 5".
MapFile read_tpcap(std::string_view text, std::string_view name);

}  // namespace arcway::internal

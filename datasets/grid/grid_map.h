#pragma once

#include "arcway/datasets/map_file.h"
#include "arcway/datasets/occupancy_grid.h"

namespace arcway::internal {

/// Converts a grid to obstacles: the borders of its blocked cells (trace.h), simplified within the tolerance
/// (simplify.h), in meters. The frame of the grid becomes the bounds if it is walled. Notes say how many corners there
/// were before and after.
/// @throws std::invalid_argument if the tolerance is negative or not finite, or the cell size is not positive.
MapFile to_map_file(const OccupancyGrid& grid, const GridOptions& options = {});

}  // namespace arcway::internal

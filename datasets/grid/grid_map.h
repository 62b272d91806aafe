#pragma once

#include "datasets/grid/occupancy_grid.h"
#include "datasets/map/map_file.h"

namespace [[gnu::visibility("default")]] arcway {

/// Obstacles of a grid: the borders of its blocked cells (trace.h), simplified within the tolerance (simplify.h), in
/// metres; the frame of the grid as bounds if it is walled. Notes say how many corners there were before and after.
/// @throws std::invalid_argument if the tolerance is negative or not finite, or the cell size is not positive.
MapFile to_map_file(const OccupancyGrid& grid, const GridOptions& options = {});

}  // namespace arcway

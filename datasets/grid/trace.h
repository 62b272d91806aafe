#pragma once

#include <cstdint>
#include <vector>

#include "arcway/datasets/occupancy_grid.h"

namespace arcway::internal {

/// A corner of cells: x to the right and y up, from the lower left corner of the grid.
struct Corner {
  std::int32_t x = 0, y = 0;
  friend bool operator==(const Corner&, const Corner&) = default;
};
/// Rings of corners with the blocked cells on their left: the first one outer and counter-clockwise, the others
/// holes and clockwise. No three consecutive corners lie on a line.
using CornerRing = std::vector<Corner>;
using CornerPolygon = std::vector<CornerRing>;

/// Polygons that cover the blocked cells and nothing else, by following the borders of the cells.
///
/// Blocked cells that touch at a side or at a corner are one obstacle; free cells meet at sides only. Two blocked cells
/// may meet at a corner alone (a pinch). A ring comes to that corner once on each of the two free sides and turns right
/// there, from one blocked cell to the other. Nothing is cut off or filled in. Rings touch each other and themselves at
/// pinches only; they never cross.
///
/// Obstacles are in the order of their lowest row and then from the left. O(cells), memory beside the result
/// about 20 bytes a run of blocked cells in a row.
std::vector<CornerPolygon> trace_blocked(const OccupancyGrid& grid, bool unknown_is_free);

}  // namespace arcway::internal

#include "arcway/datasets/occupancy_grid.h"

#include <algorithm>
#include <cmath>

namespace arcway {

Vec2 OccupancyGrid::to_world(const Vec2& p) const {
  const Vec2 local = cell_size * p;
  if (origin.heading == 0.0) return origin.position() + local;
  const Vec2 u = direction_of(origin.heading);
  return origin.position() + local.x() * u + local.y() * perpendicular(u);
}

void flip_rows(OccupancyGrid& grid) {
  for (std::size_t low = 0, high = grid.height; low + 1 < high; ++low) {
    --high;
    std::swap_ranges(grid.cells.begin() + static_cast<std::ptrdiff_t>(low * grid.width),
                     grid.cells.begin() + static_cast<std::ptrdiff_t>((low + 1) * grid.width),
                     grid.cells.begin() + static_cast<std::ptrdiff_t>(high * grid.width));
  }
}

}  // namespace arcway

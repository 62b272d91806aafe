#pragma once

#include <string>
#include <vector>

#include "arcway/datasets/occupancy_grid.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal::test {

/// Rows from the top: # is occupied, ? unknown, all else free.
inline OccupancyGrid grid_of(const std::vector<std::string>& rows) {
  OccupancyGrid grid;
  grid.width = rows.front().size();
  grid.height = rows.size();
  for (std::size_t y = grid.height; y-- > 0;) {
    for (const char c : rows[y])
      grid.cells.push_back(c == '#' ? Cell::kOccupied : c == '?' ? Cell::kUnknown : Cell::kFree);
  }
  return grid;
}

/// Noise of any density, or slanted bands and discs with noise: stairs of all slopes, pinches, pockets.
inline OccupancyGrid random_grid(std::uint64_t seed) {
  RandomInputs random(seed);
  OccupancyGrid grid;
  grid.width = static_cast<std::size_t>(random.integer(1, 40));
  grid.height = static_cast<std::size_t>(random.integer(1, 40));
  const double density = random.uniform(0.0, random.unit() < 0.5 ? 0.1 : 1.0);
  const bool shapes = random.unit() < 0.6;
  const Vec2 slope = direction_of(random.uniform(0.0, kTwoPi)), middle = random.point(0, 40);
  const double width = random.uniform(1.0, 8.0), radius = random.uniform(1.0, 12.0);
  for (std::size_t y = 0; y < grid.height; ++y) {
    for (std::size_t x = 0; x < grid.width; ++x) {
      const Vec2 p(static_cast<double>(x), static_cast<double>(y));
      const bool shape = shapes && (std::abs(cross(slope, p - middle)) < width || (p - middle).norm() < radius);
      grid.cells.push_back(shape != (random.unit() < density) ? Cell::kOccupied : Cell::kFree);
    }
  }
  return grid;
}

}  // namespace arcway::internal::test

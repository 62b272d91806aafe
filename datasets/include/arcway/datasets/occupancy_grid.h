#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "arcway/export.h"
#include "arcway/path.h"

namespace arcway {

enum class Cell : std::uint8_t { kFree, kOccupied, kUnknown };

/// Square cells in rows; row 0 is the lowest one.
struct ARCWAY_API OccupancyGrid {
  std::size_t width = 0;    ///< cells a row
  std::size_t height = 0;   ///< rows
  std::vector<Cell> cells;  ///< width * height, row by row upwards
  double cell_size = 1.0;   ///< [m]
  Pose origin;              ///< lower left corner of the lower left cell; the rows run along the heading

  [[nodiscard]] Cell at(std::size_t x, std::size_t y) const { return cells[y * width + x]; }
  [[nodiscard]] Cell& at(std::size_t x, std::size_t y) { return cells[y * width + x]; }
  /// World position of a point in cells, from the lower left corner.
  [[nodiscard]] Vec2 to_world(const Vec2& p) const;
};

/// Turns the grid upside down: files begin with the top row.
ARCWAY_API void flip_rows(OccupancyGrid& grid);

/// How files of cells are read and turned into polygons.
struct GridOptions {
  /// Cell size [m] of files that have none: MovingAI maps (default 1), images without a YAML file (default 0.05).
  std::optional<double> cell_size{};
  bool unknown_is_free = false;  ///< otherwise unknown cells are obstacles
  bool swamp_is_free = false;    ///< cells S of MovingAI maps; otherwise they are obstacles
  /// Letters of MovingAI maps that are free beside the point and G; then those that are not known are obstacles. None:
  /// letters that are not known are errors.
  std::optional<std::string> free_letters{};
  bool walled = true;  ///< nothing is free beyond the frame of the grid
  /// Obstacles may grow by this many cells where that saves corners; never do they shrink. 0: only what lies on a line.
  double tolerance = 0.0;
  /// Files of more cells are refused.
  std::size_t max_cells = 100'000'000;
};

}  // namespace arcway

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "arcway/datasets/occupancy_grid.h"

namespace arcway::internal {

/// Reads a map of the MovingAI benchmarks: `type octile`, height and width in either order, `map`, then rows from the
/// top. The header may be `height,width` and lines of other counts, or missing. `.` and `G` are free, `S` and other
/// letters if the options say so; `@`, `#`, `O`, `T`, `W` are occupied. One cell is one meter unless the options say
/// otherwise.
/// @param name  of the source, for messages.
/// @throws FormatError, "a.map: line 7, column 3: unknown cell "x"".
OccupancyGrid read_movingai_map(std::string_view text, std::string_view name, const GridOptions& options = {});

/// One line of a .scen file. Cells are counted from the upper left corner, y downwards.
struct MovingAiTask {
  std::string map;               ///< file, as on its author's disk
  std::size_t width, height;     ///< size of the map, in cells
  std::size_t start_x, start_y;  ///< less than width and height
  std::size_t goal_x, goal_y;
  double optimal_length;  ///< in cells, of a path over 8-connected cells that cuts no corner; no bound for a car
  std::size_t line;       ///< in the file
};
/// @throws FormatError, "a.map.scen: line 4: expected 9 fields, found 8".
std::vector<MovingAiTask> read_movingai_scenario(std::string_view text, std::string_view name);

/// The format has no headings: these are drawn for a seed and a task's index, the same on every platform.
struct TaskHeadings {
  double start, goal;  ///< in (-pi, pi]
};
TaskHeadings draw_headings(std::uint64_t seed, std::size_t task);

}  // namespace arcway::internal

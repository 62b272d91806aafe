#include "datasets/grid/grid_map.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/base/shortest_text.h"
#include "datasets/grid/simplify.h"
#include "datasets/grid/trace.h"

namespace arcway::internal {

MapFile to_map_file(const OccupancyGrid& grid, const GridOptions& options) {
  if (!(options.tolerance >= 0.0 && std::isfinite(options.tolerance)))
    throw std::invalid_argument("tolerance is " + shortest_text(options.tolerance) + " cells, must be at least 0");
  if (!(grid.cell_size > 0.0 && std::isfinite(grid.cell_size)))
    throw std::invalid_argument("cell size is " + shortest_text(grid.cell_size) + " m, must be positive");

  std::vector<CornerPolygon> polygons = trace_blocked(grid, options.unknown_is_free);
  const std::size_t traced = corner_count(polygons);
  simplify(polygons, options.tolerance);

  const auto ring_of = [&](const CornerRing& corners) {
    Ring ring;
    ring.reserve(corners.size());
    for (const Corner& corner : corners) ring.push_back(grid.to_world(Vec2(corner.x, corner.y)));
    return ring;
  };
  MapFile map;
  map.frame = CoordinateFrame::kMeters;
  map.obstacles.reserve(polygons.size());
  for (const CornerPolygon& polygon : polygons) {
    Polygon& obstacle = map.obstacles.emplace_back();
    obstacle.outer = ring_of(polygon.front());
    for (std::size_t k = 1; k < polygon.size(); ++k) obstacle.holes.push_back(ring_of(polygon[k]));
  }
  if (options.walled) {
    const auto w = static_cast<double>(grid.width), h = static_cast<double>(grid.height);
    map.bounds = Ring{grid.to_world({0, 0}), grid.to_world({w, 0}), grid.to_world({w, h}), grid.to_world({0, h})};
    map.bounds_place = "frame of the grid";
  }

  const auto count = [&](Cell cell) { return std::to_string(std::count(grid.cells.begin(), grid.cells.end(), cell)); };
  map.notes.push_back(std::to_string(grid.width) + " x " + std::to_string(grid.height) + " cells of " +
                      shortest_text(grid.cell_size) + " m: " + count(Cell::kFree) + " free, " + count(Cell::kOccupied) +
                      " occupied, " + count(Cell::kUnknown) + " unknown" +
                      (options.unknown_is_free ? " (taken as free)" : " (taken as occupied)"));
  map.notes.push_back(std::to_string(traced) + " corners traced" +
                      (options.tolerance > 0.0
                           ? ", " + std::to_string(corner_count(polygons)) + " left within " +
                                 shortest_text(options.tolerance) + (options.tolerance == 1.0 ? " cell" : " cells")
                           : ""));
  return map;
}

}  // namespace arcway::internal

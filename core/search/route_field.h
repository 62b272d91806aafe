#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/path/path.h"
#include "core/search/search_map.h"

namespace [[gnu::visibility("default")]] arcway {

/// Roughly how long the routes are from anywhere to a place, round the obstacles and through none of the gaps that are
/// too narrow for the body: Dijkstra over a grid whose steps cross neither an outline nor such a gap. An estimate that
/// guides searches; it proves nothing. Immutable, thread-safe.
class RouteField {
 public:
  /// The grid lies in the frame of a pose, so that a map that is moved and turned with its poses has the same field.
  /// O(cells log cells + edges).
  /// @param frame  start of the query, say.
  /// @param place  to which routes lead.
  /// @param most_cells  the grid has at most so many.
  /// @param stop   asked now and then; true leaves the rest of the grid without routes.
  RouteField(const SearchMap& map, const Pose& frame, const Vec2& place, std::size_t most_cells,
             const std::function<bool()>& stop);

  /// Length of the route from a point [m]. Where the grid has none, the distance as the crow flies and the longest
  /// route of all.
  [[nodiscard]] double operator()(const Vec2& from) const;

 private:
  struct Cell {
    float length;
    std::uint8_t walls;  // steps that are blocked: 1 to the right, 2 up
  };

  void lay_out(const SearchMap& map, std::size_t most_cells);
  void add_walls(const SearchMap& map);
  void add_wall(const Vec2& a, const Vec2& b);
  void spread(const std::function<bool()>& stop);
  [[nodiscard]] bool is_open(std::int64_t x, std::int64_t y, int dx, int dy) const;
  [[nodiscard]] bool has(std::int64_t x, std::int64_t y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  [[nodiscard]] const Cell& at(std::int64_t x, std::int64_t y) const {
    return cells_[static_cast<std::size_t>(y * width_ + x)];
  }
  [[nodiscard]] Cell& at(std::int64_t x, std::int64_t y) { return cells_[static_cast<std::size_t>(y * width_ + x)]; }
  // In units of cells.
  [[nodiscard]] Vec2 in_grid(const Vec2& p) const;

  Pose frame_;
  Vec2 ahead_;
  Vec2 place_;
  Vec2 corner_{0.0, 0.0};  // of the grid, in the frame
  double size_ = 1.0;      // of a cell
  std::int64_t width_ = 0, height_ = 0;
  double longest_ = 0.0;
  std::vector<Cell> cells_;
};

}  // namespace arcway

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "core/attach/roadmap.h"

namespace arcway::internal {

/// The grid of a RouteField, and where its routes lead.
struct RouteQuery {
  Pose frame;              ///< of the grid: a pose of the query, such as its start
  Pose to;                 ///< the pose to which routes lead; its heading matters once routes turn
  std::size_t most_cells;  ///< largest number of cells of the grid
  /// Steps near one of these paths count as longer, and as longer again near another one: routes mostly take other
  /// ways where there are any. Used during the construction only.
  std::span<const Path> avoided = {};
};

/// Estimates of the length of routes from anywhere to a pose, around obstacles and not through gaps too narrow for the
/// body. They guide searches and prove nothing. Dijkstra's algorithm runs over a grid whose steps cross neither an
/// outline nor such a gap. At first the routes are those of a point that turns on the spot. Where that misleads,
/// heed_turns makes them turn with a radius.
class RouteField {
 public:
  /// The grid lies in the frame of a pose. A map that is moved and turned with its poses has the same field. O(cells
  /// log cells + edges).
  /// @param clock  may end the construction; the rest of the grid, or all of it, then has no routes.
  RouteField(const Roadmap& map, const RouteQuery& query, const StopClock& clock = {});

  /// Makes routes turn with a radius [m] from now on. O(cells log cells), some ten times as long as the constructor.
  void heed_turns(double radius, const StopClock& clock = {});

  /// The length of the route from a pose [m]. Where the grid has none, that of a point that turns on the spot, or the
  /// distance plus the longest route of all.
  [[nodiscard]] double operator()(const Pose& from) const;

 private:
  struct Cell {
    float length;
    std::uint8_t walls;  // steps that are blocked: 1 to the right, 2 up
  };

  void lay_out(const Roadmap& map, std::size_t most_cells, const StopClock& clock);
  void add_walls(const Roadmap& map, const StopClock& clock);
  void add_wall(const Vec2& a, const Vec2& b);
  void avoid(std::span<const Path> paths, double within, const StopClock& clock);
  void spread(const StopClock& clock);
  [[nodiscard]] double without_turns(const Vec2& from) const;
  // Whether a step to one of the eight neighboring cells is possible.
  [[nodiscard]] bool is_free(std::int64_t x, std::int64_t y, int dx, int dy) const;
  [[nodiscard]] bool is_open(std::int64_t x, std::int64_t y, int dx, int dy) const;
  [[nodiscard]] bool has(std::int64_t x, std::int64_t y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  [[nodiscard]] const Cell& at(std::int64_t x, std::int64_t y) const {
    return cells_[static_cast<std::size_t>(y * width_ + x)];
  }
  [[nodiscard]] Cell& at(std::int64_t x, std::int64_t y) { return cells_[static_cast<std::size_t>(y * width_ + x)]; }
  // By how much a step to a cell counts as longer.
  [[nodiscard]] float factor_at(std::int64_t x, std::int64_t y) const {
    return factors_.empty() ? 1.0F : factors_[static_cast<std::size_t>(y * width_ + x)];
  }
  // A position in units of cells.
  [[nodiscard]] Vec2 in_grid(const Vec2& p) const;

  static constexpr int kHeadings = 16;
  // A motion from a heading of the grid to the same heading or a neighboring one.
  struct Motion {
    int turn;                               // in headings
    float length;                           // in cells
    std::vector<std::array<int, 2>> steps;  // from cell to cell
  };
  [[nodiscard]] static Motion motion(int heading, int turn, double radius);
  // A heading in the frame, in steps of the grid.
  [[nodiscard]] double heading_in_grid(double heading) const;
  template <class Visit>
  static void visit_around(const Vec2& p, Visit&& visit);

  Pose frame_;
  Vec2 ahead_;
  Pose to_;
  std::vector<float> lengths_;  // with turns, by cell and heading
  double longest_with_turns_ = 0.0;
  Vec2 corner_{0.0, 0.0};  // of the grid, in the frame
  double size_ = 1.0;      // of a cell
  std::int64_t width_ = 0, height_ = 0;
  double longest_ = 0.0;
  std::vector<Cell> cells_;
  std::vector<float> factors_;  // by cell; empty: none is avoided
  float largest_factor_ = 1.0F;
};

}  // namespace arcway::internal

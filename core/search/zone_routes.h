#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "arcway/stop_clock.h"
#include "arcway/vec2.h"
#include "core/attach/roadmap.h"
#include "core/base/late_value.h"
#include "core/zones/speed_zones.h"

namespace arcway::internal {

/// Estimates of the fastest routes of a point through a map whose zones limit the speed: around slow zones, or across
/// them where that pays. They guide searches and prove nothing. Acceleration and turns are left out.
///
/// 1. Fast marching over a grid of equilateral triangles gives the times from all nodes to a place [Kimmel and Sethian
///    1998]. Nodes within half a body's width of an obstacle are blocked, and nodes in one-way zones: fronts know no
///    direction.
/// 2. The route follows the steepest descent.
/// 3. Places are left out and moved as long as that saves time, by the exact times of the lines between them.
///
/// The grid is made when first asked for. Thread-safe.
class ZoneRoutes {
 public:
  /// @param map  with speed zones; must outlive this.
  explicit ZoneRoutes(const Roadmap& map) : map_(map) {}

  struct Route {
    std::vector<Vec2> places;  ///< from start to goal [m]
    double time;               ///< along the lines between them [s]
  };
  /// O(nodes log nodes).
  /// @param slower  factor by which limits count as lower than they are, >= 1: larger ones lead around more zones.
  /// @return nothing if no route was found, or if the clock is over before.
  [[nodiscard]] std::optional<Route> find(const Vec2& start, const Vec2& goal, double slower,
                                          const StopClock& clock) const;

 private:
  class Search;
  // A grid of equilateral triangles. Odd rows are shifted by half a step.
  struct Grid {
    Vec2 corner{0.0, 0.0};
    double step = 1.0;
    std::int64_t columns = 0, rows = 0;
    std::vector<double> speeds;  // by node [m/s]; 0 where an obstacle is too near

    [[nodiscard]] Vec2 place(std::int64_t column, std::int64_t row) const;
  };
  [[nodiscard]] Grid make_grid(const StopClock& clock) const;
  // The time on a line between two places; infinity if an obstacle is in between.
  [[nodiscard]] double time_between(const Vec2& from, const Vec2& to, std::vector<SpeedZones::Stretch>& parts) const;
  // The route over places once it cannot be shortened, moving them by at most about `step` [m] at first.
  [[nodiscard]] Route shortest_over(std::vector<Vec2> places, double step, const StopClock& clock) const;

  const Roadmap& map_;
  LateValue<Grid> grid_;
};

}  // namespace arcway::internal

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/vec2.h"
#include "core/attach/roadmap.h"

namespace arcway::internal {

/// Proposals of routes through and around one-way zones in the open, where the roadmap has no circles. They guide
/// searches and prove nothing. Obstacles are left to these searches.
///
/// 1. Places are corners of the zones, moved out by the tightest turning radius, and points on their edges. Each of
///    these has one more on the other side of its zone, along each of three directions that the zone allows.
/// 2. A line between two places may be driven if all zones allow it.
/// 3. The shortest route over such lines is found by A*. Each place counts as long as the tightest turning radius.
/// 4. Its places are moved, alone and two by two, as long as that makes it shorter and no obstacle gets in between.
class OneWayRoutes {
 public:
  /// O(edges of one-way zones). Where these are more than 60, only some edges and corners have places; where they are
  /// more than 1,000, none has.
  /// @param map  with one-way zones; must outlive this.
  OneWayRoutes(const Roadmap& map, const Pose& start, const Pose& goal);

  /// The shortest route but for what was left out: poses from start to goal, with the headings of lines that zones
  /// limit, or halfway between two lines. The line from start to goal is no route. O(places^2).
  /// @return nothing if there is none, or if the clock is over before.
  [[nodiscard]] std::optional<std::vector<Pose>> find(const StopClock& clock);
  /// Leaves out a line of the route found last.
  /// @param line  from the pose of this index to the next one.
  void leave_out(std::size_t line);

 private:
  void add_places(const Zone& zone, std::size_t every);
  void add_corners(const Ring& ring, std::size_t every);
  void add_crossings(const Zone& zone, const Vec2& place);
  [[nodiscard]] bool is_allowed(const Vec2& from, const Vec2& to) const;
  void shorten(std::vector<Vec2>& route, const StopClock& clock) const;
  // Moves `count` places, the i-th and those behind it, if that makes the route shorter.
  bool move(std::vector<Vec2>& route, std::size_t i, std::size_t count, const Vec2& by) const;
  [[nodiscard]] std::vector<Pose> poses_over(const std::vector<Vec2>& route) const;

  const Roadmap& map_;
  Pose start_, goal_;
  std::vector<Vec2> places_;  // start and goal first
  std::vector<std::uint32_t> route_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> left_out_;
};

}  // namespace arcway::internal

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "arcway/heuristic.h"
#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/time_model.h"
#include "arcway/world.h"
#include "core/motion/end_speeds.h"

namespace arcway::internal {

/// As a number of radii: all of the roadmap.
inline constexpr std::size_t kEveryRadius = std::numeric_limits<std::size_t>::max();

/// Options of one search on a roadmap.
struct SearchOptions {
  Heuristic heuristic = Heuristic::kTravelTime;
  StopClock clock = {};    ///< ends the search; the best path found by then is returned
  double cusp_cost = 0.0;  ///< cost of a gear change in a connection, beside the time for it [s]
  /// The gear in which the search's forward motions are driven. In kReverse the path found is to be driven from its end
  /// to its start, and has the speeds of the reverse gear.
  Gear gear = Gear::kForward;
  TimeModel time_model = TimeModel::kProfile;
  EndSpeeds ends = {};         ///< of the path found, in the direction of its motions
  double suboptimality = 0.0;  ///< w >= 0: the path may take 1 + w times as long as the fastest one
  /// Whether to continue the previous search of the same workspace, which had the same start and goal poses. What its
  /// starts reach is not searched again. If its map and vehicle were the same and its attachments the first of these,
  /// only paths by the further attachments are searched.
  bool warm_start = false;
  /// Whether the search may stop to test if the goal can be reached at all. It does so where many attachments or many
  /// expansions suggest that there is no path.
  bool doubts_reachability = true;
  /// Paths that take at least this time are not wanted [s].
  double faster_than = std::numeric_limits<double>::infinity();
  /// With a warm start: an arrival known before is not searched again for a gain of less than this [s].
  double least_gain = 0.0;
  /// Number of expansions after which the best path found by then, if any, is good enough.
  std::uint64_t most_expanded = std::numeric_limits<std::uint64_t>::max();
  /// Circles of the graph that a path may not join first, or leave for the goal; kNone: all allowed. They are those of
  /// a known path, where another route is wanted.
  std::uint32_t not_first = kNone, not_last = kNone;
  /// A turn around an obstacle, see Way::turn_around, that the path may not take; kNone: all allowed. It is one of a
  /// known path, where another way is wanted.
  std::uint32_t not_around = kNone;
  /// Number of radii, from the smallest on, of the circles by which start and goal join the roadmap.
  std::size_t end_radii = kEveryRadius;
  /// Whether a second thread runs ahead of a long search on a lazy graph, in a workspace of its own. It computes rows,
  /// headings and bitangents that the search will ask for.
  bool prefetch = false;
  [[nodiscard]] bool interrupted() const { return clock.is_over(); }
};

/// What searches did, for PlanStatistics.
struct SearchCounts {
  std::uint64_t nodes_expanded = 0;
  std::uint64_t nodes_pushed = 0;
  std::uint64_t straights_checked = 0;
  std::uint64_t turns_checked = 0;

  SearchCounts& operator+=(const SearchCounts& other) {
    nodes_expanded += other.nodes_expanded;
    nodes_pushed += other.nodes_pushed;
    straights_checked += other.straights_checked;
    turns_checked += other.turns_checked;
    return *this;
  }
};

/// The way that a path takes: which obstacles it turns around one after the other, and to which sides.
struct Way {
  /// An obstacle and a side of one turn: twice the obstacle's number, plus 1 to the left.
  static std::uint32_t turn_around(std::uint32_t obstacle, bool left) { return 2 * obstacle + (left ? 1 : 0); }

  std::uint64_t number = 0;  ///< paths of one way have the same; 0 if the path touches no circle of the graph
  std::size_t count = 0;     ///< of `turns`
  std::array<std::uint32_t, 16> turns{};  ///< the first of them; several in a row around one obstacle count as one
};

/// The result of one search.
struct SearchResult {
  std::optional<Path> path;  ///< from start to goal, connections included
  /// The circles of the graph that the path joins first, and leaves for the goal; kNone if it touches none.
  std::uint32_t first_circle = kNone, last_circle = kNone;
  Way way;
  bool interrupted = false;      ///< by the clock; a path is then the best one found by then
  bool start_connected = false;  ///< some motion leads from a start attachment to the graph or the goal
  bool goal_connected = false;  ///< some straight leads from a circle, reached or not, to a circle of a goal attachment
  bool start_is_open = false;   ///< without a path: the starts reach thousands of arcs
  SearchCounts counts;
};

}  // namespace arcway::internal

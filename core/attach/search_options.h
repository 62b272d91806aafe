#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <stop_token>

#include "arcway/heuristic.h"
#include "arcway/path.h"
#include "arcway/time_model.h"
#include "arcway/world.h"

namespace arcway::internal {

struct SearchOptions {
  Heuristic heuristic = Heuristic::kTravelTime;
  StopClock clock = {};    ///< ends the search, with the best path found by then
  double cusp_cost = 0.0;  ///< of a change of gear in a connection, beside the time for it [s]
  /// Gear in which the vehicle is driven where the search drives forwards; if backwards, the path found is to be driven
  /// the other way, and has the speeds of that.
  Gear gear = Gear::kForward;
  TimeModel time_model = TimeModel::kProfile;
  double suboptimality = 0.0;  ///< w >= 0: the path found may take 1 + w times as long as the fastest one
  /// The search before in the same workspace was asked for a path between the same poses: what its starts reach is
  /// known. If it was a part of this one, on the same map, of the same vehicle, and with the first of the attachments,
  /// only paths that it has not found are looked for.
  bool warm_start = false;
  /// Where many attachments or a long search say that there may be no path, ask whether there is one at all.
  bool doubts_reachability = true;
  /// Only paths that take less than one that is known are wanted [s].
  double faster_than = std::numeric_limits<double>::infinity();
  /// Of a search that goes on from one that found a path: what saves less than this does not matter [s].
  double least_gain = 0.0;
  /// After so many expansions the best path found by then, if any, will do.
  std::uint64_t most_expanded = std::numeric_limits<std::uint64_t>::max();
  /// Circles of the graph that a path may not join first, or leave for the goal: those of a path that is known, where
  /// another one is wanted. kNone: any may be.
  std::uint32_t not_first = kNone, not_last = kNone;
  /// Another thread, with a workspace of its own, runs ahead of a long search on a lazy graph. It finds rows, headings
  /// and bitangents that this one will ask for; what it misses, this one finds itself.
  bool prefetch = false;
  [[nodiscard]] bool interrupted() const { return clock.is_over(); }
};

struct SearchResult {
  std::optional<Path> path;  ///< from start to goal, connections in
  /// Circles of the graph that the path joins first, and leaves for the goal; kNone if it touches none.
  std::uint32_t first_circle = kNone, last_circle = kNone;
  bool interrupted = false;      ///< by the stop token or the deadline; a path is then the best one found by then
  bool start_connected = false;  ///< some motion leads from a start attachment to the graph or the goal
  bool goal_connected = false;   ///< some straight leads from a circle, reached or not, to a goal attachment's circle
  bool start_is_open = false;    ///< without a path: thousands of arcs can be reached from the start attachments
  std::uint64_t nodes_expanded = 0;
  std::uint64_t nodes_pushed = 0;
  std::uint64_t straights_checked = 0;
  std::uint64_t turns_checked = 0;
};

}  // namespace arcway::internal

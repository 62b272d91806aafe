#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "core/path/path.h"
#include "core/search/heuristic.h"
#include "core/search/search_map.h"
#include "core/search/terminal_links.h"
#include "core/search/time_model.h"
#include "core/stop_clock.h"

namespace [[gnu::visibility("default")]] arcway {

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
  /// known. If it was a part of this one, on the same map, of the same vehicle, and with the first of the terminals,
  /// only paths that it has not found are looked for.
  bool goes_on = false;
  /// Where many terminals or a long search say that there may be no path, ask whether there is one at all.
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
  bool scout = false;
  [[nodiscard]] bool interrupted() const { return clock.is_over(); }
};

struct SearchResult {
  std::optional<Path> path;  ///< from start to goal, connections in
  /// Circles of the graph that the path joins first, and leaves for the goal; kNone if it touches none.
  std::uint32_t first_circle = kNone, last_circle = kNone;
  bool interrupted = false;      ///< by the stop token or the deadline; a path is then the best one found by then
  bool start_connected = false;  ///< some motion leads from a start terminal to the graph or the goal
  bool goal_connected = false;   ///< some straight leads from a circle, reached or not, to a goal terminal's circle
  bool start_is_open = false;    ///< without a path: thousands of arcs can be reached from the start terminals
  std::uint64_t nodes_expanded = 0;
  std::uint64_t nodes_pushed = 0;
  std::uint64_t straights_checked = 0;
  std::uint64_t turns_checked = 0;
};

/// Memory of a search, kept for the next one: for one search at a time, of any map.
class SearchWorkspace {
 public:
  SearchWorkspace();
  ~SearchWorkspace();
  SearchWorkspace(SearchWorkspace&&) noexcept;
  SearchWorkspace& operator=(SearchWorkspace&&) noexcept;

  struct Data;
  Data& operator*() { return *data_; }
  /// Forgets the search before, and has most of the memory at hand that one on a graph with so many circles asks for.
  void warm_up(std::size_t circles);
  /// Takes the memory of a path that a search gave, for the next one.
  void reuse(Path&& path);

 private:
  std::unique_ptr<Data> data_;
};

/// The fastest path of the feasible graph under the true speed profile: from rest to rest, at most v_ms on lines and
/// v_mc on arcs, |dv/dt| <= a_max, whatever number of segments the speeding up and the braking take.
///
/// A* over directed arrivals, (11): a label is an arrival on a circle at the end of a bitangent by some path, with the
/// speed profile of that path, see SpeedTree. On one circle a label ends where another one goes on at least as well at
/// every speed. Departures are sorted by heading, so that one walk along the arc relaxes them in turn: linear in the
/// bitangents. Complete paths come off the open list with their exact time, so that the first one is the fastest.
///
/// Up to 16 labels on one circle, this comparison is exact. The n-th label ends as well where another one loses less
/// than the share 1e-4 * floor(n / 16) of its time. A path of k circles found then takes at most as long as the
/// fastest one times the product of 1 + that share over the k circles; without a circle of more than 16 labels it is
/// the fastest. The tolerance bounds searches in tight places, where hundreds of paths differ by nanoseconds.
///
/// After some hundred labels, or with several terminals, walks without times and speeds find out whether there is a
/// path at all: see Reachability.
///
/// With a suboptimality w the heuristic counts 1 + w times, which finds some path sooner. The one found takes at most
/// 1 + w times as long as the fastest: at any time, the open list has an entry from which the fastest path goes on, or
/// one as fast, since a label ends only where another one, expanded before, does as well at every speed; one that comes
/// later, but is better, is expanded as well. The estimate of that entry is the time T so far and 1 + w times a bound
/// on the rest, so at most 1 + w times the fastest time; the complete path that comes off first is not behind it.
///
/// Terminals join by their left and right circles of every radius, driven forwards whatever the gear of their
/// connections, and to each other by all six Dubins words. Straights of terminals, and those of lazy graphs, are
/// checked when they come off the open list. Ties are broken by what the labels are, not by memory or time: same answer
/// every time, for eager and lazy graphs.
SearchResult search_arrivals(const SearchMap& map, std::span<const Terminal> starts, std::span<const Terminal> goals,
                             const SearchOptions& options, SearchWorkspace& workspace);

}  // namespace arcway

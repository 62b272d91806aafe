#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "core/attach/attachment_links.h"
#include "core/attach/roadmap.h"
#include "core/attach/search_options.h"

namespace arcway::internal {

/// Finds the fastest path of the feasible graph under the true speed profile: between the end speeds of the options, at
/// most v_ms on lines and v_mc on arcs, |dv/dt| <= a_max. Speeding up and braking may take any number of segments.
///
/// **Search.** A* over directed arrivals, (11). A label is an arrival on a circle at the end of a bitangent, by some
/// path, with the speed profile of that path (see SpeedTree). A label is dropped if another one on its circle goes on
/// at least as well at every speed. Departures are sorted by heading, so that one walk along the arc relaxes them in
/// turn: linear in the bitangents. Complete paths come off the open list with their exact time, so that the first one
/// is the fastest.
///
/// **Moving ends.** A label holds the time at every speed from the lowest one, as far as the vehicle can brake from the
/// start, to the highest one. One that is slower than another one and than the goal replaces no other. No path of
/// forward motions has a negative end speed.
///
/// **Many labels.** Up to 16 labels on one circle are compared exactly. The n-th label is also dropped if another one
/// loses less than the share e = 1e-4 * floor(n / 16) of its time. A path of k circles then takes at most as long as
/// the fastest one times the product of 1 + e over the k circles. Without a circle of more than 16 labels the path is
/// the fastest. The tolerance limits searches in tight places, where hundreds of paths differ by nanoseconds.
///
/// **Reachability.** After some hundred labels, or with several attachments, walks without times and speeds find out
/// whether there is a path at all: see Reachability.
///
/// **Suboptimality.** With a suboptimality w the heuristic counts 1 + w times, which finds some path sooner. That path
/// takes at most 1 + w times as long as the fastest one:
/// 1. At any time, the open list has an entry from which the fastest path goes on, or one as fast. A label is dropped
///    only if another one, expanded before, does as well at every speed. A better one that comes later is expanded too.
/// 2. The estimate of that entry is its time T plus 1 + w times a lower bound on the rest: at most 1 + w times the
///    fastest time.
/// 3. The complete path that comes off first is not behind that entry.
///
/// **Attachments.** Attachments join by left and right circles of every radius, driven forwards whatever the gear of
/// their connections, and to each other by all six Dubins words. Straights of attachments and of lazy graphs are
/// checked when they come off the open list.
///
/// Ties are broken by the labels alone, not by memory or time: the answer is the same every time, for eager and lazy
/// graphs.
///
/// Memory is kept for the next search, on any map. One search at a time.
class ArrivalSearch {
 public:
  ArrivalSearch();
  ~ArrivalSearch();
  ArrivalSearch(ArrivalSearch&&) noexcept;
  ArrivalSearch& operator=(ArrivalSearch&&) noexcept;

  SearchResult find(const Roadmap& map, std::span<const Attachment> starts, std::span<const Attachment> goals,
                    const SearchOptions& options);

  /// Searches from now on are those of one query: they share what they find out about start and goal.
  void begin_query();
  /// Forgets the search before, and takes most of the memory that a search on a graph of `circles` circles needs.
  void warm_up(std::size_t circles);
  /// Takes the memory of a path that a search returned.
  void reuse(Path&& path);
  /// An empty path, with memory of one that was given back.
  Path empty_path();

 private:
  struct Memory;
  class Run;
  std::unique_ptr<Memory> memory_;
};

}  // namespace arcway::internal

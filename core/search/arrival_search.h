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
/// After some hundred labels, or with several attachments, walks without times and speeds find out whether there is a
/// path at all: see Reachability.
///
/// With a suboptimality w the heuristic counts 1 + w times, which finds some path sooner. The one found takes at most
/// 1 + w times as long as the fastest: at any time, the open list has an entry from which the fastest path goes on, or
/// one as fast. For a label ends only where another one, expanded before, does as well at every speed; one that comes
/// later, but is better, is expanded as well. The estimate of that entry is the time T so far and 1 + w times a bound
/// on the rest, so at most 1 + w times the fastest time; the complete path that comes off first is not behind it.
///
/// Attachments join by their left and right circles of every radius, driven forwards whatever the gear of their
/// connections, and to each other by all six Dubins words. Straights of attachments, and those of lazy graphs, are
/// checked when they come off the open list. Ties are broken by what the labels are, not by memory or time: same answer
/// every time, for eager and lazy graphs.
SearchResult search_arrivals(const Roadmap& map, std::span<const Attachment> starts, std::span<const Attachment> goals,
                             const SearchOptions& options, SearchWorkspace& workspace);

}  // namespace arcway::internal

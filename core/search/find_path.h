#pragma once

#include <cstddef>
#include <functional>

#include "core/attach/maneuvers.h"
#include "core/attach/narrow_places.h"
#include "core/search/arrival_search.h"

namespace arcway::internal {

/// What stands in the way.
enum class Obstruction {
  kNothing,
  kStart,    ///< nothing leads from the start, or from the poses reached from it, to a circle of the graph
  kGoal,     ///< nothing leads from a circle of the graph to the goal, or to poses from which it is reached
  kBetween,  ///< the graph joins neither to the other
  kPassage   ///< it is known that there is no path
};

struct FoundPath {
  SearchResult search;  ///< counters summed up over all searches
  Obstruction obstruction = Obstruction::kNothing;
  std::size_t maneuver_poses = 0;  ///< tried
  bool by_narrow_places = false;   ///< the path is one of the graph with circles in narrow places
};

/// Memory of both, kept for the next time.
struct FindWorkspace {
  SearchWorkspace search;
  ManeuverWorkspace from, to;
};

/// The fastest path between two poses: by single arcs at both ends or, where these lead nowhere, by short maneuvers of
/// several arcs, first of few poses, then of more, at the end that is in trouble; last of sparse ones at both, if each
/// joins the graph. Before the maneuvers, and with few of them after all, the graph with circles in narrow places is
/// tried.
/// @param places  of `map`; none: only the map itself is searched.
/// @param max_poses  for the maneuvers of each end, four times as many if sparse.
/// @param no_passage  asked once, before the maneuvers: whether it is known that there is no path at all.
FoundPath find_path(const Roadmap& map, const NarrowPlaces* places, const Pose& start, const Pose& goal,
                    std::size_t max_poses, const std::function<bool()>& no_passage, const SearchOptions& options,
                    FindWorkspace& workspace);

/// The fastest path that may begin and end with a maneuver, out of a few sparse ones: faster than a path by single
/// arcs where a pose faces away from its way and there is room to turn, but slower to find.
/// @param poses  for the maneuvers of each end.
FoundPath find_path_with_maneuvers(const Roadmap& map, const Pose& start, const Pose& goal, std::size_t poses,
                                   const SearchOptions& options, FindWorkspace& workspace);

}  // namespace arcway::internal

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "arcway/path.h"
#include "core/search/effort.h"
#include "core/search/forward_search.h"
#include "core/search/surroundings.h"

namespace arcway::internal {

/// Limits of a search by trees.
struct TreeLimits {
  std::size_t poses;  ///< number of poses grown in all, O(edges near by) each; fewer where those are very many
  std::span<const TreePass> passes;
  TreeEffort effort;
  /// The surroundings of the ends are explored with this effort where a tree runs dry, or a pass finds no path. Null:
  /// they are not.
  const SurroundingsEffort* surroundings_effort = nullptr;
  std::span<const TreePass> dead_end_passes = {};  ///< taken instead of the other passes if an end lies in a dead end
  /// Makes the wanted path of one that is found, or refuses it by returning nothing; the search then continues. Empty:
  /// any path will do.
  std::function<std::optional<Path>(const Path&)> accept = {};
  std::span<const Path> avoided = {};  ///< paths off which the trees keep, see RouteQuery
};

/// What trees grow between. The map must outlive the search.
struct TreeQuery {
  const Roadmap& map;
  Pose start, goal;
  TreeLimits limits;
};

/// How a search by trees ended.
struct TreesEnd {
  std::size_t poses = 0;                            ///< grown
  Surroundings surroundings = Surroundings::kOpen;  ///< of the end in more trouble, if they were explored
  std::size_t refused = 0;                          ///< paths that were not accepted
  /// Whether, in the last pass, no pose of the end's tree was far from its root.
  bool start_in_dead_end = false, goal_in_dead_end = false;
  /// Whether, in the last pass, one tree had no more poses to expand, as far as its grid tells poses apart.
  bool ran_dry = false;
};

/// Finds a path of a vehicle that does not reverse, where start, goal or gaps are too narrow for the roadmap. Two trees
/// of poses grow from start and goal in turn, guided by the routes through gaps that are wide enough. New poses are
/// joined to near poses of the other tree by biarcs and Dubins words, and now and then to the roadmap. Passes tell
/// poses apart more and more finely. Where a tree runs dry, a search may explore the surroundings of the ends, and
/// ends early if one of them is closed (surroundings.h). Paths are checked exactly. As the number of poses is limited,
/// finding no path proves nothing. A path is free, but seldom the fastest. Deterministic unless interrupted.
/// @param end  receives how the trees ended.
FoundPath search_trees(const TreeQuery& query, const SearchOptions& options, ArrivalSearch& arrivals, TreesEnd& end);

}  // namespace arcway::internal

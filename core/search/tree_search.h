#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "arcway/path.h"
#include "core/search/effort.h"
#include "core/search/forward_search.h"
#include "core/search/way_out.h"

namespace arcway::internal {

/// What a search by trees may take.
struct TreeLimits {
  std::size_t poses;  ///< that are grown in all, O(edges near by) each; fewer where these are very many
  std::span<const TreePass> passes = kTreePasses;
  bool looks_around = true;  ///< for a way out of the surroundings of each end first
  /// Makes the path that is wanted of one that is found, or nothing: then another one is looked for. Empty: any will
  /// do.
  std::function<std::optional<Path>(const Path&)> accept = {};
};

/// How the trees of a search were left.
struct TreesEnd {
  std::size_t poses = 0;                            ///< that were grown
  Surroundings surroundings = Surroundings::kOpen;  ///< if these were looked at: of the end that is in more trouble
  std::size_t refused = 0;                          ///< paths that were not accepted
  /// Of the last pass: no pose of the tree is far from its root.
  bool start_in_dead_end = false, goal_in_dead_end = false;
  /// Of the last pass: no motion leads on from any pose of one tree, as far as its grid tells poses apart.
  bool ran_dry = false;
};

/// A path of a vehicle that does not reverse, for starts, goals and passages so narrow that the roadmap has none: two
/// trees of poses grow from start and goal, by turns, guided by the routes through gaps that are wide enough. New poses
/// are joined to the nearest ones of the other tree by biarcs and Dubins words, and now and then to the roadmap. Passes
/// tell poses apart more and more finely. A search may first look for a way out of the surroundings of each end, which
/// ends it early if there is none, see way_out.h. Paths are checked exactly; the number of poses is limited, so
/// that no path proves nothing. Deterministic unless interrupted. The path is as free as any, but by no means the
/// fastest.
/// @param end  is told how the trees were left.
FoundPath search_trees(const Roadmap& map, const Pose& start, const Pose& goal, const TreeLimits& limits,
                       const SearchOptions& options, SearchWorkspace& workspace, TreesEnd& end);

}  // namespace arcway::internal

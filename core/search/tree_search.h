#pragma once

#include <cstddef>

#include "core/search/find_path.h"

namespace [[gnu::visibility("default")]] arcway {

/// A path of a vehicle that does not reverse, for starts, goals and passages so narrow that the roadmap has none: two
/// trees of poses grow from start and goal, by turns, guided by the routes through gaps that are wide enough. New poses
/// are joined to the nearest ones of the other tree by biarcs and Dubins words, and now and then to the roadmap. Passes
/// tell poses apart more and more finely. Paths are checked exactly; the number of poses is limited, so that no path
/// proves nothing. Deterministic unless interrupted. The path is as free as any, but by no means the fastest.
/// @param max_poses  that are grown in all, O(edges near by) each.
FoundPath search_trees(const SearchMap& map, const Pose& start, const Pose& goal, std::size_t max_poses,
                       const SearchOptions& options, SearchWorkspace& workspace);

}  // namespace arcway

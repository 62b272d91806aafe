#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcway::internal {

/// How trees of forward motions grow. Lengths are in lengths of the body, or in units of `size`: the larger one of the
/// body's length and the smallest turning radius.
struct TreeShape {
  std::array<double, 11> bends;  ///< curvatures tried from every pose, as shares of the largest one
  std::array<double, 4> shares;  ///< shares of the free length at which motions end
  double longest;                ///< longest motion [size]
  double coarsest;               ///< largest cell in which poses count as one [size]
  /// Added to the estimates of a coarse cell by each expansion of one of its poses, in units of that cell. A tree that
  /// follows the estimate into a dead end then leaves it after few expansions.
  double visit;
  double least;     ///< shortest motion that is worth a pose
  double slack;     ///< length by which motions end before a contact: more than rounding
  double dead_end;  ///< largest distance from the root of a tree in a dead end [size]
  double greed;     ///< factor of the estimate of the rest of the route
};
inline constexpr TreeShape kTree{
    .bends = {-1.0, -0.7, -0.4, -0.2, -0.08, 0.0, 0.08, 0.2, 0.4, 0.7, 1.0},
    .shares = {1.0, 0.75, 0.5, 0.25},
    .longest = 2.0,
    .coarsest = 0.125,
    .visit = 30.0,
    .least = 1e-3,
    .slack = 1e-6,
    .dead_end = 4.0,
    .greed = 2.0,
};

/// One pass of a search by trees. Each is finer than the passes before, which found nothing.
struct TreePass {
  double finest;     ///< size of the smallest cells, in lengths of the body
  int halvings;      ///< number of halvings of the steps between curvatures, where obstacles end motions early
  double share;      ///< share of the search's poses that the pass may grow
  bool heeds_turns;  ///< whether the estimate of the rest of the route heeds the turning radius
};

/// How the surroundings of one end are explored.
struct SurroundingsEffort {
  TreePass coarse;    ///< pass of the first tree
  std::size_t poses;  ///< largest number of expansions of the first tree
  std::size_t small;  ///< largest number of expansions of a first tree that a finer one checks
  TreePass fine;      ///< pass of the finer tree
  double more;        ///< largest number of expansions of the finer tree, as a multiple of the first one's
};

/// How trees are joined, and what ends a pass.
struct TreeEffort {
  std::size_t field_cells;       ///< largest number of cells of the grid that estimates the rest of the route
  std::array<double, 3> ratios;  ///< ratios of the tangent lengths of the biarcs tried
  double near;                   ///< size of the cells in which poses near by are looked up, in lengths of the body
  std::size_t nearest;           ///< number of poses of the other tree that a new pose is joined to
  std::size_t first_roadmap;     ///< number of expansions after which poses are first joined to the roadmap
  std::size_t roadmap_factor;    ///< ratio of that number from one time to the next
  std::uint64_t edges;           ///< largest number of edges compared with motions, for each pose; some 60 ns each
  std::size_t after_dry;         ///< largest number of expansions, as a multiple of those by which one tree ran dry
  std::size_t attachments;       ///< largest number of poses of each tree that are joined to the roadmap
  std::size_t most_refused;      ///< number of refused paths after which the search gives up
  std::size_t refused_poses;     ///< poses grown after the first refused path; n times as many after the n-th one
};

}  // namespace arcway::internal

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcway::internal {

/// How trees of forward motions grow. Lengths are in lengths of the body, unless said otherwise.
struct TreeShape {
  std::array<double, 11> bends;  ///< curvatures looked at first, times the smallest turning radius
  std::array<double, 4> shares;  ///< of the room, where motions end
  double longest;                ///< motion, in lengths of the body or turning radii, whichever is larger
  double coarsest;               ///< cell in which poses count as one, likewise
  double visit;     ///< what each turn of a pose makes its coarse cell less promising, in such cells: a tree
                    ///< that follows the estimate into a dead end leaves it after few turns
  double least;     ///< motion that is worth a pose
  double slack;     ///< by which motions end before a contact: more than rounding
  double dead_end;  ///< how far a tree gets in a dead end, in lengths of the body or turning radii, likewise
  double greed;     ///< what the estimate of the way that remains counts
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

/// One pass of a search by trees: what is tried where the passes before found nothing.
struct TreePass {
  double finest;     ///< size of the smallest cells, in lengths of the body
  int halvings;      ///< of the steps between curvatures, where obstacles end motions early
  double share;      ///< of all poses that are grown at most
  bool heeds_turns;  ///< in the estimate of the way that remains
};

/// How the surroundings of one end are explored.
struct SurroundingsEffort {
  TreePass coarse;    ///< of the first tree
  std::size_t poses;  ///< of it that have their turns at most
  std::size_t small;  ///< poses of a tree that is compared with a finer one: ways out of larger ones are often found
  TreePass fine;      ///< of that one
  double more;        ///< times as many poses as the first tree has it may have at most
};

/// How trees are joined, and what ends a pass.
struct TreeEffort {
  std::size_t field_cells;       ///< of the grid for the estimate of the way that remains
  std::array<double, 3> ratios;  ///< of tangent lengths of biarcs
  double near;                   ///< cells in which poses of the other tree are looked for, in lengths of the body
  std::size_t nearest;           ///< poses of the other tree that are tried
  std::size_t first_roadmap;     ///< expansions until poses are joined to the roadmap as well; then each time
  std::size_t roadmap_factor;    ///< so many times as many
  std::uint64_t edges;           ///< that motions are compared with, for each pose of the limit: some 60 ns each
  std::size_t after_dry;         ///< times as many turns are taken in all where one tree has run dry
  std::size_t attachments;       ///< of each tree that are joined to it, at most
  std::size_t most_refused;      ///< paths that are found, before the search gives up
  std::size_t refused_poses;     ///< grown after a path that was refused; after the second one twice as many, ...
};

}  // namespace arcway::internal

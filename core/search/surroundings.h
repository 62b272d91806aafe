#pragma once

#include <cstddef>

#include "arcway/stop_clock.h"
#include "core/attach/attachment_links.h"
#include "core/attach/roadmap.h"
#include "core/search/effort.h"

namespace arcway::internal {

/// What forward motions find in the neighborhood of a start or, backwards, of a goal.
enum class Surroundings {
  kOpen,     ///< motions lead out, or there are too many to tell
  kDeadEnd,  ///< a tree ran out of motions before it led out
  kClosed    ///< a small tree ran out of motions, and a finer one found hardly any more
};

/// The answer of `explore_surroundings`.
struct ExploredSurroundings {
  Surroundings surroundings = Surroundings::kOpen;
  std::size_t poses = 0;  ///< grown
};

/// Radius of a neighborhood: a tree that stays within it does not lead out [m].
double dead_end_radius(const Roadmap& map);

/// Grows a tree of forward motions from one end until it leaves the neighborhood, or has no more poses to expand. This
/// is far cheaper than trees from both ends with an estimate of the way between them. The answer is no proof.
/// Deterministic unless stopped.
/// @param clock  may end the search, with the result kOpen.
ExploredSurroundings explore_surroundings(const Roadmap& map, const Pose& root, Direction direction,
                                          const SurroundingsEffort& effort, const StopClock& clock);

}  // namespace arcway::internal

#pragma once

#include <cstddef>

#include "arcway/stop_clock.h"
#include "core/attach/attachment_links.h"
#include "core/attach/roadmap.h"

namespace arcway::internal {

/// What forward motions from a start, or to a goal, find in its neighborhood.
enum class Surroundings {
  kOpen,     ///< motions lead out, or there are too many to tell
  kDeadEnd,  ///< a tree has found no more motions before it was out
  kClosed    ///< a small tree has, and a finer one has found hardly any more
};

struct WayOut {
  Surroundings surroundings = Surroundings::kOpen;
  std::size_t poses = 0;  ///< that were grown
};

/// How far a tree stays from its root at most that does not lead away from it [m].
double dead_end_radius(const Roadmap& map);

/// Grows a tree of forward motions from one end alone until it leaves the neighborhood or finds no more poses. This is
/// far cheaper than growing trees from both ends with an estimate of the way between them. It proves nothing.
/// Deterministic unless stopped.
/// @param clock  ends the search, as if there were a way out.
WayOut look_for_way_out(const Roadmap& map, const Pose& root, Direction direction, const StopClock& clock);

}  // namespace arcway::internal

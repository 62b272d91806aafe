#pragma once

#include <cstddef>

#include "core/attach/search_map.h"
#include "core/attach/terminal_links.h"
#include "core/base/stop_clock.h"

namespace [[gnu::visibility("default")]] arcway {

/// What forward motions from a start, or to a goal, find in its neighborhood.
enum class Surroundings {
  kOpen,    ///< motions lead out, or there are too many to tell
  kPocket,  ///< a tree has found no more motions before it was out
  kClosed   ///< a small tree has, and a finer one has found hardly any more
};

struct WayOut {
  Surroundings surroundings = Surroundings::kOpen;
  std::size_t poses = 0;  ///< that were grown
};

/// How far a tree stays from its root at most that does not lead away from it [m].
double pocket_radius(const SearchMap& map);

/// Grows a tree of forward motions from one end alone until it leaves the neighborhood or finds no more poses. This is
/// far cheaper than growing trees from both ends with an estimate of the way between them. It proves nothing.
/// Deterministic unless stopped.
/// @param clock  ends the search, as if there were a way out.
WayOut look_for_way_out(const SearchMap& map, const Pose& root, Direction direction, const StopClock& clock);

}  // namespace arcway

#pragma once

#include <cstddef>
#include <optional>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"

namespace arcway::internal {

/// Proof that no motion takes a body from one pose to another, in whatever direction, even if it could turn on the
/// spot. No vehicle with that body has a path, forwards or backwards.
struct Enclosure {
  bool at_start;  ///< the start is enclosed; false: the goal is
  double reach;   ///< the middle of the body gets no further from there [m]
};

/// A body that is moved in whatever direction, and what it must not touch.
struct MovedBody {
  Footprint footprint;
  const SweepQuery& sweep;
};

/// Searches for a proof that an end is enclosed, by flooding boxes of positions and headings:
/// 1. From the end's box, neighboring boxes are reached unless the body collides everywhere in them, towards the other
///    end first.
/// 2. If no box is left before the other end is reached, that is a proof.
/// 3. Else boxes are halved, a few times.
///
/// @param max_boxes  largest number of boxes of one size from one end; some tenths of a microsecond each.
/// @param clock  may end the search.
/// @return nothing if no proof is found; a path may exist or not.
std::optional<Enclosure> find_enclosure(const Pose& start, const Pose& goal, const MovedBody& body,
                                        std::size_t max_boxes, const StopClock& clock = {});

}  // namespace arcway::internal

#pragma once

#include <cstddef>
#include <optional>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"

namespace arcway::internal {

/// Proof that a body cannot be moved from one pose to another, in whatever direction, even if it could turn on the
/// spot: no vehicle with that body has a path, forwards or backwards.
struct Enclosure {
  bool at_start;  ///< it is the start that is enclosed, else the goal
  double reach;   ///< however the body is moved, its middle gets no further from there [m]
};

/// Looks for such a proof: positions and headings are divided into boxes, and those that are reached from an end by
/// boxes in which the body does not collide everywhere are followed, towards the other end first. If there are no more
/// of them before the other end is reached, that is a proof; then boxes are halved, a few times.
/// @param footprint  of the body that must not touch anything.
/// @param max_boxes  of one size from one end; some tenths of a microsecond each.
/// @param clock  ends the search.
/// @returns nothing if no proof is found: there may be a path or none.
std::optional<Enclosure> find_enclosure(const Pose& start, const Pose& goal, const Footprint& footprint,
                                        const SweepQuery& sweep, std::size_t max_boxes, const StopClock& clock = {});

}  // namespace arcway::internal

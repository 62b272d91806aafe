#pragma once

#include <cstddef>
#include <optional>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "core/model/outlines.h"

namespace arcway::internal {

/// Proof that a vehicle which does not reverse has no path between two poses. Either it collides near the start
/// whatever it does, or no motion from afar arrives at the goal.
struct DeadEnd {
  bool at_start;  ///< the start cannot be left with its heading; false: the goal cannot be reached with its heading
  double reach;   ///< the reference point gets no further from the start, or comes from no further away [m]
};

/// A body that is driven forwards, and the obstacles around it.
struct ForwardBody {
  Footprint footprint;  ///< must not touch anything
  double radius;        ///< of the sharpest turn, > 0 [m]
  const SweepQuery& sweep;
  const Outlines& outlines;  ///< of the query's world
};

/// How much work a search for a dead end may do.
struct DeadEndEffort {
  int halvings;            ///< number of halvings of the boxes; each makes them some eight times as many
  std::size_t max_checks;  ///< largest number of checks of the largest boxes, from one end; doubled by each halving
};

/// Searches for a proof that an end is a dead end, by reachability over boxes of positions and headings:
/// 1. From a box that is reached, the vehicle takes a step forwards of a certain length, with any curvature up to 1 /
///    radius.
/// 2. The boxes that may hold the reference point then are reached, unless the body collides everywhere in them.
/// 3. If no box is left before they are some body widths away or near the other end, that is a proof.
/// 4. Else boxes are halved, unless they were too many before, or all free.
///
/// The goal is examined in the same way backwards. Only the neighborhood of the ends is decided. Enclosures of any
/// size, which also hold for vehicles that reverse, are found by find_enclosure. No proof is found for vehicles whose
/// smallest radius is at least some 24 times the body's width.
/// @param effort  a check takes some tenths of a microsecond.
/// @param clock  may end the search.
/// @return nothing if no proof is found; a path may exist or not.
std::optional<DeadEnd> find_dead_end(const Pose& start, const Pose& goal, const ForwardBody& body,
                                     const DeadEndEffort& effort, const StopClock& clock = {});

}  // namespace arcway::internal

#pragma once

#include <cstddef>
#include <optional>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "core/model/outlines.h"

namespace arcway::internal {

/// Proof that a vehicle which does not reverse has no path between two poses: whatever it does, it collides near the
/// start, or comes from near the goal.
struct DeadEnd {
  bool at_start;  ///< it is the start that cannot be left with its heading, else the goal that cannot be reached so
  double reach;   ///< the reference point gets no further from there, or comes from no further away [m]
};

/// How long to look for such a proof.
struct DeadEndEffort {
  int halvings;            ///< of the boxes; each takes some eight times as many
  std::size_t max_checks;  ///< of the largest boxes from one end, and after each halving twice as many
};

/// Looks for such a proof: positions and headings are divided into boxes. A box is followed if the reference point may
/// be in it after a step forwards of a certain length from a box reached before, with any curvatures of at most 1 /
/// radius. Boxes in which the body collides everywhere are left out. Backwards from the goal likewise. If there are no
/// more of them before they are some body widths away or near the other end, that is a proof; else boxes are halved,
/// unless they were too many before or all free. What is near is decided, not what is far: enclosures of any size that
/// also hold for reversing are found by find_enclosure. No proof is found for vehicles that turn within no less than
/// some 24 times the body's width.
/// @param footprint  of the body that must not touch anything.
/// @param radius  smallest turning radius, > 0.
/// @param outlines  of the query's world.
/// @param effort  some tenths of a microsecond a check.
/// @param clock  ends the search.
/// @returns nothing if no proof is found: there may be a path or none.
std::optional<DeadEnd> find_dead_end(const Pose& start, const Pose& goal, const Footprint& footprint, double radius,
                                     const SweepQuery& sweep, const Outlines& outlines, const DeadEndEffort& effort,
                                     const StopClock& clock = {});

}  // namespace arcway::internal

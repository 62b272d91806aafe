#pragma once

#include <optional>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "core/model/outlines.h"

namespace arcway::internal {

/// What a path is to be free of, and for which body. All must outlive it.
struct PushSpace {
  const Vehicle& vehicle;
  const Body& body;
  const Outlines& outlines;
  const SweepQuery& sweep;
};

/// Pushes a path off the obstacles that its body slightly overlaps. The start stays, and the end moves to the goal. The
/// lengths and curvatures of all motions minimize the squares of the depths of all contacts and of the way to the goal,
/// by the Levenberg-Marquardt method. Lines become arcs only where the path does not get free otherwise. Gears stay.
/// Contacts are found at steps along the path; the sweep query decides whether the result is free.
/// @param path  ends near `goal`, not empty. Of its motions but the first, only length, curvature and gear count.
/// @param clock  may end it, without a path.
/// @return nothing if contacts remain. Some tens of iterations, each O(steps x edges near by + contacts x parts^2).
std::optional<Path> push_free(const Path& path, const Pose& goal, const PushSpace& space, const StopClock& clock);

}  // namespace arcway::internal

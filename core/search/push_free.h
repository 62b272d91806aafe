#pragma once

#include <optional>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/vehicle.h"
#include "core/attach/roadmap.h"

namespace arcway::internal {

/// Pushes a path of forward motions off the obstacles that its body slightly overlaps. Start and goal stay. The lengths
/// and curvatures of all arcs minimize the squares of the depths of all contacts, by the Levenberg-Marquardt method.
/// Contacts are found at steps along the path; the sweep query decides whether the result is free.
/// @param path  from its start to `goal`, not empty.
/// @param body  for which the path is to be free.
/// @param clock  may end it, without a path.
/// @return nothing if contacts remain. Some tens of iterations, each O(steps x edges near by + contacts x parts^2).
std::optional<Path> push_free(const Path& path, const Pose& goal, const Body& body, const Roadmap& map,
                              const StopClock& clock);

}  // namespace arcway::internal

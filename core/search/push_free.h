#pragma once

#include <optional>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/vehicle.h"
#include "core/attach/roadmap.h"

namespace arcway::internal {

/// Bends a path of forward motions, in which a body lies a little over edges of the world, until it lies over none:
/// the lengths and curvatures of all its arcs are those that least squares of the depths of all contacts ask for, found
/// by the Levenberg-Marquardt method. Start and goal stay. Contacts are looked for at steps along the path: the path
/// returned is decided by the sweep query.
/// @param path   from its start to `goal`, not empty.
/// @param body   that the path is to be free for.
/// @param clock  ends it, without a path.
/// @returns nothing if contacts remain. Some tens of iterations, each O(steps x edges near by + contacts x parts^2).
std::optional<Path> push_free(const Path& path, const Pose& goal, const Footprint& body, const Roadmap& map,
                              const StopClock& clock);

}  // namespace arcway::internal

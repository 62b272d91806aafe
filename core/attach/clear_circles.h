#pragma once

#include "arcway/stop_clock.h"
#include "core/attach/roadmap.h"

namespace arcway::internal {

/// A roadmap with further circles around vertices, on which the body keeps a preferred distance from its vertex: around
/// all of them, and those of clearance zones where a circle comes near the zone. They are wider where the body would
/// cover the vertex. The graph is lazy, and has all links of the given one.
/// Precondition: the roadmap has a clearance cost.
/// @throws Canceled if the clock is over before it is made.
[[nodiscard]] Roadmap with_clear_circles(const Roadmap& map, const StopClock& clock = {});

}  // namespace arcway::internal

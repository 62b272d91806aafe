#pragma once

#include <memory>

#include "arcway/stop_clock.h"
#include "arcway/vehicle.h"
#include "core/roadmap/added_circles.h"
#include "core/roadmap/feasible_graph.h"
#include "core/roadmap/lazy_feasible_graph.h"

namespace arcway::internal {

/// A lazy graph with added circles. It keeps all links of the base graph. Added circles round a vertex join it as if
/// they were base circles. Further links lead onto gap straights, through them and off them.
/// @param base  of the same vehicle, without added circles.
/// @throws Canceled if the clock is over before.
[[nodiscard]] std::shared_ptr<const LazyFeasibleGraph> extend_feasible_graph(std::shared_ptr<const FeasibleGraph> base,
                                                                             const Vehicle& vehicle,
                                                                             const AddedCircles& added,
                                                                             const StopClock& clock = {});

}  // namespace arcway::internal

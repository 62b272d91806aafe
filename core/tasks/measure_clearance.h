#pragma once

#include "arcway/plan_result.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"

namespace arcway::internal {

/// Measures the clearance of a plan's segments in a world, and where it is least. O(segments x edges near by).
void measure_clearance(const World& world, const Vehicle& vehicle, PlanResult& plan);

}  // namespace arcway::internal

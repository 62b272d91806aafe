#pragma once

#include "arcway/path.h"
#include "arcway/plan_result.h"
#include "core/base/infinity.h"

namespace arcway::internal {

/// The travel time of a plan, plus `cusp_cost` for each gear change [s]; infinity unless it is solved.
inline double cost_of(const PlanResult& plan, double cusp_cost) {
  return plan.solved() ? plan.travel_time + cusp_cost * static_cast<double>(cusps_of(plan.path())) : kInfinity;
}

}  // namespace arcway::internal

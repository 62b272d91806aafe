#pragma once

#include <optional>
#include <span>

#include "arcway/clearance_preference.h"
#include "arcway/path.h"
#include "arcway/plan_result.h"
#include "arcway/planner.h"
#include "core/base/infinity.h"

namespace arcway::internal {

/// The cost of a plan, with `cusp_cost` for each gear change [s]; infinity unless it is solved.
inline double cost_of(const PlanResult& plan, double cusp_cost) {
  return plan.solved() ? plan.cost() + cusp_cost * static_cast<double>(cusps_of(plan.path())) : kInfinity;
}

/// What driving close to obstacles costs on a path, by the planner's preference and in zones [s].
inline double clearance_cost(const Planner& planner, std::span<const PathSegment> path) {
  const std::optional<CloseDriving> close = planner.close_driving(path);
  double cost = close ? close->cost : 0.0;
  for (const ZoneCloseDriving& in_zone : planner.close_in_zones(path)) cost += in_zone.close.cost;
  return cost;
}

}  // namespace arcway::internal

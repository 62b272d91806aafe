#pragma once

#include <span>

#include "arcway/export.h"
#include "arcway/moving_obstacle.h"
#include "arcway/plan_result.h"

namespace arcway {

/// A plan that drives its path with the motion of evade(). It is the plan given where that is free of conflict, is not
/// solved, or has no segments. Where no motion is found, the status is PlanStatus::kConflict, and the reason names the
/// first conflict.
///
///     const PlanResult plan = evading_plan(planner.plan(request), obstacles);
///
/// @throws std::invalid_argument as evade(), or if the plan is solved and not made by a planner.
ARCWAY_API PlanResult evading_plan(const PlanResult& plan, std::span<const MovingObstacle> obstacles,
                                   const EvasionOptions& options = {});

}  // namespace arcway

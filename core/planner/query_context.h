#pragma once

#include "arcway/planner.h"
#include "arcway/stop_clock.h"
#include "core/motion/end_speeds.h"
#include "core/planner/planner_maps.h"

namespace arcway::internal {

/// What all steps of one query are given. References: all must outlive the query.
struct QueryContext {
  const PlannerMaps& maps;
  const PlannerOptions& options;  ///< of the planner
  const PlanRequest& request;     ///< with headings within one turn of those asked for
  const PlanLimits& limits;
  const StopClock& clock;  ///< of the limits

  /// The speeds at both ends.
  [[nodiscard]] EndSpeeds ends() const { return {request.start_speed, request.goal_speed}; }
  /// The roadmap of all radii.
  [[nodiscard]] const Roadmap& map() const { return maps.all.plain; }
};

}  // namespace arcway::internal

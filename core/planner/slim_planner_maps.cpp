#include "core/planner/slim_planner_maps.h"

#include <utility>

#include "arcway/executor.h"
#include "core/planner/planner_maps.h"
#include "core/planner/slim_maps.h"
#include "core/planner/strategy.h"

namespace arcway::internal {

SlimPlannerMaps::SlimPlannerMaps(const Roadmap& map, std::shared_ptr<const SweepQuery> obstacles,
                                 PlannerOptions options, std::shared_ptr<const VisibilityRows> rows)
    : map_(map), obstacles_(std::move(obstacles)), options_(std::move(options)), rows_(std::move(rows)) {
  options_.point_robot_lower_bound = false;  // that of the real body holds
  options_.process_group = nullptr;
}

const PlannerMaps* SlimPlannerMaps::operator()(const StopClock& clock) const {
  const auto* maps = maps_.get(clock, [&] {
    const Vehicle vehicle = slimmer(map_.vehicle, kSlimPlan);
    Roadmap slim = roadmap_for(vehicle, {vehicle, options_.radii}, map_, rows_, clock);
    const SerialExecutor serial;
    const StoppableExecutor executor(serial, clock);
    return std::make_shared<const PlannerMaps>(std::move(slim), obstacles_, options_, rows_, executor);
  });
  return maps != nullptr ? maps->get() : nullptr;
}

}  // namespace arcway::internal

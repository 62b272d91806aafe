#include "core/planner/slim_planner_maps.h"

#include <utility>

#include "arcway/executor.h"
#include "core/planner/planner_maps.h"
#include "core/planner/slim_maps.h"
#include "core/planner/strategy.h"
#include "core/roadmap/lazy_feasible_graph.h"

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
    const CircleRadii radii{vehicle, options_.radii};
    const SerialExecutor serial;
    const StoppableExecutor executor(serial, clock);  // circles take milliseconds
    auto lazy = std::make_shared<const LazyFeasibleGraph>(
        FeasibleGraphInputs{map_.world, vehicle, rows_, map_.queries, radii}, executor);
    Roadmap slim(map_.world, vehicle, map_.queries, radii, std::move(lazy), map_.outlines, nullptr, clock);
    return std::make_shared<const PlannerMaps>(std::move(slim), obstacles_, options_, rows_, executor);
  });
  return maps != nullptr ? maps->get() : nullptr;
}

}  // namespace arcway::internal

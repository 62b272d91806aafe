#include "bench/live/live_planner.h"

#include <utility>
#include <vector>

#include "core/planner/planner_inputs.h"

namespace arcway::internal::bench {

World changed(const World& world, const MapChange& change) {
  return world.changed(obstacles_with(world, change.removed), change.added);
}

void ChangedPlanner::change(const MapChange& change) { planner_.change_obstacles(change.removed, change.added); }

Replan ChangedPlanner::next(const Trajectory& driven, double time, const ReplanOptions& options) const {
  return replan(planner_, driven, time, options);
}

RebuiltPlanner::RebuiltPlanner(Planner planner, MakeBackend make_backend, PlannerOptions options)
    : make_backend_(std::move(make_backend)), options_(std::move(options)), planner_(std::move(planner)) {}

void RebuiltPlanner::change(const MapChange& change) {
  const World after = changed(world(), change);
  planner_ = Planner(after, planner_.vehicle(), make_backend_(after), options_);
}

Replan RebuiltPlanner::next(const Trajectory& driven, double time, const ReplanOptions& options) const {
  return replan(planner_, driven, time, options);
}

}  // namespace arcway::internal::bench

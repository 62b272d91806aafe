#include "bench/peers/ompl_live.h"

#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "arcway/world_change.h"
#include "bench/peers/exact_motion.h"
#include "bench/peers/ompl_peer.h"
#include "core/collision/motion_free.h"
#include "core/motion/speed_profile.h"
#include "core/planner/planner_inputs.h"
#include "core/tasks/replan_by.h"

namespace arcway::internal::peers {

OmplLivePlanner::OmplLivePlanner(const World& world, const Vehicle& vehicle, Backend backend)
    : world_(world), vehicle_(vehicle), backend_(std::move(backend)) {
  seed_ompl(1);
  (void)backend_.queries();
}

void OmplLivePlanner::change(const bench::MapChange& change) {
  const std::vector<ObstacleId> removed = obstacles_with(world_, change.removed);
  const World after = world_.changed(removed, change.added);
  backend_ = backend_.changed(after, WorldChange(world_, after, removed));
  (void)backend_.queries();
  world_ = after;
}

Replan OmplLivePlanner::next(const Trajectory& driven, double time, const ReplanOptions& options) const {
  const auto is_free = [this](std::span<const PathSegment> path) {
    return motion_free(*backend_.queries().sweep, checked_body(vehicle_), path);
  };
  return replan_by({vehicle_, is_free,
                    [this](const PlanRequest& request, const PlanLimits& limits) { return plan(request, limits); }},
                   driven, time, options);
}

PlanResult OmplLivePlanner::plan(const PlanRequest& request, const PlanLimits& limits) const {
  const Problem problem{world_, vehicle_, *backend_.queries().sweep, request};
  const std::array times{limits.time};
  const PeerRun run = run_ompl(OmplPlanner::kRrtConnectWide, problem, limits.time, times, random_);
  PlanResult result;
  if (!run.at_time.back()) {
    result.reason = "OMPL found no path in time";
    return result;
  }
  const Path& path = run.at_time.back()->path;
  SpeedProfile profile;
  result.travel_time =
      internal::travel_time(path, vehicle_, EndSpeeds{request.start_speed, request.goal_speed}, profile);
  if (!std::isfinite(result.travel_time)) {
    result.reason = "OMPL's path cannot be driven from this speed on";
    return result;
  }
  result.status = PlanStatus::kSolved;
  for (std::size_t i = 0; i < path.size(); ++i)
    result.segments.push_back({path[i], profile.speeds[i], profile.speeds[i + 1], profile.durations[i]});
  return result;
}

}  // namespace arcway::internal::peers

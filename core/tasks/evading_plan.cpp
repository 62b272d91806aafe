#include "arcway/evading_plan.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/moving/evade.h"
#include "core/tasks/measure_clearance.h"
#include "core/zones/speed_zones.h"

namespace arcway {
namespace {

PlanResult in_conflict(PlanResult plan, const Trajectory& given, std::span<const MovingObstacle> obstacles,
                       const std::string& reason) {
  const std::vector<Conflict> met = conflicts(given, obstacles);
  plan.status = PlanStatus::kConflict;
  plan.certainty = Certainty::kGaveUp;
  plan.reason = reason;
  if (!met.empty()) plan.reason += "; the fastest motion meets " + to_string(met.front());
  plan.segments.clear();
  plan.first_path = {};
  plan.travel_time = plan.length = plan.min_clearance = 0.0;
  plan.close_driving.reset();
  plan.close_in_zones.clear();
  return plan;
}

}  // namespace

PlanResult evading_plan(const PlanResult& plan, std::span<const MovingObstacle> obstacles,
                        const EvasionOptions& options) {
  if (!plan.solved() || plan.segments.empty()) return plan;
  const Trajectory given = plan.trajectory();
  const std::shared_ptr<const internal::SpeedZones> zones = internal::SpeedZones::of(plan.scene->world);
  Evasion evasion = internal::evade(given, obstacles, options, zones.get());
  if (!evasion.found) return in_conflict(plan, given, obstacles, evasion.reason);
  if (evasion.travel_time == given.duration()) return plan;
  PlanResult evading = plan;
  evading.segments = std::move(evasion.segments);
  evading.travel_time = evasion.travel_time;
  evading.clearance_is_lower_bound = false;
  internal::measure_clearance(plan.scene->world, plan.scene->vehicle, evading);
  return evading;
}

}  // namespace arcway

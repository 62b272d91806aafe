#include "arcway/plan_result.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/base/shortest_text.h"

namespace arcway {

using internal::rounded_text;

namespace {

// The world and vehicle of a plan that has a path.
const PlanScene& scene_of(const PlanResult& result) {
  if (!result.solved())
    throw std::invalid_argument("Trajectory: the plan has no path: " + std::string(name_of(result.status)) +
                                (result.reason.empty() ? "" : ", " + result.reason));
  if (!result.scene)
    throw std::invalid_argument(
        "Trajectory: no planner made this result, so that its vehicle is not known; give the segments and a vehicle");
  return *result.scene;
}

// A plan from a pose to itself stays there, at the speed it has.
std::vector<TimedSegment> segments_of(const PlanResult& result) {
  if (!result.segments.empty()) return result.segments;
  const Gear gear = result.start_speed < 0.0 ? Gear::kReverse : Gear::kForward;
  const double speed = std::abs(result.start_speed);
  return {{.segment = {result.start, 0.0, 0.0, gear}, .speed_in = speed, .speed_out = speed}};
}

}  // namespace

const char* name_of(PlanStatus status) {
  switch (status) {
    case PlanStatus::kSolved:
      return "solved";
    case PlanStatus::kStartInCollision:
      return "start in collision";
    case PlanStatus::kGoalInCollision:
      return "goal in collision";
    case PlanStatus::kStartOutsideBounds:
      return "start outside bounds";
    case PlanStatus::kGoalOutsideBounds:
      return "goal outside bounds";
    case PlanStatus::kStartBlocked:
      return "start blocked";
    case PlanStatus::kGoalBlocked:
      return "goal blocked";
    case PlanStatus::kWaypointInCollision:
      return "waypoint in collision";
    case PlanStatus::kWaypointOutsideBounds:
      return "waypoint outside bounds";
    case PlanStatus::kWaypointBlocked:
      return "waypoint blocked";
    case PlanStatus::kNoPassage:
      return "no passage";
    case PlanStatus::kNoPath:
      return "no path";
    case PlanStatus::kConflict:
      return "conflict";
    case PlanStatus::kTimeLimit:
      return "time limit";
    case PlanStatus::kCanceled:
      return "canceled";
  }
  return "unknown";
}

const char* name_of(Certainty certainty) { return certainty == Certainty::kProved ? "proved" : "gave up"; }

PlanStatistics& PlanStatistics::operator+=(const PlanStatistics& other) {
  nodes_expanded += other.nodes_expanded;
  nodes_pushed += other.nodes_pushed;
  straights_checked += other.straights_checked;
  turns_checked += other.turns_checked;
  maneuver_poses += other.maneuver_poses;
  tree_poses += other.tree_poses;
  refine_trials += other.refine_trials;
  refine_improvements += other.refine_improvements;
  suboptimality = std::max(suboptimality, other.suboptimality);
  search_seconds += other.search_seconds;
  refine_seconds += other.refine_seconds;
  lower_bound_seconds += other.lower_bound_seconds;
  profile_seconds += other.profile_seconds;
  return *this;
}

double PlanResult::cost() const {
  double cost = travel_time + (close_driving ? close_driving->cost : 0.0);
  for (const ZoneCloseDriving& in_zone : close_in_zones) cost += in_zone.close.cost;
  return cost;
}

Path PlanResult::path() const { return path_of(segments); }

TimedPath PlanResult::timed_path() const { return timed_path_of(segments); }

Trajectory::Trajectory(const PlanResult& result)
    : Trajectory(segments_of(result), scene_of(result).vehicle, scene_of(result).world) {}

std::string to_string(const PlanResult& result) {
  const std::string status = name_of(result.status);
  if (!result.solved())
    return status + " (" + name_of(result.certainty) + ")" + (result.reason.empty() ? "" : ": " + result.reason);
  const double percent = 0.1 * std::ceil(1e3 * result.optimality_gap());
  return status + ": " + rounded_text(result.travel_time) + " s, " + to_string(result.path()) +
         (result.travel_time > 0.0 && result.lower_bound > 0.0
              ? ", at most " + rounded_text(percent) + " % slower than the fastest path"
              : "") +
         (result.interrupted ? ", interrupted" : "");
}

}  // namespace arcway

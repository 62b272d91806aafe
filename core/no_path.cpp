#include "core/no_path.h"

#include <string>

#include "core/passage/bottleneck.h"
#include "core/passage/collision.h"
#include "core/shortest_text.h"

namespace arcway {

namespace {

// The region around the pose, else the one nearest to it.
std::string nearest_region(const SearchMap& map, const Pose& pose) {
  const ObstacleId inside = map.queries.distance->containing(pose.position());
  const VertexId edge = map.queries.distance->closest(pose.position()).edge;
  if (inside == kNone && edge == kNone) return "nothing";
  return region_text(map.world, inside != kNone ? inside : map.world.obstacle_of(edge));
}

}  // namespace

bool pose_is_free(const SearchMap& map, const Pose& pose, bool start, PlanResult& result) {
  if (map.queries.sweep->straight_free(swept_rectangle(pose, 0.0, map.body))) return true;
  const auto outside = static_cast<ObstacleId>(map.world.obstacle_count());
  const bool out = map.world.has_bounds() && map.world.locate(pose.position(), outside) == PointLocation::kInside;
  if (out) {
    result.status = start ? PlanStatus::kStartOutsideBounds : PlanStatus::kGoalOutsideBounds;
  } else {
    result.status = start ? PlanStatus::kStartInCollision : PlanStatus::kGoalInCollision;
  }
  result.reason = std::string(start ? "the start " : "the goal ") + shortest_text(pose) +
                  (out ? " lies outside the bounds" : "") + ": the body, grown by half of the safety margin, " +
                  collision_text(map.world, map.queries, map.body, pose);
  return false;
}

std::string time_limit_reason(const PlanLimits& limits) {
  return "no path was found within the time limit of " + shortest_text(limits.time) + " s";
}

void explain_interruption(const PlanLimits& limits, PlanResult& result) {
  const bool cancelled = limits.stop.stop_requested();
  result.status = cancelled ? PlanStatus::kCancelled : PlanStatus::kTimeLimit;
  result.reason = cancelled ? "the search was cancelled before it found a path" : time_limit_reason(limits);
  result.bottleneck.reset();
}

void explain(const SearchMap& map, const NoPath& why, const PlanLimits& limits, PlanResult& result) {
  const std::string hemmed_in = std::string(" is hemmed in: no ") + (why.reverse ? "" : "forward ") +
                                "motion of arcs and lines that was tried leads ";
  if (result.interrupted) return explain_interruption(limits, result);
  if (const auto& dead_end = why.dead_end) {
    const Pose& end = dead_end->at_start ? result.start : result.goal;
    result.status = dead_end->at_start ? PlanStatus::kStartBlocked : PlanStatus::kGoalBlocked;
    result.reason = (dead_end->at_start ? "the start " : "the goal ") + shortest_text(end) +
                    " is a dead end: every forward motion " +
                    (dead_end->at_start ? "from it collides less than " : "to it begins less than ") +
                    rounded_text(dead_end->reach) + " m away; nearest is " + nearest_region(map, end);
    result.bottleneck.reset();
    return;
  }
  if (why.obstruction == Obstruction::kPassage) {
    result.status = PlanStatus::kNoPassage;
    result.reason = "no passage is wide enough: " + result.bottleneck->text(map.world) + "; the body takes more than " +
                    rounded_text(result.bottleneck->needed) + " m";
    return;
  }
  if (const auto& enclosure = why.enclosure) {
    const Pose& end = enclosure->at_start ? result.start : result.goal;
    result.status = PlanStatus::kNoPassage;
    result.reason = "no passage is wide enough: however the body is moved and turned, its middle gets less than " +
                    rounded_text(enclosure->reach) + " m away from " +
                    (enclosure->at_start ? "the start " : "the goal ") + shortest_text(end) + "; nearest is " +
                    nearest_region(map, end);
  } else if (why.obstruction == Obstruction::kStart) {
    result.status = PlanStatus::kStartBlocked;
    result.reason = "the start " + shortest_text(result.start) + hemmed_in + "from it to the graph; nearest is " +
                    nearest_region(map, result.start);
  } else if (why.obstruction == Obstruction::kGoal) {
    result.status = PlanStatus::kGoalBlocked;
    result.reason = "the goal " + shortest_text(result.goal) + hemmed_in + "from the graph to it; nearest is " +
                    nearest_region(map, result.goal);
  } else {
    result.status = PlanStatus::kNoPath;
    result.reason = "the feasible visibility graph does not join start and goal";
    if (map.graph.mode() == GraphMode::kEager) {  // those of a lazy one depend on what was asked before
      const FeasibleGraphCounts c = map.graph.counts();
      result.reason += " (" + std::to_string(c.rejected_straight) + " straights too narrow by (6), " +
                       std::to_string(c.rejected_departure + c.rejected_arrival) + " turns by (7) of " +
                       std::to_string(c.candidates) + " bitangents)";
    }
  }
  if (result.statistics.manoeuvre_poses > 0)
    result.reason += "; tried " + std::to_string(result.statistics.manoeuvre_poses) + " poses of manoeuvres";
  if (result.bottleneck)
    result.reason += "; " + result.bottleneck->text(map.world) + ", the body takes " +
                     rounded_text(result.bottleneck->needed) + " m, in its tightest turn " +
                     rounded_text(result.bottleneck->needed_to_turn) + " m";
}

}  // namespace arcway

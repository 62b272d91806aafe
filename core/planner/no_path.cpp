#include "core/planner/no_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "arcway/zone.h"
#include "core/gaps/bottleneck_finder.h"
#include "core/geometry/distance.h"
#include "core/model/pose_text.h"
#include "core/planner/collision.h"

namespace arcway::internal {

namespace {

constexpr std::size_t kZonesNamed = 4;  // largest number of zones that a reason names

// The region around the pose, else the one nearest to it.
std::string nearest_region(const Roadmap& map, const Pose& pose) {
  const ObstacleId inside = map.queries.distance->containing(pose.position());
  const VertexId edge = map.queries.distance->closest(pose.position()).edge;
  if (inside == kNone && edge == kNone) return "nothing";
  return region_text(map.world, inside != kNone ? inside : map.world.obstacle_of(edge));
}

std::string start_text(const PlanResult& result) { return "the start " + shortest_text(result.start); }
std::string goal_text(const PlanResult& result) { return "the goal " + shortest_text(result.goal); }

void explain_dead_end(const Roadmap& map, const DeadEnd& dead_end, PlanResult& result) {
  result.status = dead_end.at_start ? PlanStatus::kStartBlocked : PlanStatus::kGoalBlocked;
  result.reason =
      (dead_end.at_start ? start_text(result) : goal_text(result)) + " is a dead end: every forward motion " +
      (dead_end.at_start ? "from it collides less than " : "to it begins less than ") + rounded_text(dead_end.reach) +
      " m away; nearest is " + nearest_region(map, dead_end.at_start ? result.start : result.goal);
  result.bottleneck.reset();
}

// The zones that motions obeyed, those nearest to start or goal first; empty without any.
std::string obeyed_text(const Roadmap& map, const PlanResult& result) {
  if (map.one_way_zones == nullptr) return "";
  std::vector<std::pair<double, std::uint32_t>> zones;
  for (const std::uint32_t zone : map.one_way_zones->zones()) {
    const Polygon& area = map.world.zones()[zone].area;
    zones.emplace_back(std::min(distance(result.start.position(), area), distance(result.goal.position(), area)), zone);
  }
  std::ranges::sort(zones);
  std::string text;
  for (std::size_t i = 0; i < std::min(zones.size(), kZonesNamed); ++i)
    text += (i > 0 ? ", " : "") + zone_text(map.world.zones()[zones[i].second], zones[i].second);
  if (zones.size() > kZonesNamed) text += " and " + std::to_string(zones.size() - kZonesNamed) + " more";
  return "; motions obeyed the driving directions of " + text;
}

void explain_enclosure(const Roadmap& map, const Enclosure& enclosure, PlanResult& result) {
  result.status = PlanStatus::kNoPassage;
  result.reason = "no gap is wide enough: however the body is moved and turned, its middle gets less than " +
                  rounded_text(enclosure.reach) + " m away from " +
                  (enclosure.at_start ? start_text(result) : goal_text(result)) + "; nearest is " +
                  nearest_region(map, enclosure.at_start ? result.start : result.goal);
}

// Explains a failure that proves nothing. Trees know best which end is in a dead end, as they examined both on the
// finest grid.
void explain_failure(const Roadmap& map, const NoPath& why, PlanResult& result) {
  const bool start = why.trees ? why.trees->start_in_dead_end : why.obstruction == Obstruction::kStart;
  const bool goal = why.trees ? why.trees->goal_in_dead_end : why.obstruction == Obstruction::kGoal;
  const std::string motion = std::string("no ") + (why.reverse ? "" : "forward ") + "motion that was tried leads ";
  const std::string at_start = "; nearest is " + nearest_region(map, result.start);
  const std::string at_goal = "; nearest is " + nearest_region(map, result.goal);
  if (start && goal) {
    result.status = PlanStatus::kStartBlocked;
    result.reason = start_text(result) + " and " + goal_text(result) + " are in dead ends: " + motion +
                    "out from the one" + at_start + ", or in to the other" + at_goal;
  } else if (start) {
    result.status = PlanStatus::kStartBlocked;
    result.reason = start_text(result) + " is in a dead end: " + motion + "out from it" + at_start;
  } else if (goal) {
    result.status = PlanStatus::kGoalBlocked;
    result.reason = goal_text(result) + " is in a dead end: " + motion + "in to it" + at_goal;
  } else {
    result.status = PlanStatus::kNoPath;
    result.reason = "neither the feasible visibility graph nor any motion that was tried joins start and goal";
  }
  // A body gets out of any room that its diagonal fits, by enough changes of gear.
  if (why.reverse) result.status = PlanStatus::kNoPath;
}

// What was tried, and whether a limit ended it.
std::string tried_text(const NoPath& why, const PlanResult& result) {
  std::string text;
  if (result.statistics.maneuver_poses > 0)
    text += "; tried " + std::to_string(result.statistics.maneuver_poses) + " poses of maneuvers" +
            (why.reverse && result.certainty == Certainty::kGaveUp ? ", the limit, so that there may be a path" : "");
  if (why.max_gear_changes)
    text += "; at most " + std::to_string(*why.max_gear_changes) + " changes of gear were allowed";
  if (why.trees) {
    text += "; trees of forward motions grew " + std::to_string(why.trees->poses) + " poses, " +
            (why.trees->ran_dry ? "and found no more from one end" : "the limit, so that there may be a path");
  }
  return text;
}

// What an end's speed asks for: the length to brake on or, at a goal, to gain the speed on.
std::string speed_text(const Roadmap& map, const PlanResult& result, bool start) {
  const double speed = start ? result.start_speed : result.goal_speed;
  if (speed == 0.0) return "";
  const Vehicle& vehicle = map.vehicle;
  const bool ahead = speed > 0.0;
  const double turns = ahead ? vehicle.turn_speed(vehicle.min_turning_radius())
                             : vehicle.reverse_turn_speed(vehicle.min_turning_radius());
  const auto length_to = [&](double other) {
    return std::max(0.0, 0.5 * (speed * speed - other * other) / vehicle.max_acceleration());
  };
  // From the start on, or backwards from the goal.
  const Gear gear = ahead == start ? Gear::kForward : Gear::kReverse;
  const PathSegment line = PathSegment{start ? result.start : result.goal, length_to(turns), 0.0, gear}.forwards();
  const bool is_free = map.queries.sweep->straight_free({line.start, line.length, map.body, gear});
  return std::string(start ? "; braking from the start speed of " : "; gaining the goal speed of ") +
         rounded_text(std::abs(speed)) + " m/s takes " + rounded_text(length_to(0.0)) +
         (start ? " m to a stop, " : " m from rest, ") + rounded_text(length_to(turns)) +
         (start ? " m to" : " m from") + " the speed of the tightest turns, and a line of that length " +
         (start ? "from the start" : "to the goal") + (is_free ? " is free" : " is blocked");
}

}  // namespace

bool pose_is_free(const Roadmap& map, const Pose& pose, bool start, PlanResult& result) {
  if (map.queries.sweep->straight_free({pose, 0.0, map.body})) return true;
  const auto outside = static_cast<ObstacleId>(map.world.obstacle_count());
  const bool out = map.world.has_bounds() && map.world.locate(pose.position(), outside) == PointLocation::kInside;
  if (out) {
    result.status = start ? PlanStatus::kStartOutsideBounds : PlanStatus::kGoalOutsideBounds;
  } else {
    result.status = start ? PlanStatus::kStartInCollision : PlanStatus::kGoalInCollision;
  }
  result.certainty = Certainty::kProved;
  result.reason = std::string(start ? "the start " : "the goal ") + shortest_text(pose) +
                  (out ? " lies outside the bounds" : "") + ": the body, grown by half of the safety margin, " +
                  collision_text(map.world, *map.outlines, map.queries, map.body, pose);
  return false;
}

bool end_speed_obeys_zones(const Roadmap& map, const Pose& pose, bool start, PlanResult& result) {
  if (map.speed_zones == nullptr) return true;
  const double speed = std::abs(start ? result.start_speed : result.goal_speed);
  const double limit = map.speed_zones->cap_at(pose.position());
  if (speed <= limit) return true;
  const std::uint32_t zone = map.speed_zones->zone_at(pose.position());
  result.status = start ? PlanStatus::kStartBlocked : PlanStatus::kGoalBlocked;
  result.certainty = Certainty::kProved;
  result.reason = std::string(start ? "the start" : "the goal") + " speed " + shortest_text(speed) +
                  " m/s is above the limit of " + shortest_text(limit) + " m/s of " +
                  zone_text(map.world.zones()[zone], zone) + " there";
  return false;
}

bool end_heading_obeys_zones(const Roadmap& map, const PlanRequest& request, bool start, PlanResult& result) {
  if (map.one_way_zones == nullptr || request.start == request.goal) return true;
  const Pose& pose = start ? request.start : request.goal;
  const double speed = start ? request.start_speed : request.goal_speed;
  std::uint32_t against = kNone;
  for (const Gear gear : {Gear::kReverse, Gear::kForward}) {
    const bool is_possible = gear == Gear::kForward ? speed >= 0.0 : request.reverse && speed <= 0.0;
    if (!is_possible) continue;
    against = map.one_way_zones->zone_against(pose, gear);
    if (against == kNone) return true;
  }
  const Zone& zone = map.world.zones()[against];
  const auto& rule = std::get<OneWay>(zone.rule);
  result.status = start ? PlanStatus::kStartBlocked : PlanStatus::kGoalBlocked;
  result.certainty = Certainty::kProved;
  result.reason = (start ? start_text(result) : goal_text(result)) + " is inside " + zone_text(zone, against) +
                  ", where directions of motion are within " + rounded_text(rule.tolerance) + " rad of " +
                  rounded_text(rule.heading) + " rad: " + (start ? "no motion from" : "no motion to") + " it, " +
                  (request.reverse ? "in either gear" : "driven forwards") + ", has such a direction";
  return false;
}

std::string time_limit_reason(const PlanLimits& limits) {
  return "no path was found within the time limit of " + shortest_text(limits.time) + " s";
}

void explain_interruption(const PlanLimits& limits, PlanResult& result) {
  const bool canceled = limits.stop.stop_requested();
  result.status = canceled ? PlanStatus::kCanceled : PlanStatus::kTimeLimit;
  result.reason = canceled ? "the search was canceled before it found a path" : time_limit_reason(limits);
  result.bottleneck.reset();
}

void explain(const Roadmap& map, const NoPath& why, const PlanLimits& limits, PlanResult& result) {
  if (result.interrupted) return explain_interruption(limits, result);
  result.certainty = Certainty::kProved;
  if (why.dead_end) return explain_dead_end(map, *why.dead_end, result);
  if (why.obstruction == Obstruction::kBottleneck) {
    result.status = PlanStatus::kNoPassage;
    result.reason = "no gap is wide enough: " + result.bottleneck->text(map.world) + "; the body takes more than " +
                    rounded_text(result.bottleneck->needed) + " m";
    return;
  }
  if (why.enclosure) {
    explain_enclosure(map, *why.enclosure, result);
  } else {
    result.certainty = Certainty::kGaveUp;
    explain_failure(map, why, result);
  }
  result.reason += tried_text(why, result);
  if (result.certainty == Certainty::kGaveUp) result.reason += obeyed_text(map, result);
  for (const bool start : {true, false}) result.reason += speed_text(map, result, start);
  if (result.bottleneck)
    result.reason += "; " + result.bottleneck->text(map.world) + ", the body takes " +
                     rounded_text(result.bottleneck->needed) + " m, in its tightest turn " +
                     rounded_text(result.bottleneck->needed_to_turn) + " m";
}

}  // namespace arcway::internal

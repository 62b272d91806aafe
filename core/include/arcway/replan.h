#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "arcway/export.h"
#include "arcway/planner.h"
#include "arcway/text.h"
#include "arcway/trajectory.h"

namespace arcway {

/// What a vehicle that moves does next.
enum class NextMotion {
  kKept,      ///< the rest of the motion before, which is still free
  kPlanned,   ///< a new plan from where the vehicle is, with its speed
  kRepaired,  ///< parts of the motion before that are free, and a plan between them around what blocks it
  kBraking,   ///< it brakes to a stop, which touches nothing: no motion to the goal was found in time
  kNoMotion   ///< nothing found is free, not even braking; that is no proof that nothing is
};
/// "kept", "planned", "repaired", "braking" or "none".
ARCWAY_API const char* name_of(NextMotion motion);
inline std::string to_string(NextMotion motion) { return name_of(motion); }

/// A motion from a moment of another one on.
struct Replan {
  NextMotion motion = NextMotion::kNoMotion;
  std::vector<TimedSegment> segments;  ///< empty without a motion, and of a vehicle that stands and stays
  double travel_time = 0.0;            ///< [s]
  std::string reason;                  ///< why it is no motion to the goal, if it is none
  PlanResult plan;                     ///< of the query that was asked; its default if there was no time for one
  /// The motion to the goal that is given up for now, from where the vehicle is on: for the next call. Empty where
  /// `segments` lead to the goal.
  std::vector<TimedSegment> given_up;
};

/// Where to go on to, and how long to look for a way.
struct ReplanOptions {
  std::optional<Pose> goal = std::nullopt;  ///< none: where the motion before ends, with its speed there
  bool reverse = false;                     ///< see PlanRequest
  PlanLimits limits = {};
  /// Replan::given_up of the call before, while its motion is driven: a vehicle that brakes goes on along it as soon as
  /// it is free, or repaired. Must outlive the call.
  std::span<const TimedSegment> given_up = {};
};

/// Plans on from a moment of a motion that is being driven, perhaps on a map that changed since.
///
/// 1. The rest of the motion is checked on the planner's map, exactly.
/// 2. If the time is limited and the rest to the goal is blocked, it is repaired: what is free before and behind stays,
///    and a plan between two places there leads around the cut. That takes at most half of the time, and is found where
///    a whole plan is not. What was given up before is driven or repaired in the same way.
/// 3. A plan is made from the vehicle's pose and speed to the goal, with the time that is left. The cheapest of it, the
///    repaired motion, and the rest, if that is free and leads to the goal, is taken.
/// 4. If there is none, the vehicle goes on to where the motion before ends, if that is free and at rest, as one
///    that brakes already. Else it brakes as hard as it may: along the rest, along its curve, or straight on. The first
///    of these that is free is taken; if none is, the first one that is free without the safety margin, as `reason`
///    says.
///
/// Every motion given was decided to be free on the planner's map by exact queries. Time: that of the limits, as of
/// Planner::plan, and some sweep queries. Thread-safe.
/// @param driven  the motion before, for the planner's vehicle.
/// @param time  of the motion, from 0 to its duration [s]: the vehicle is then where that says.
/// @throws std::out_of_range as Trajectory::at does.
/// @throws std::invalid_argument if the motion is of another vehicle, as Planner::plan, or as Trajectory for what was
///   given up.
ARCWAY_API Replan replan(const Planner& planner, const Trajectory& driven, double time,
                         const ReplanOptions& options = {});

}  // namespace arcway

#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "arcway/export.h"
#include "arcway/polygon.h"
#include "arcway/text.h"
#include "arcway/trajectory.h"
#include "arcway/vec2.h"

namespace arcway {

/// An obstacle that moves with a constant velocity and does not turn. Times are those of the plan: 0 is its start.
struct MovingObstacle {
  Ring outline;                                            ///< where it would be at time 0, a simple polygon [m]
  Vec2 velocity = Vec2(0.0, 0.0);                          ///< [m/s]
  double from = 0.0;                                       ///< when it appears [s]
  double until = std::numeric_limits<double>::infinity();  ///< when it is gone [s], > from
};

/// A segment of a motion on which the body meets a moving obstacle.
struct Conflict {
  std::size_t obstacle;  ///< index
  std::size_t segment;   ///< index
  double begin, end;     ///< the first and the last contact on the segment [s]; it may be free in between
  double distance;       ///< driven since the start at the first contact [m]
};
/// "moving obstacle 2 in segment 3 from 1.2 to 1.5 s, after 4.2 m".
ARCWAY_API std::string to_string(const Conflict& conflict);

/// Where and when the bare body of a trajectory's vehicle touches moving obstacles, by segment and then by obstacle.
///
/// The motion is not sampled: an interval of time is free if the distance at its middle exceeds what body and obstacle
/// can travel within its half. An interval that is not free, and in which they travel 1e-9 of the body's reach, is a
/// contact. O(segments x obstacles x corners of both), more near contact.
/// @throws std::invalid_argument naming the obstacle and the value: an outline that is not simple, or a number that is
///   not finite.
ARCWAY_API std::vector<Conflict> conflicts(const Trajectory& trajectory, std::span<const MovingObstacle> obstacles);

/// Times from `begin` to `end` [s].
struct TimeInterval {
  double begin, end;
};

/// The times from 0 to the horizon at which an obstacle touches what the body, grown by half of the safety margin,
/// sweeps on a segment. Exact on lines up to rounding. On arcs it contains the true times: they are covered by polygons
/// that exceed what is swept by a quarter of the margin at most, or by 2e-7 of the radius. Ascending, disjoint.
/// O(corners of both), on arcs for each piece of 0.001 to 0.1 radians.
/// @param horizon  [s], finite, > 0.
/// @throws std::invalid_argument as conflicts(), or naming the horizon.
ARCWAY_API std::vector<TimeInterval> blocked_times(const PathSegment& segment, const Vehicle& vehicle,
                                                   const MovingObstacle& obstacle, double horizon);

/// How a motion evades moving obstacles.
struct EvasionOptions {
  double horizon = 60.0;  ///< time up to which obstacles are looked at, and by which the motion must end [s], > 0
};

/// A motion along the same path, later or more slowly.
struct Evasion {
  bool found = false;
  std::string reason = {};                  ///< unless found
  std::vector<TimedSegment> segments = {};  ///< waits are segments without length that take time
  double travel_time = 0.0;                 ///< waits included [s]
  double waiting = 0.0;                     ///< [s] of it
};

/// Drives a trajectory's path so that the body, grown by half of the safety margin, touches no moving obstacle until
/// the horizon; at the goal it stays. The motion given is kept where it is free of conflict.
///
/// What is tried: stops at the start, where the gear changes, and right before each place that is blocked for a time,
/// with waits of any length. Between stops: the fastest motion, or that of three quarters, half or a quarter of all
/// speeds. Among these motions the one that ends first is found. Blocked places and times are polygons, and the times
/// at which a motion may begin follow from them in closed form. A path around the obstacles, and other speeds, are not
/// tried, so that no motion found is no proof. The speed limits of zones are not known here: evading_plan() obeys them.
/// O(stops^2 x blocked polygons).
/// @throws std::invalid_argument as conflicts(), or naming the horizon.
ARCWAY_API Evasion evade(const Trajectory& trajectory, std::span<const MovingObstacle> obstacles,
                         const EvasionOptions& options = {});

}  // namespace arcway

#pragma once

#include <span>
#include <vector>

#include "arcway/path.h"
#include "arcway/vehicle.h"
#include "core/motion/end_speeds.h"
#include "core/zones/speed_zones.h"

namespace arcway::internal {

/// The parts of the fastest motion along a segment: it accelerates to its highest speed, holds it, and brakes.
struct SegmentPhases {
  double peak;          ///< the highest speed [m/s]
  double accelerating;  ///< length [m]
  double holding;       ///< length [m], 0 where the top speed is not reached
  double braking;       ///< length [m]
};

/// The phases of a segment of length L with entry speed v1, top speed v2 and exit speed v3, at acceleration a. Constant
/// time. Preconditions: L > 0, a > 0, 0 <= v1, v3 <= v2 and v2 > 0. Also |v1^2 - v3^2| <= 2 a L, else no such motion
/// exists: use speed_profile.
SegmentPhases segment_phases(double length, double v1, double v2, double v3, double acceleration);

/// The time of these phases [s], by the closed forms (9) (top speed reached) and (10) (not reached). Preconditions as
/// for segment_phases. Constant time.
double segment_time(double length, double v1, double v2, double v3, double acceleration);

/// A lower bound on the time through a segment [s], for speeds that need not be reachable. It equals (9) or (10) where
/// these hold.
double relaxed_segment_time(double length, double v1, double v2, double v3, double acceleration);

/// An upper bound on the length of motions that take a time [m], with entry speed v1, top speed v2 and exit speed v3,
/// at acceleration a. It is that of the longest one if the speeds can be reached in the time. Preconditions: time >= 0,
/// which may be infinite, a > 0, 0 <= v1, v3 <= v2.
double longest_motion(double time, double v1, double v2, double v3, double acceleration);

/// Speeds at the joints of a path, and the time between them.
struct SpeedProfile {
  std::vector<double> speeds;     ///< n + 1 speeds [m/s] at the joints, ends included
  std::vector<double> durations;  ///< n durations [s]
  double total_time = 0.0;        ///< [s]
};

/// The highest speed on a segment [m/s]: that of lines, or that of arcs of its radius, in its gear.
double speed_limit(const PathSegment& segment, const Vehicle& vehicle);

/// The top speed of the motion along a segment that takes its duration [m/s]: speed_limit, or less if it takes longer
/// than the fastest motion.
double top_speed(const TimedSegment& timed, const Vehicle& vehicle);

/// The fastest speed profile along a path. Speeds are at most speed_limit, |dv/dt| <= max_acceleration, 0 where the
/// gear changes, and given at both ends. One backward and one forward pass over the joints find the speeds; (9) or (10)
/// then gives the times. O(n). An empty path has no durations and total time 0.
/// @param zones  may be null; else their limits hold as well. Speeds and durations are still those of the segments.
/// @throws std::invalid_argument if an end speed is of the other gear than its segment, above its segment's limit, or
///   cannot be reached within the path, with kEndTolerance more acceleration.
SpeedProfile speed_profile(std::span<const PathSegment> path, const Vehicle& vehicle, const EndSpeeds& ends = {},
                           const SpeedZones* zones = nullptr);

/// The fastest profile, into a profile whose memory is used again.
/// @return its total time [s]; infinity, also in the profile, if no motion along the path has these end speeds.
double travel_time(std::span<const PathSegment> path, const Vehicle& vehicle, const EndSpeeds& ends,
                   SpeedProfile& profile, const SpeedZones* zones = nullptr);

/// The travel time of a path that has been cut at the borders of zones [s]; infinity as above. The profile has the
/// speeds and durations of its parts.
double capped_travel_time(const CappedPath& capped, const Vehicle& vehicle, const EndSpeeds& ends,
                          SpeedProfile& profile);

}  // namespace arcway::internal

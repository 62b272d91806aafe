#pragma once

#include <span>
#include <vector>

#include "arcway/path.h"
#include "arcway/vehicle.h"

namespace arcway::internal {

/// The parts of the fastest motion along a segment: it accelerates to its highest speed, holds it, and brakes.
struct SegmentPhases {
  double peak;          ///< the highest speed [m/s]
  double accelerating;  ///< length [m]
  double holding;       ///< length [m], 0 where the top speed is not reached
  double braking;       ///< length [m]
};

/// Of a segment of length L with entry speed v1, top speed v2 and exit speed v3 at acceleration a.
/// Preconditions: L > 0, a > 0, 0 <= v1, v3 <= v2, v2 > 0 and |v1^2 - v3^2| <= 2 a L (else there is no such
/// motion: use speed_profile). Constant time.
SegmentPhases segment_phases(double length, double v1, double v2, double v3, double acceleration);

/// How long they take, by the closed forms (9) (top speed reached) and (10) (not reached). Preconditions as above.
/// Constant time.
double segment_time(double length, double v1, double v2, double v3, double acceleration);

/// Time through a segment of a path whose speeds need not be reachable: a lower bound that equals (9) or (10) where
/// they hold.
double relaxed_segment_time(double length, double v1, double v2, double v3, double acceleration);

/// Speeds at the joints of a path, and the time between them.
struct SpeedProfile {
  std::vector<double> speeds;     ///< n + 1 speeds [m/s] at the joints, ends included
  std::vector<double> durations;  ///< n durations [s]
  double total_time = 0.0;        ///< [s]
};

/// The highest speed on a segment: max_speed on lines, turn_speed(radius) on arcs, or those for reversing.
double speed_limit(const PathSegment& segment, const Vehicle& vehicle);

/// The fastest profile along a path: speed at most speed_limit, |dv/dt| <= max_acceleration, at rest where the gear
/// changes, the given speeds at both ends. One backward and one forward pass over the joints, then (9) or (10) on each
/// segment, which hold by then. O(n). Empty path: no durations, total time 0.
/// @throws std::invalid_argument if an end speed is negative, above its segment's limit, or cannot
///   be reached within the path.
SpeedProfile speed_profile(std::span<const PathSegment> path, const Vehicle& vehicle, double start_speed = 0.0,
                           double end_speed = 0.0);

/// The same from rest to rest into a profile whose memory is used again.
void speed_profile(std::span<const PathSegment> path, const Vehicle& vehicle, SpeedProfile& profile);

/// Travel time of a path from rest to rest, and `cusp_cost` for each change of gear [s].
double travel_cost(std::span<const PathSegment> path, const Vehicle& vehicle, double cusp_cost);

/// The same by way of a profile whose memory is used again.
double travel_cost(std::span<const PathSegment> path, const Vehicle& vehicle, double cusp_cost, SpeedProfile& profile);

}  // namespace arcway::internal

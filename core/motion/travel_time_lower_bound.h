#pragma once

#include "arcway/path.h"
#include "arcway/vehicle.h"
#include "core/motion/end_speeds.h"
#include "core/zones/speed_zones.h"

namespace arcway::internal {

/// A lower bound on the travel time of all paths between two poses with given end speeds v0 and v1 [s], driven forwards
/// or, with `reverse`, in both gears.
///
/// 1. Length. The path is at least L long. L is the largest of `distance`, of the shortest Dubins word of the smallest
///    radius rho_min [Dubins 1957], of rho_min times the turn of 2, and of what the change of speed takes,
///    |v0^2 - v1^2| / (2 a_max).
/// 2. Turn. Headings turn by at least Theta = max(|h1 - h0|, min(pi, |phi - h0| + |h1 - phi|)). Here phi is the
///    direction from start to goal. If no heading of the path is phi, the headings span at least pi: else the mean
///    direction of travel could not be phi. The arcs are at least S = rho_min Theta long.
/// 3. Speed. At arc length s from an end of speed v the speed is at most w(s) = min(v_ms, sqrt(v^2 + 2 a_max s)). On
///    arcs it is at most v_c, the highest value of v_mc.
/// 4. Time. The time is at least the integral of 1 / w over L, plus that of max(0, 1 / v_c - 1 / w) over the arcs. The
///    latter integrand grows with s. Its integral is least if S lies at both ends, up to where w is the same from both:
///    half of S at either end if v0 = v1. Both integrals grow with the path's length.
///
/// With `reverse`, the shortest word is that of Reeds and Shepp, Theta = |h1 - h0|, and speeds are those of the faster
/// gear. Rounding is subtracted, also that of coordinates, and what speed_profile tolerates at moving ends. Constant
/// time, beside the discs.
///
/// **Zones.** The bound is at least the following one where an end lies in a zone that limits the speed. Let c0 and c1
/// be the limits in the discs of radius r0 and r1 about the ends, see SpeedZones::disc_around. A path is in the first
/// disc for its first r0 meters at least, and in the second one for its last r1. Its speed is at most A(s) at arc
/// length s, and B(s') at s' before its end. Here A is the fastest motion from the start at up to c0 for r0 meters,
/// then at up to v_ms; B is that of the goal backwards. Both grow with their argument. So the place where A = B moves
/// away from both ends as the path gets longer, and the integral of 1 / min(A, B) grows. It is least for the shortest
/// path.
/// @param distance  a length that every path has at least [m]: the straight line, or a point's shortest path if the
///   body covers the reference point. Infinity: no path.
/// @param zones  may be null.
double travel_time_lower_bound(const Pose& start, const Pose& goal, double distance, const Vehicle& vehicle,
                               bool reverse = false, const EndSpeeds& ends = {}, const SpeedZones* zones = nullptr);

}  // namespace arcway::internal

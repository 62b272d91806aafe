#pragma once

#include "arcway/path.h"
#include "arcway/vehicle.h"

namespace arcway::internal {

/// A lower bound on the travel time of all paths between two poses from rest to rest [s], driven forwards or, with
/// `reverse`, in both gears.
///
/// 1. Length. The path is at least L long. L is the largest of `distance`, of the shortest Dubins word of the smallest
///    radius rho_min [Dubins 1957], and of rho_min times the turn of 2.
/// 2. Turn. Headings turn by at least Theta = max(|h1 - h0|, min(pi, |phi - h0| + |h1 - phi|)). Here phi is the
///    direction from start to goal. If no heading of the path is phi, the headings span at least pi: else the mean
///    direction of travel could not be phi. The arcs are at least S = rho_min Theta long.
/// 3. Speed. At arc length s from the nearer end the speed is at most w(s) = min(v_ms, sqrt(2 a_max s)). On arcs it is
///    at most v_c, the highest value of v_mc.
/// 4. Time. The time is at least the integral of 1 / w over L, plus that of max(0, 1 / v_c - 1 / w) over the arcs. The
///    latter integrand grows with s, so that its integral is least if half of S lies at either end. Both grow with the
///    path's length.
///
/// With `reverse`, the shortest word is that of Reeds and Shepp, Theta = |h1 - h0|, and speeds are those of the faster
/// gear. Rounding is subtracted, also that of coordinates. Constant time.
/// @param distance  a length that every path has at least [m]: the straight line, or a point's shortest path if the
///   body covers the reference point. Infinity: no path.
double travel_time_lower_bound(const Pose& start, const Pose& goal, double distance, const Vehicle& vehicle,
                               bool reverse = false);

}  // namespace arcway::internal

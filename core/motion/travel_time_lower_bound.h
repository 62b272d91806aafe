#pragma once

#include "arcway/path.h"
#include "arcway/vehicle.h"

namespace arcway::internal {

/// No path of the vehicle, driven forwards or, with `reverse`, in both gears, from rest to rest, takes less [s].
///
/// 1. Length. The path is at least L long: L is the largest of `distance`, of the shortest Dubins word of the smallest
///    radius rho_min [Dubins 1957], and of rho_min times the turn of 2.
/// 2. Turn. Headings turn by at least Theta = max(|h1 - h0|, min(pi, |phi - h0| + |h1 - phi|)), phi the direction from
///    start to goal: if no heading of the path is phi, they span at least pi, or the mean of all directions of travel
///    could not be phi. The arcs are at least S = rho_min Theta long.
/// 3. Speed. At arc length s from the nearer end the speed is at most w(s) = min(v_ms, sqrt(2 a_max s)), on arcs at
/// most
///    v_c, the highest value of v_mc. The time is the integral of 1 / speed: that of 1 / w over L, plus on the arcs
///    that of max(0, 1 / v_c - 1 / w). The latter grows with s, so it is least where half of S lies at either end; both
///    grow with the length of the path.
///
/// @param distance  a length that the path has at least [m]: that of the straight line, or of a point's shortest path
///   if the body covers the reference point. Infinity: no path.
///
/// With `reverse` the shortest word is that of Reeds and Shepp, Theta = |h1 - h0|, and speeds are those of the faster
/// gear.
/// Rounding is taken off, that of coordinates too. Constant time.
double travel_time_lower_bound(const Pose& start, const Pose& goal, double distance, const Vehicle& vehicle,
                               bool reverse = false);

}  // namespace arcway::internal

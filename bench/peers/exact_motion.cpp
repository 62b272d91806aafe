#include "bench/peers/exact_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/path/dubins.h"
#include "core/path/speed_profile.h"

namespace arcway::peers {

Footprint checked_body(const Vehicle& vehicle) { return vehicle.footprint(0.5 * vehicle.safety_margin()); }

bool pose_free(const SweepQuery& sweep, const Footprint& body, const Pose& pose) {
  return sweep.straight_free(swept_rectangle(pose, 0.0, body));
}

bool motion_free(const SweepQuery& sweep, const Footprint& body, std::span<const PathSegment> motion) {
  // Lines first: a rectangle costs less than a set of headings.
  for (const PathSegment& s : motion)
    if (s.is_line() && !sweep.straight_free(swept_rectangle(s.start, s.length, body))) return false;
  return std::ranges::all_of(motion, [&](const PathSegment& s) {
    if (s.is_line()) return true;
    const Side side = s.curvature > 0.0 ? Side::kLeft : Side::kRight;
    const double radius = 1.0 / std::abs(s.curvature);
    const Vec2 center = s.start.position() + sign_of(side) * radius * perpendicular(direction_of(s.start.heading));
    const HeadingSet free = sweep.free_headings(TurningBody{center, radius, side, body});
    return free.reach(s.start.heading, side) >= s.length / radius;
  });
}

Path shortest_dubins_path(const Pose& from, const Pose& to, double radius) {
  Path best;
  double shortest = std::numeric_limits<double>::infinity();
  for (const DubinsWord word : kDubinsWords) {
    std::optional<Path> path = dubins_path(word, from, to, radius);
    if (!path) continue;
    const double length = length_of(*path);
    if (length >= shortest) continue;
    shortest = length;
    best = std::move(*path);
  }
  return best;
}

double travel_time(std::span<const PathSegment> path, const Vehicle& vehicle) {
  return speed_profile(path, vehicle).total_time;
}

}  // namespace arcway::peers

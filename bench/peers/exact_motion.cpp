#include "bench/peers/exact_motion.h"

#include <limits>

#include "arcway/validation.h"
#include "core/motion/dubins.h"
#include "core/motion/speed_profile.h"

namespace arcway::internal::peers {

Body checked_body(const Vehicle& vehicle) { return vehicle.body(0.5 * vehicle.safety_margin()); }

bool pose_free(const SweepQuery& sweep, const Body& body, const Pose& pose) {
  return sweep.straight_free({pose, 0.0, body});
}

bool is_valid(const Problem& problem, const Path& path) {
  const SpeedProfile profile = speed_profile(path, problem.vehicle);
  TimedPath timed{path, {}, {}, profile.durations};
  for (std::size_t i = 0; i < path.size(); ++i) {
    timed.speed_in.push_back(profile.speeds[i]);
    timed.speed_out.push_back(profile.speeds[i + 1]);
  }
  return validate(problem.world, problem.vehicle, problem.request.start, problem.request.goal, timed).valid();
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

}  // namespace arcway::internal::peers

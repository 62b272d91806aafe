#include "core/query/motion_free.h"

#include <algorithm>
#include <cmath>

namespace arcway {

bool motion_free(const SweepQuery& sweep, const Footprint& body, std::span<const PathSegment> motion) {
  for (const PathSegment& s : motion)
    if (s.is_line() && !sweep.straight_free(swept_rectangle(s.forwards().start, s.length, body))) return false;
  return std::ranges::all_of(motion, [&](const PathSegment& segment) {
    if (segment.is_line()) return true;
    const PathSegment s = segment.forwards();
    const Side side = s.curvature > 0.0 ? Side::kLeft : Side::kRight;
    const double radius = 1.0 / std::abs(s.curvature);
    const Vec2 center = s.start.position() + sign_of(side) * radius * perpendicular(direction_of(s.start.heading));
    const HeadingSet free = sweep.free_headings(TurningBody{center, radius, side, body});
    return free.reach(s.start.heading, side) >= s.length / radius;
  });
}

}  // namespace arcway

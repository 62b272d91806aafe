#include "core/collision/motion_free.h"

#include <algorithm>
#include <cmath>

namespace arcway::internal {

TurningBody turning_body(const PathSegment& arc, const Body& body) {
  const Side side = arc.curvature > 0.0 ? Side::kLeft : Side::kRight;
  const double radius = 1.0 / std::abs(arc.curvature);
  const Vec2 center = arc.start.position() + sign_of(side) * radius * perpendicular(direction_of(arc.start.heading));
  return {center, radius, side, body};
}

bool turn_free(const SweepQuery& sweep, const Body& body, const PathSegment& turn, HeadingSet& headings) {
  const PathSegment arc = turn.forwards();
  TurningBody turning = turning_body(arc, body);
  turning.gear = turn.gear;
  return sweep.arc_free(turning, arc.start.heading, arc.length / turning.radius, headings);
}

bool motion_free(const SweepQuery& sweep, const Body& body, std::span<const PathSegment> motion) {
  HeadingSet headings;
  return motion_free(sweep, body, motion, headings);
}

bool motion_free(const SweepQuery& sweep, const Body& body, std::span<const PathSegment> motion, HeadingSet& headings) {
  for (const PathSegment& s : motion)
    if (s.is_line() && !sweep.straight_free({s.forwards().start, s.length, body, s.gear})) return false;
  return std::ranges::all_of(motion, [&](const PathSegment& segment) {
    return segment.is_line() || turn_free(sweep, body, segment, headings);
  });
}

}  // namespace arcway::internal

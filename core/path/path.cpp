#include "core/path/path.h"

namespace arcway {

Pose PathSegment::at(double s) const {
  // The chord, not a difference of two points of the circle, which cancels when the curvature is small.
  const double half_turn = 0.5 * curvature * s;
  const double chord = half_turn == 0.0 ? s : s * (std::sin(half_turn) / half_turn);
  const Vec2 p = start.position() + chord * direction_of(start.heading + half_turn);
  return {p.x(), p.y(), start.heading + curvature * s};
}

double length_of(std::span<const PathSegment> path) {
  double length = 0.0;
  for (const PathSegment& segment : path) length += segment.length;
  return length;
}

}  // namespace arcway

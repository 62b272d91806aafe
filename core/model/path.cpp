#include "arcway/path.h"

#include <cmath>

#include "arcway/angle.h"

namespace arcway {

namespace {

// Difference of headings below which segments count as one line or circle: the rounding of sums [rad].
constexpr double kSameHeading = 1e-14;

}  // namespace

Pose PathSegment::at(double s) const {
  // The chord, not a difference of two points of the circle, which cancels when the curvature is small.
  const double ahead = sign_of(gear) * s;
  const double half_turn = 0.5 * curvature * ahead;
  const double chord = half_turn == 0.0 ? ahead : ahead * (std::sin(half_turn) / half_turn);
  const Vec2 p = start.position() + chord * direction_of(start.heading + half_turn);
  return {p.x(), p.y(), start.heading + curvature * ahead};
}

double length_of(std::span<const PathSegment> path) {
  double length = 0.0;
  for (const PathSegment& segment : path) length += segment.length;
  return length;
}

Path reversed(std::span<const PathSegment> path) {
  Path back;
  back.reserve(path.size());
  for (auto segment = path.rbegin(); segment != path.rend(); ++segment) back.push_back(segment->reversed());
  return back;
}

Path merged(std::span<const PathSegment> path) {
  Path whole;
  whole.reserve(path.size());
  for (const PathSegment& next : path) {
    if (!whole.empty()) {
      PathSegment& last = whole.back();
      const double length = last.length + next.length;
      if (next.gear == last.gear && next.curvature == last.curvature && length * std::abs(next.curvature) < kTwoPi &&
          std::abs(wrap_signed(next.start.heading - last.end().heading)) <= kSameHeading) {
        last.length = length;
        continue;
      }
    }
    whole.push_back(next);
  }
  return whole;
}

std::size_t cusps_of(std::span<const PathSegment> path) {
  std::size_t cusps = 0;
  for (std::size_t i = 1; i < path.size(); ++i) cusps += path[i].gear != path[i - 1].gear ? 1 : 0;
  return cusps;
}

}  // namespace arcway

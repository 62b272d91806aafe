#include "core/motion/biarc.h"

#include <cmath>

#include "arcway/angle.h"

namespace arcway::internal {

namespace {

constexpr double kSameHeading = 1e-9;  // difference of headings that rounding of two arcs explains [rad]

// The arc from a pose to a point, driven forwards.
std::optional<PathSegment> arc_to(const Pose& start, const Vec2& end, const SideRadii& radii) {
  constexpr double kStraight = 1e-13;  // tangent of the smallest turn that exceeds the rounding of headings
  const Vec2 ahead = direction_of(start.heading);
  const Vec2 chord = end - start.position();
  const double along = ahead.dot(chord), aside = cross(ahead, chord);
  if (std::abs(aside) <= kStraight * along) return PathSegment{start, along, 0.0};
  const double curvature = 2.0 * aside / chord.squaredNorm();
  const double bend = std::abs(curvature) * radii.on(curvature);
  if (!(bend <= 1.0 && bend * kWidestTurn >= 1.0)) return std::nullopt;
  return PathSegment{start, 2.0 * std::atan2(aside, along) / curvature, curvature};
}

}  // namespace

std::optional<std::array<PathSegment, 2>> biarc(const Pose& start, const Pose& goal, double ratio,
                                                const SideRadii& radii) {
  const Vec2 from = direction_of(start.heading), to = direction_of(goal.heading);
  const Vec2 way = goal.position() - start.position();
  // The tangent lengths d and ratio d: a d^2 + b d = way^2.
  const double a = 2.0 * ratio * (1.0 - from.dot(to));
  const double b = 2.0 * way.dot(from + ratio * to);
  const double c = way.squaredNorm();
  const double below = b + std::sqrt(b * b + 4.0 * a * c);
  if (!(below > 0.0 && c > 0.0)) return std::nullopt;
  const double length = 2.0 * c / below;
  const Vec2 first_corner = start.position() + length * from;
  const Vec2 second_corner = goal.position() - ratio * length * to;
  const Vec2 middle = (ratio * first_corner + second_corner) / (1.0 + ratio);
  const auto first = arc_to(start, middle, radii);
  if (!first) return std::nullopt;
  const auto second = arc_to({middle.x(), middle.y(), first->end().heading}, goal.position(), radii);
  // For poses that face each other on one line, the second arc is a half turn on a point, which rounding may lose.
  if (!second || std::abs(wrap_signed(second->end().heading - goal.heading)) > kSameHeading) return std::nullopt;
  return std::array{*first, *second};
}

}  // namespace arcway::internal

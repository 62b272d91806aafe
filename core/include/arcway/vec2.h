#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <limits>

#include "arcway/export.h"

namespace arcway {

/// A point or a vector of the plane, in meters: x to the right, y up.
using Vec2 = Eigen::Vector2d;

/// The closed straight segment from `a` to `b`; may be a single point.
struct LineSegment {
  Vec2 a;
  Vec2 b;
};

/// z component of the cross product; positive if `v` points to the left of `u`. Rounded: use
/// `orientation` of predicates.h where the sign decides.
inline double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

/// `v` turned by 90 degrees counter-clockwise.
inline Vec2 perpendicular(const Vec2& v) { return {-v.y(), v.x()}; }

/// Unit vector of a heading [rad].
inline Vec2 direction_of(double heading) { return {std::cos(heading), std::sin(heading)}; }

/// Closed axis-parallel box. Default-constructed it is empty: min > max, overlaps nothing.
struct ARCWAY_API Box {
  Vec2 min{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 max{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void extend(const Vec2& p) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }
  void extend(const Box& other) {
    min = min.cwiseMin(other.min);
    max = max.cwiseMax(other.max);
  }
  [[nodiscard]] bool overlaps(const Box& o) const {
    return min.x() <= o.max.x() && o.min.x() <= max.x() && min.y() <= o.max.y() && o.min.y() <= max.y();
  }
  [[nodiscard]] bool contains(const Vec2& p) const {
    return min.x() <= p.x() && p.x() <= max.x() && min.y() <= p.y() && p.y() <= max.y();
  }
  [[nodiscard]] bool empty() const { return min.x() > max.x(); }
  /// The point of the box, which must not be empty, nearest to `p`.
  [[nodiscard]] Vec2 closest_point(const Vec2& p) const { return p.cwiseMax(min).cwiseMin(max); }
  /// 0 inside.
  [[nodiscard]] double distance_to(const Vec2& p) const { return (closest_point(p) - p).norm(); }
  /// 0 if they meet. Neither may be empty.
  [[nodiscard]] double distance_to(const Box& o) const {
    return (min - o.max).cwiseMax(o.min - max).cwiseMax(Vec2::Zero()).norm();
  }
  /// The box with all sides moved outwards.
  [[nodiscard]] Box grown(double by) const { return {min - Vec2::Constant(by), max + Vec2::Constant(by)}; }
  /// Counter-clockwise, from `min` on.
  [[nodiscard]] std::array<Vec2, 4> corners() const {
    return {min, Vec2(max.x(), min.y()), max, Vec2(min.x(), max.y())};
  }
};

/// The smallest box around a segment.
inline Box box_of(const LineSegment& s) { return {s.a.cwiseMin(s.b), s.a.cwiseMax(s.b)}; }

}  // namespace arcway

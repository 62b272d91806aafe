#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <limits>

#include "arcway/export.h"

namespace arcway {

/// A point or a vector of the plane [m]: x to the right, y up.
///
/// The *exact range* of a coordinate is 0 and the magnitudes from 1e-100 to 1e100. There, signs of orientation can be
/// decided exactly, as products neither underflow nor overflow. Worlds and queries refuse other coordinates.
using Vec2 = Eigen::Vector2d;

/// The closed straight segment from `a` to `b`, which may be a single point [m].
struct LineSegment {
  Vec2 a;
  Vec2 b;
};

/// The z component of the cross product, positive if `v` points to the left of `u`. It is rounded, so that its sign
/// decides nothing.
inline double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

/// `v` turned counter-clockwise by 90 degrees.
inline Vec2 perpendicular(const Vec2& v) { return {-v.y(), v.x()}; }

/// The unit vector of a heading [rad].
inline Vec2 direction_of(double heading) { return {std::cos(heading), std::sin(heading)}; }

/// A closed axis-parallel box [m]. A default-constructed box is empty: min > max, and it overlaps nothing.
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
  /// The point of the box nearest to `p`. Precondition: the box is not empty.
  [[nodiscard]] Vec2 closest_point(const Vec2& p) const { return p.cwiseMax(min).cwiseMin(max); }
  /// The distance of `p` from the box [m]; 0 inside.
  [[nodiscard]] double distance_to(const Vec2& p) const { return (closest_point(p) - p).norm(); }
  /// The distance between two boxes [m]; 0 if they meet. Precondition: neither is empty.
  [[nodiscard]] double distance_to(const Box& o) const {
    return (min - o.max).cwiseMax(o.min - max).cwiseMax(Vec2::Zero()).norm();
  }
  /// The box with all sides moved outwards [m].
  [[nodiscard]] Box grown(double by) const { return {min - Vec2::Constant(by), max + Vec2::Constant(by)}; }
  /// The corners, counter-clockwise from `min` on.
  [[nodiscard]] std::array<Vec2, 4> corners() const {
    return {min, Vec2(max.x(), min.y()), max, Vec2(min.x(), max.y())};
  }
};

/// The smallest box around a segment.
inline Box box_of(const LineSegment& s) { return {s.a.cwiseMin(s.b), s.a.cwiseMax(s.b)}; }

}  // namespace arcway

#pragma once

#include <cmath>
#include <span>

#include "arcway/polygon.h"
#include "arcway/vec2.h"

namespace arcway::internal {

/// \file
/// Geometric predicates whose signs are those of exact arithmetic on the given doubles. A floating-point filter decides
/// most of them [Shewchuk 1997, adaptive orient2d], floating-point expansions the rest. Sources that include this are
/// compiled without contraction to fused multiply-add. Coordinates must be zero or of a magnitude in [kMinMagnitude,
/// kMaxMagnitude], where products neither underflow nor overflow. World refuses all others. All functions are pure,
/// thread-safe and do not allocate.

inline constexpr double kMinMagnitude = 1e-100;
inline constexpr double kMaxMagnitude = 1e100;
/// Whether a coordinate is one of these.
inline bool is_in_range(double coordinate) {
  const double magnitude = std::abs(coordinate);
  return coordinate == 0.0 || (magnitude >= kMinMagnitude && magnitude <= kMaxMagnitude);  // not if NaN
}
inline bool is_in_range(const Vec2& p) { return is_in_range(p.x()) && is_in_range(p.y()); }

namespace detail {
int exact_orientation(const Vec2& a, const Vec2& b, const Vec2& c);
}

/// Sign of the area of the triangle (a, b, c), exact: +1 if `c` lies to the left of the line from `a` to `b`, -1 to the
/// right. 0 on the line, or if a == b. Antisymmetric in any two arguments.
inline int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  constexpr double kEpsilon = 0x1p-53;
  constexpr double kErrorBound = (3.0 + 16.0 * kEpsilon) * kEpsilon;  // [Shewchuk 1997, figure 21]
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double determinant = left - right;
  const double error = kErrorBound * (std::abs(left) + std::abs(right));
  if (determinant > error) return 1;
  if (determinant < -error) return -1;
  return detail::exact_orientation(a, b, c);
}

/// Twice the area of the triangle (a, b, c) [m^2], with the sign of `orientation`, to a unit or two in the last place.
double doubled_area(const Vec2& a, const Vec2& b, const Vec2& c);

/// How two closed segments meet. Exactly one case holds; a segment may be a single point.
enum class SegmentRelation {
  kDisjoint,          ///< no common point
  kCrossing,          ///< one common point, interior to both (a proper crossing)
  kTouchingInterior,  ///< one common point, an end of one and interior to the other
  kTouchingEnds,      ///< one common point, an end of both
  kOverlapping        ///< collinear with more than one common point (equal segments too)
};
SegmentRelation relate(const LineSegment& s, const LineSegment& t);

/// Whether `p` lies on the closed segment.
bool on_segment(const Vec2& p, const LineSegment& s);

/// Whether `p` lies on the open segment from s.a to s.b (neither end).
bool on_open_segment(const Vec2& p, const LineSegment& s);

/// Place of `p` in the closed region of a ring of >= 3 vertices (not closed by a repeated point,
/// either orientation, pinches allowed; even-odd). O(n).
PointLocation locate(const Vec2& p, std::span<const Vec2> ring);

/// Whether the direction from `v` towards `p` points strictly into the cone at `v` that lies to the left of prev -> v
/// -> next. That is the obstacle's interior if it lies to the left of its ring. `p != v`; prev, v, next need not be in
/// convex position.
bool in_open_cone(const Vec2& prev, const Vec2& v, const Vec2& next, const Vec2& p);

/// Whether a closed segment and a closed convex quadrilateral (corners counter-clockwise, or all
/// on a line) have a common point. Exact on the given corners: one of the five edge lines
/// separates two disjoint convex sets, or all are one line.
bool intersects(const LineSegment& s, std::span<const Vec2, 4> quad);

}  // namespace arcway::internal

#pragma once

#include <span>

#include "arcway/polygon.h"
#include "arcway/vec2.h"

namespace arcway::internal {

/// \file
/// Distances between closed sets [m]: never negative, 0 if the two meet. Between points, segments and polygons, meeting
/// is decided exactly (predicates.h), so that 0 is given if and only if they meet. Between an arc and another set it is
/// decided up to rounding.

/// The point of `s` nearest to `p`, rounded; an end of `s` is given exactly.
Vec2 closest_point(const Vec2& p, const LineSegment& s);

double distance(const Vec2& p, const LineSegment& s);
double distance(const LineSegment& s, const LineSegment& t);

/// To the polygon as a region: 0 inside and on every ring, positive outside and in its holes.
/// O(vertices).
double distance(const Vec2& p, const Polygon& polygon);

/// Between two polygons as regions; 0 too if one contains the other. O(n m).
double distance(const Polygon& a, const Polygon& b);

/// To a closed convex quadrilateral, corners counter-clockwise and not all on a line. 0 inside.
double distance(const LineSegment& s, std::span<const Vec2, 4> quad);

/// Points at `radius` >= 0 from `center`, from `start_angle` on through `sweep` [rad]: positive is
/// counter-clockwise; from 2 pi on, either way, it is the full circle.
struct CircularArc {
  Vec2 center;
  double radius;
  double start_angle;
  double sweep;

  /// The point after a signed turn of `angle` from the start.
  [[nodiscard]] Vec2 point_at(double angle) const;
  [[nodiscard]] Vec2 start() const { return point_at(0.0); }
  [[nodiscard]] Vec2 end() const { return point_at(sweep); }
  /// Whether the ray from the center in this direction [rad] meets the arc, up to rounding.
  [[nodiscard]] bool covers(double direction) const;
};

/// The arc's points only, not its disk: the center of an arc is `radius` away from it.
/// Closed form; absolute error of a few roundings of the largest length involved.
double distance(const CircularArc& arc, const Vec2& p);

/// Closed form: the nearest pair has an end of one of the two, or lies on the perpendicular from
/// the center, or is a crossing (0). A crossing within rounding of an end may give a distance of
/// some 1e-16 of the largest length involved instead of 0.
double distance(const CircularArc& arc, const LineSegment& s);

}  // namespace arcway::internal

#pragma once

#include <vector>

#include "arcway/closed_spline.h"
#include "arcway/vec2.h"

namespace arcway::internal {

/// \file
/// Tangent lines of smooth closed curves, for visibility graphs among curved obstacles. Each is the root of a function
/// of one variable [Jiang, Seneviratne and Earles 1997, section 2]. All tangents are found, also on curves that are not
/// convex. Whether obstacles lie in between is not checked. Results are rounded, unlike the predicates on polygons.

/// A line through a point that touches a curve.
struct PointTangent {
  double t;     ///< parameter of the curve, in [0, size)
  Vec2 touch;   ///< curve.at(t)
  bool onward;  ///< whether the curve runs on away from the point there, or back towards it
};
/// The lines through a point that touch a curve, by ascending t. They are the roots of cross(curve(t) - point,
/// curve'(t)), of degree 4 on each cubic, isolated by the signs of its Bernstein coefficients. A point outside a convex
/// curve has two tangents, one inside has none. Touches closer than about 1e-9 in t count as one. The tangent at a
/// point of the curve itself may be listed or not.
std::vector<PointTangent> tangents_from(const Vec2& point, const ClosedSpline& curve);

/// A line that touches two curves.
struct CommonTangent {
  double t_first, t_second;
  Vec2 first, second;  ///< where it touches
  bool crossing;       ///< whether the curves run in opposite directions there: it passes between two convex curves of
                       ///< one orientation
};
/// The lines that touch both curves, by ascending t_first. Two disjoint convex curves have four, two that cross in two
/// points have two. Both curves are cut into arcs of one bend that turn by less than a right angle. For two arcs, the
/// distance between their tangents of direction phi is a function of phi. Its slope is at most the largest distance of
/// the arcs. Intervals of phi without a root are ruled out by that bound; the others are halved.
/// @throws std::invalid_argument if the curves run along each other, where tangents are not finitely many.
std::vector<CommonTangent> common_tangents(const ClosedSpline& first, const ClosedSpline& second);

}  // namespace arcway::internal

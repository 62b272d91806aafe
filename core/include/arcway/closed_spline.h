#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "arcway/export.h"
#include "arcway/polygon.h"
#include "arcway/vec2.h"

namespace arcway {

/// A cubic Bezier curve: the sum of binomial(3, k) (1-u)^(3-k) u^k p[k] over k, for u in [0, 1]. It lies in the convex
/// hull of its control points p [m].
struct ARCWAY_API CubicBezier {
  std::array<Vec2, 4> p;

  [[nodiscard]] Vec2 at(double u) const;
  [[nodiscard]] Vec2 derivative(double u) const;
  [[nodiscard]] Vec2 second_derivative(double u) const;
  /// The part from u = low to u = high, 0 <= low < high <= 1.
  [[nodiscard]] CubicBezier part(double low, double high) const;
  /// The halves u <= 1/2 and u >= 1/2, by de Casteljau's averages.
  [[nodiscard]] std::array<CubicBezier, 2> halves() const;
};

/// A smooth closed curve through given points: the periodic cubic spline, with two continuous derivatives. Its
/// parameter grows with the length of the chords. As an obstacle it is the region inside.
///
///     const ClosedSpline pond({{0, 0}, {9, 2}, {12, 8}, {3, 7}});
///     const World world({Polygon{circumscribed_ring(pond.pieces(), 0.01), {}}});
///
/// The parameter t runs from 0 to size(). At t = i the curve passes point i; between points, t - i is the u of piece i.
/// Immutable, thread-safe.
class ARCWAY_API ClosedSpline {
 public:
  /// @param points  at least 3, in the exact range of vec2.h [m]; no two neighbors equal, the last and the first
  ///   included.
  /// @throws std::invalid_argument naming the point. O(n).
  explicit ClosedSpline(std::span<const Vec2> points);
  ClosedSpline(std::initializer_list<Vec2> points) : ClosedSpline(std::span(points.begin(), points.size())) {}

  /// Number of points, which is the number of pieces. Piece i runs from point i to the next one.
  [[nodiscard]] std::size_t size() const { return pieces_.size(); }
  [[nodiscard]] std::span<const CubicBezier> pieces() const { return pieces_; }
  /// The point of the curve at t. Precondition: t in [0, size()].
  [[nodiscard]] Vec2 at(double t) const;
  /// The derivative by t. Its direction is continuous at the points, its length is not. Precondition: t in [0, size()].
  [[nodiscard]] Vec2 derivative(double t) const;

 private:
  std::vector<CubicBezier> pieces_;
};

/// A ring around a closed chain of cubics. It contains everything to the left of the chain, and no point of it lies
/// farther than `tolerance` from the curve. An obstacle lies on the left: give the chain of a hole clockwise.
///
/// 1. Each cubic is halved until its control points lie within the tolerance of its chord, in order along it.
/// 2. The right-hand side of their convex hull goes into the ring. The curve lies in that hull, hence left of the ring
///    or on it.
/// 3. The ring is moved to the right by 2^-44 of the largest coordinate, which covers rounding. Computed control points
///    are off by less than 2^-48 of it, as each of at most 40 halvings rounds three averages.
/// 4. Vertices within half of that of the line between their neighbors are left out.
///
/// Corners between two pieces stay where they are. A line from a to b is the cubic a, a, b, b. The ring is simple if
/// the curve is simple and the tolerance is small beside the curve's narrowest place. World refuses other rings. The
/// number of vertices grows as 1/sqrt(tolerance).
/// @param pieces  at least one. Each begins where the one before ends, bit for bit, and the first one where the last
///   one ends.
/// @param tolerances  one a piece [m], each at least 2^-40 of the largest coordinate. Different ones refine where it
///   matters.
/// @throws std::invalid_argument naming the piece, or if there are more than a million vertices.
ARCWAY_API Ring circumscribed_ring(std::span<const CubicBezier> pieces, std::span<const double> tolerances);
/// Overload with one tolerance [m] for all pieces.
ARCWAY_API Ring circumscribed_ring(std::span<const CubicBezier> pieces, double tolerance);

}  // namespace arcway

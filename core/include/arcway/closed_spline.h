#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "arcway/export.h"
#include "arcway/polygon.h"
#include "arcway/vec2.h"

namespace arcway {

/// The curve sum of binomial(3, k) (1-u)^(3-k) u^k p[k] for u in [0, 1]. It lies in the convex hull of p.
struct ARCWAY_API CubicBezier {
  std::array<Vec2, 4> p;

  [[nodiscard]] Vec2 at(double u) const;
  [[nodiscard]] Vec2 derivative(double u) const;
  [[nodiscard]] Vec2 second_derivative(double u) const;
  /// The part from u = low to u = high, 0 <= low < high <= 1.
  [[nodiscard]] CubicBezier part(double low, double high) const;
  /// The two halves, by averages alone.
  [[nodiscard]] std::array<CubicBezier, 2> halves() const;
};

/// A smooth closed curve through given points: the periodic cubic spline, with two continuous derivatives, its
/// parameter growing with the length of the chords. As an obstacle it is what lies inside.
///
///     const ClosedSpline pond({{0, 0}, {9, 2}, {12, 8}, {3, 7}});
///     const World world({Polygon{circumscribed_ring(pond.pieces(), 0.01), {}}});
///
/// Parameter t runs from 0 to size(); t = i is point i, and between points it is the piece's own u. Immutable,
/// thread-safe.
class ARCWAY_API ClosedSpline {
 public:
  /// @param points  at least 3, in the range of predicates.h, no two neighbors equal (the last one is a neighbor of
  ///   the first).
  /// @throws std::invalid_argument naming the point. O(n).
  explicit ClosedSpline(std::span<const Vec2> points);
  ClosedSpline(std::initializer_list<Vec2> points) : ClosedSpline(std::span(points.begin(), points.size())) {}

  /// Number of points and of pieces; piece i runs from point i to the next.
  [[nodiscard]] std::size_t size() const { return pieces_.size(); }
  [[nodiscard]] std::span<const CubicBezier> pieces() const { return pieces_; }
  /// Precondition: t in [0, size()].
  [[nodiscard]] Vec2 at(double t) const;
  /// d/dt; its direction is continuous at the points, its length is not.
  [[nodiscard]] Vec2 derivative(double t) const;

 private:
  std::vector<CubicBezier> pieces_;
};

/// A ring round a closed chain of cubics that contains everything to the left of it, no point of it farther than
/// `tolerance` from the curve: obstacle on the left, so for a hole give the chain clockwise.
///
/// Each cubic is halved until its control points lie within the tolerance of its chord and in order along it; then the
/// right-hand side of their convex hull goes into the ring. The curve lies in that hull, so that it is on the left of
/// the ring or on it. Computed control points are off by less than 2^-48 of the largest coordinate (each of at most 40
/// halvings rounds 3 averages); the ring is moved to the right by 2^-44 of it, which covers that twice.
/// Vertices within half of that of the line between their neighbors are left out.
/// Corners between two pieces stay where they are. A line from a to b is the cubic a, a, b, b.
/// The number of vertices grows as 1/sqrt(tolerance). The ring is simple if the curve is and the tolerance is small
/// beside its narrowest place; World refuses it otherwise.
/// @param pieces      at least one; each begins where the last one ends, bit for bit; the last one ends where the first
/// begins.
/// @param tolerances  one a piece [m], each at least 2^-40 of the largest coordinate: for refinement where it matters.
/// @throws std::invalid_argument naming the piece, or if there are more than a million vertices.
ARCWAY_API Ring circumscribed_ring(std::span<const CubicBezier> pieces, std::span<const double> tolerances);
/// The same with one tolerance for all.
ARCWAY_API Ring circumscribed_ring(std::span<const CubicBezier> pieces, double tolerance);

}  // namespace arcway

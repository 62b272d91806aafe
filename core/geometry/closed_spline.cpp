#include "arcway/closed_spline.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/base/shortest_text.h"
#include "core/geometry/predicates.h"

namespace arcway {

using namespace internal;
namespace {

constexpr int kMaxHalvings = 40;
constexpr std::size_t kMostVertices = 1'000'000;  // largest number of vertices of a ring
constexpr double kSmooth = 0x1p-20;               // sine of the largest turn at a joint that is no corner

Vec2 middle(const Vec2& a, const Vec2& b) { return 0.5 * (a + b); }

// Solves a cyclic tridiagonal system for two right-hand sides at once [Sherman and Morrison]. Row i is lower[i] x[i-1]
// + diagonal[i] x[i] + upper[i] x[i+1] = right[i].
std::vector<Vec2> solve_cyclic(const std::vector<double>& lower, std::vector<double> diagonal,
                               const std::vector<double>& upper, std::vector<Vec2> right) {
  const std::size_t n = diagonal.size();
  const double gamma = -diagonal[0];
  diagonal[0] -= gamma;
  diagonal[n - 1] -= upper[n - 1] * lower[0] / gamma;
  std::vector<double> u(n, 0.0);
  u[0] = gamma;
  u[n - 1] = upper[n - 1];
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = lower[i] / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    right[i] -= factor * right[i - 1];
    u[i] -= factor * u[i - 1];
  }
  right[n - 1] /= diagonal[n - 1];
  u[n - 1] /= diagonal[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) {
    right[i] = (right[i] - upper[i] * right[i + 1]) / diagonal[i];
    u[i] = (u[i] - upper[i] * u[i + 1]) / diagonal[i];
  }
  const double v = lower[0] / gamma;
  const Vec2 share = (right[0] + v * right[n - 1]) / (1.0 + u[0] + v * u[n - 1]);
  for (std::size_t i = 0; i < n; ++i) right[i] -= u[i] * share;
  return right;
}

struct Place {
  std::size_t piece;
  double u;
};
Place place_of(double t, std::size_t pieces) {
  assert(t >= 0.0 && t <= static_cast<double>(pieces));
  const double whole = std::clamp(std::floor(t), 0.0, static_cast<double>(pieces - 1));
  return {static_cast<std::size_t>(whole), t - whole};
}

class Circumscriber {
 public:
  explicit Circumscriber(double slack) : slack_(slack) {}

  /// Corners are ends of the piece that stay where they are.
  void add(const CubicBezier& piece, double tolerance, bool corner_first, bool corner_last, int halvings = 0) {
    if (halvings < kMaxHalvings && !is_flat(piece, tolerance)) {
      const auto halves = piece.halves();
      add(halves[0], tolerance, corner_first, false, halvings + 1);
      add(halves[1], tolerance, false, corner_last, halvings + 1);
      return;
    }
    add_right_hull(piece, corner_first, corner_last);
    if (ring_.size() > kMostVertices)
      throw std::invalid_argument("circumscribed ring: more than " + std::to_string(kMostVertices) +
                                  " vertices within a tolerance of " + shortest_text(tolerance));
  }
  Ring finish() {
    if (ring_.size() > 1 && ring_.front() == ring_.back()) ring_.pop_back();
    // Where two convex pieces meet smoothly, the joint is on the line between its neighbors but for rounding, and a
    // turn there means nothing. Without it the ring is still to the right of the curve, as it was moved by more.
    const std::size_t n = ring_.size();
    Ring kept;
    bool dropped = false;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 &before = ring_[i == 0 ? n - 1 : i - 1], &after = ring_[i + 1 < n ? i + 1 : 0];
      const Vec2 along = after - before;
      dropped = !dropped && i > 0 && (ring_[i] - before).dot(after - ring_[i]) > 0.0 &&
                std::abs(cross(along, ring_[i] - before)) <= 0.5 * slack_ * along.norm();
      if (!dropped) kept.push_back(ring_[i]);
    }
    return kept;
  }

 private:
  // Control points within the tolerance of the chord, less what the ring is moved by, and in order along it.
  [[nodiscard]] bool is_flat(const CubicBezier& piece, double tolerance) const {
    if (piece.p[1] == piece.p[0] && piece.p[2] == piece.p[3]) return true;  // a line
    const Vec2 chord = piece.p[3] - piece.p[0];
    const double length = chord.norm();
    if (!(length > 0.0)) return false;  // it comes back to where it began
    const double b = chord.dot(piece.p[1] - piece.p[0]), c = chord.dot(piece.p[2] - piece.p[0]);
    if (!(b >= 0.0 && b <= c && c <= length * length)) return false;
    const double away =
        std::max(std::abs(cross(chord, piece.p[1] - piece.p[0])), std::abs(cross(chord, piece.p[2] - piece.p[0])));
    // A quarter of the chord, so that no edge of the hull turns far from it.
    return away <= length * std::min(tolerance - 2.0 * slack_, 0.25 * length);
  }

  void add_right_hull(const CubicBezier& piece, bool corner_first, bool corner_last) {
    std::array<Vec2, 4> hull;
    std::size_t size = 0;
    for (const Vec2& p : piece.p) {
      while (size >= 2 && cross(hull[size - 1] - hull[size - 2], p - hull[size - 1]) <= 0.0) --size;
      hull[size++] = p;
    }
    // To the right of the chord; the ends to the right of the curve, where both pieces agree on the direction.
    const Vec2 across = moved(piece.p[3] - piece.p[0]);
    const Vec2& first = piece.p[0];
    const Vec2& last = piece.p[3];
    append(corner_first ? first : first + moved(piece.derivative(0.0), moved(piece.p[2] - first, across)));
    for (std::size_t i = 1; i + 1 < size; ++i) append(hull[i] + across);
    append(corner_last ? last : last + moved(piece.derivative(1.0), moved(last - piece.p[1], across)));
  }
  [[nodiscard]] Vec2 moved(const Vec2& along, const Vec2& otherwise = Vec2(0.0, 0.0)) const {
    const double norm = along.norm();
    return norm > 0.0 ? Vec2(-slack_ / norm * perpendicular(along)) : otherwise;
  }
  void append(const Vec2& p) {
    if (ring_.empty() || ring_.back() != p) ring_.push_back(p);
  }

  double slack_;
  Ring ring_;
};

// Whether one piece goes on in another direction than the one before ends.
bool is_corner(const CubicBezier& before, const CubicBezier& after) {
  const auto first_of = [](const Vec2& a, const Vec2& b, const Vec2& c) {
    return !a.isZero(0.0) ? a : !b.isZero(0.0) ? b : c;
  };
  const auto &p = before.p, &q = after.p;
  const Vec2 in = first_of(p[3] - p[2], p[3] - p[1], p[3] - p[0]);
  const Vec2 out = first_of(q[1] - q[0], q[2] - q[0], q[3] - q[0]);
  return !(in.dot(out) > 0.0 && std::abs(cross(in, out)) <= kSmooth * in.norm() * out.norm());
}

}  // namespace

Vec2 CubicBezier::at(double u) const {
  const double v = 1.0 - u;
  return v * v * v * p[0] + 3.0 * v * v * u * p[1] + 3.0 * v * u * u * p[2] + u * u * u * p[3];
}

Vec2 CubicBezier::derivative(double u) const {
  const double v = 1.0 - u;
  return 3.0 * (v * v * (p[1] - p[0]) + 2.0 * v * u * (p[2] - p[1]) + u * u * (p[3] - p[2]));
}

Vec2 CubicBezier::second_derivative(double u) const {
  return 6.0 * ((1.0 - u) * (p[2] - 2.0 * p[1] + p[0]) + u * (p[3] - 2.0 * p[2] + p[1]));
}

CubicBezier CubicBezier::part(double low, double high) const {
  const double third = (high - low) / 3.0;
  const Vec2 a = at(low), b = at(high);
  return {{a, a + third * derivative(low), b - third * derivative(high), b}};
}

std::array<CubicBezier, 2> CubicBezier::halves() const {
  const Vec2 a = middle(p[0], p[1]), b = middle(p[1], p[2]), c = middle(p[2], p[3]);
  const Vec2 d = middle(a, b), e = middle(b, c), f = middle(d, e);
  return {CubicBezier{{p[0], a, d, f}}, CubicBezier{{f, e, c, p[3]}}};
}

ClosedSpline::ClosedSpline(std::span<const Vec2> points) {
  const std::size_t n = points.size();
  if (n < 3) throw std::invalid_argument("spline: needs at least 3 points, got " + std::to_string(n));
  std::vector<double> h(n);  // of the chord from point i
  for (std::size_t i = 0; i < n; ++i) {
    h[i] = (points[(i + 1) % n] - points[i]).norm();
    if (!is_in_range(points[i]) || !(h[i] > 0.0))
      throw std::invalid_argument("spline: point " + std::to_string(i) + " equals the next one, or has a coordinate " +
                                  "that is neither 0 nor of magnitude " + shortest_text(kMinMagnitude) + " to " +
                                  shortest_text(kMaxMagnitude));
  }
  // Velocities at the points, so that second derivatives agree there.
  std::vector<double> lower(n), diagonal(n), upper(n);
  std::vector<Vec2> right(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
    lower[i] = h[i];
    diagonal[i] = 2.0 * (h[before] + h[i]);
    upper[i] = h[before];
    right[i] = 3.0 * (h[i] / h[before] * (points[i] - points[before]) + h[before] / h[i] * (points[after] - points[i]));
  }
  const std::vector<Vec2> velocity = solve_cyclic(lower, diagonal, upper, right);
  pieces_.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t after = (i + 1) % n;
    pieces_.push_back({{points[i], points[i] + h[i] / 3.0 * velocity[i], points[after] - h[i] / 3.0 * velocity[after],
                        points[after]}});
  }
}

Vec2 ClosedSpline::at(double t) const {
  const Place place = place_of(t, size());
  return pieces_[place.piece].at(place.u);
}

Vec2 ClosedSpline::derivative(double t) const {
  const Place place = place_of(t, size());
  return pieces_[place.piece].derivative(place.u);
}

Ring circumscribed_ring(std::span<const CubicBezier> pieces, std::span<const double> tolerances) {
  if (pieces.empty()) throw std::invalid_argument("circumscribed ring: no pieces");
  if (pieces.size() != tolerances.size()) throw std::invalid_argument("circumscribed ring: one tolerance a piece");
  double largest = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const Vec2& p : pieces[i].p) {
      if (!p.allFinite())
        throw std::invalid_argument("circumscribed ring: piece " + std::to_string(i) + " is not finite");
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
    if (pieces[i].p[3] != pieces[(i + 1) % pieces.size()].p[0])
      throw std::invalid_argument("circumscribed ring: piece " + std::to_string(i) +
                                  " does not end where the next begins");
  }
  Circumscriber circumscriber(0x1p-44 * largest);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!(tolerances[i] >= 0x1p-40 * largest))
      throw std::invalid_argument("circumscribed ring: piece " + std::to_string(i) + ": tolerance is " +
                                  shortest_text(tolerances[i]) + ", must be at least " +
                                  shortest_text(0x1p-40 * largest) + " for coordinates up to " +
                                  shortest_text(largest));
    const CubicBezier &before = pieces[i == 0 ? pieces.size() - 1 : i - 1], &after = pieces[(i + 1) % pieces.size()];
    circumscriber.add(pieces[i], tolerances[i], is_corner(before, pieces[i]), is_corner(pieces[i], after));
  }
  return circumscriber.finish();
}

Ring circumscribed_ring(std::span<const CubicBezier> pieces, double tolerance) {
  return circumscribed_ring(pieces, std::vector<double>(pieces.size(), tolerance));
}

}  // namespace arcway

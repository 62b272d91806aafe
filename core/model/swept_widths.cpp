#include "core/model/swept_widths.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <numeric>

namespace arcway::internal {
namespace {

void keep_positive(std::vector<double>& radii, std::initializer_list<double> found) {
  for (const double radius : found)
    if (radius > 0.0 && radius < INFINITY) radii.push_back(radius);
}

// Where two points are equally far from the center.
double equally_far(const Vec2& p, const Vec2& q) { return (p - q).dot(p + q) / (2.0 * (p.y() - q.y())); }

// Where a point is as far from the center as a line of the points x with normal.x = c.
void add_point_against_line(std::vector<double>& radii, const Vec2& p, const Vec2& normal, double c) {
  const double square = normal.x() * normal.x(), half_linear = normal.y() * c - p.y();
  const double constant = p.squaredNorm() - c * c;
  if (square == 0.0) return keep_positive(radii, {-0.5 * constant / half_linear});
  const double discriminant = half_linear * half_linear - square * constant;
  if (!(discriminant >= 0.0)) return;
  const double q = -(half_linear + std::copysign(std::sqrt(discriminant), half_linear));
  keep_positive(radii, {q / square, constant / q});
}

}  // namespace

SweptWidths::SweptWidths(std::span<const Ring> rings, Side side) : outline_(rings, side) {
  const std::vector<double> radii = candidates();
  SweptOutline::Bounds before;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double within = i + 1 < radii.size() ? std::midpoint(radii[i], radii[i + 1]) : 2.0 * radii[i] + 1.0;
    const SweptOutline::Bounds here = outline_.bounds(within);
    if (here == before) continue;
    before = here;
    knots_.push_back(radii[i]);
    add_extrema(here);
  }
  std::ranges::sort(knots_);
}

// Radii at which the bounds may change: 0, and where two distances are equal, a foot is at an end or a line meets the
// center.
std::vector<double> SweptWidths::candidates() const {
  std::vector<double> radii{0.0};
  const std::span<const SweptOutline::Edge> edges = outline_.edges();
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& [from, to, along, normal, length] = edges[i];
    const double c = normal.dot(from);
    keep_positive(radii, {from.y(), c / normal.y(), along.dot(from) / along.y(), along.dot(to) / along.y()});
    for (const SweptOutline::Edge& other : edges) add_point_against_line(radii, other.from, normal, c);
    for (const SweptOutline::Edge& other : edges.first(i)) {
      const double d = other.normal.dot(other.from);
      keep_positive(radii, {equally_far(from, other.from), (c - d) / (normal.y() - other.normal.y()),
                            (c + d) / (normal.y() + other.normal.y())});
    }
  }
  std::ranges::sort(radii);
  radii.erase(std::unique(radii.begin(), radii.end()), radii.end());
  return radii;
}

// Radii among which are those at which the width by these bounds is extreme.
void SweptWidths::add_extrema(const SweptOutline::Bounds& bounds) {
  const Vec2& outer = outline_.edges()[bounds.outer].from;
  const double aside = std::abs(outer.x());
  if (bounds.inner_corner != SweptOutline::kNone) {
    // Both corners are seen at the same angle from the center.
    const Vec2& inner = outline_.edges()[bounds.inner_corner].from;
    const double inner_aside = std::abs(inner.x());
    keep_positive(knots_, {(inner_aside * outer.y() - aside * inner.y()) / (inner_aside - aside)});
  } else if (bounds.inner_side == SweptOutline::kNone) {
    keep_positive(knots_, {outer.y()});
  } else {
    // The distance of the side rises or falls by |normal.y| a meter of radius.
    const Vec2& normal = outline_.edges()[bounds.inner_side].normal;
    const double shift = aside * normal.y() / std::abs(normal.x());
    keep_positive(knots_, {outer.y() + shift, outer.y() - shift});
  }
}

// A radius beyond the last knot at which the width is below the limit or not, as at an infinite radius.
double SweptWidths::far_radius(double from, double limit, bool fits) const {
  double radius = std::max(2.0 * from, outline_.straight_width());
  while ((at(radius) < limit) != fits && radius < kLargestVehicleNumber) radius *= 2.0;
  return radius;
}

// The last radius where the width is below the limit, from one where it is towards one where it is not.
double SweptWidths::last_below(double limit, double from, double towards) const {
  while (true) {
    const double middle = std::midpoint(from, towards);
    if (middle == from || middle == towards) return from;
    (at(middle) < limit ? from : towards) = middle;
  }
}

std::vector<RadiusRange> SweptWidths::below(double limit, double least) const {
  std::vector<RadiusRange> ranges;
  const auto add = [&](double low, double high) {
    if (!ranges.empty() && ranges.back().high >= low) {
      ranges.back().high = high;
    } else {
      ranges.push_back({low, high});
    }
  };
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    const bool is_last = i + 1 == knots_.size();
    const double low = std::max(knots_[i], least);
    const double high = is_last ? INFINITY : knots_[i + 1];
    if (high <= low) continue;
    const bool low_fits = at(low) < limit;
    const bool high_fits = (is_last ? outline_.straight_width() : at(high)) < limit;
    const double finite = is_last && low_fits != high_fits ? far_radius(low, limit, high_fits) : high;
    if (low_fits) {
      add(low, high_fits ? high : last_below(limit, low, finite));
    } else if (high_fits) {
      add(last_below(limit, finite, low), high);
    }
  }
  return ranges;
}

}  // namespace arcway::internal

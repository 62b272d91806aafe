#include "core/model/swept_outline.h"

#include <algorithm>
#include <cmath>

namespace arcway::internal {
namespace {

// By how much a point is further from the center than the radius. The difference is rationalised.
double beyond_point(const Vec2& p, double radius) {
  const double ahead = radius - p.y();
  const double distance = std::hypot(p.x(), ahead);
  return ahead > 0.0 ? p.x() * (p.x() / (distance + ahead)) - p.y() : distance - radius;
}

}  // namespace

SweptOutline::SweptOutline(std::span<const Ring> rings, Side side) {
  double left = -INFINITY, right = -INFINITY;
  for (Ring ring : rings) {
    if (side == Side::kRight)
      for (Vec2& p : ring) p.y() = -p.y();
    for (const Vec2& p : ring) left = std::max(left, p.y()), right = std::max(right, -p.y());
    add_edges(ring);
  }
  straight_width_ = left + right;
}

void SweptOutline::add_edges(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &from = ring[i], &to = ring[(i + 1) % ring.size()];
    const double length = (to - from).norm();
    const Vec2 along = (to - from) / length;
    edges_.push_back({from, to, along, perpendicular(along), length});
  }
  ring_end_.push_back(edges_.size());
}

bool SweptOutline::contains_center(double radius) const {
  std::size_t i = 0;
  for (const std::size_t end : ring_end_) {
    bool is_inside = false;
    for (; i < end; ++i) {
      const auto& [from, to, along, normal, length] = edges_[i];
      if ((from.x() > 0.0) == (to.x() > 0.0)) continue;
      is_inside ^= from.y() - from.x() * (along.y() / along.x()) > radius;
    }
    if (is_inside) return true;
  }
  return false;
}

// Infinite where an end of the side is nearer than what lies between its ends.
double SweptOutline::beyond_side(const Edge& side, double radius) const {
  const double foot = side.along.dot(Vec2(0.0, radius) - side.from);
  if (foot < 0.0 || foot > side.length) return INFINITY;
  const double c = side.normal.dot(side.from);
  const double sign = side.normal.y() * radius < c ? -1.0 : 1.0;
  return (sign * side.normal.y() - 1.0) * radius - sign * c;
}

SweptOutline::Bounds SweptOutline::bounds(double radius) const {
  Bounds found;
  double farthest = -INFINITY, nearest = INFINITY;
  const bool is_inside = contains_center(radius);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const double corner = beyond_point(edges_[i].from, radius);
    if (corner > farthest) farthest = corner, found.outer = i;
    if (is_inside) continue;
    if (corner < nearest) nearest = corner, found.inner_corner = i, found.inner_side = kNone;
    const double side = beyond_side(edges_[i], radius);
    if (side < nearest) nearest = side, found.inner_corner = kNone, found.inner_side = i;
  }
  return found;
}

double SweptOutline::inner_beyond(const Bounds& bounds, double radius) const {
  if (bounds.inner_corner != kNone) return beyond_point(edges_[bounds.inner_corner].from, radius);
  return bounds.inner_side == kNone ? -radius : beyond_side(edges_[bounds.inner_side], radius);
}

SweptAnnulus SweptOutline::annulus(double radius) const {
  const Bounds found = bounds(radius);
  return {std::max(0.0, radius + inner_beyond(found, radius)), radius + beyond_point(edges_[found.outer].from, radius)};
}

double SweptOutline::width(double radius) const {
  const Bounds found = bounds(radius);
  return beyond_point(edges_[found.outer].from, radius) - inner_beyond(found, radius);
}

}  // namespace arcway::internal

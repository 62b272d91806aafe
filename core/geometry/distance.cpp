#include "core/geometry/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "arcway/angle.h"
#include "core/base/infinity.h"
#include "core/geometry/predicates.h"
#include "core/geometry/ray_parity.h"

namespace arcway::internal {
namespace {

template <class Visitor>
void for_each_edge(const Polygon& polygon, Visitor&& visit) {
  const auto visit_ring = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) visit(LineSegment{ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]});
  };
  visit_ring(polygon.outer);
  for (const Ring& hole : polygon.holes) visit_ring(hole);
}

bool contains(const Polygon& polygon, const Vec2& p) {
  RayParity parity(p);
  for_each_edge(polygon, [&](const LineSegment& edge) { parity.add(edge.a, edge.b); });
  return parity.location() != PointLocation::kOutside;
}

double distance_if_disjoint(const LineSegment& s, const LineSegment& t) {
  return std::min(std::min(distance(s.a, t), distance(s.b, t)), std::min(distance(t.a, s), distance(t.b, s)));
}

}  // namespace

Vec2 closest_point(const Vec2& p, const LineSegment& s) {
  const Vec2 along = s.b - s.a;
  const double from_a = along.dot(p - s.a);
  const double from_b = along.dot(p - s.b);
  if (from_a <= 0.0) return s.a;
  if (from_b >= 0.0) return s.b;
  // From the nearer end, so that the rounding is relative to the distance from it.
  if (from_a <= -from_b) return s.a + (from_a / along.squaredNorm()) * along;
  return s.b + (from_b / along.squaredNorm()) * along;
}

double distance(const Vec2& p, const LineSegment& s) {
  if (on_segment(p, s)) return 0.0;
  const Vec2 along = s.b - s.a;
  if (along.dot(p - s.a) <= 0.0) return (p - s.a).norm();
  if (along.dot(p - s.b) >= 0.0) return (p - s.b).norm();
  // The cross product does not round the foot first; the smallest double keeps "0 only if on s".
  const Vec2& near = (p - s.a).squaredNorm() <= (p - s.b).squaredNorm() ? s.a : s.b;
  return std::max(std::abs(cross(along, p - near)) / along.norm(), std::numeric_limits<double>::min());
}

double distance(const LineSegment& s, const LineSegment& t) {
  return relate(s, t) == SegmentRelation::kDisjoint ? distance_if_disjoint(s, t) : 0.0;
}

double distance(const Vec2& p, const Polygon& polygon) {
  if (contains(polygon, p)) return 0.0;
  double least = kInfinity;
  for_each_edge(polygon, [&](const LineSegment& edge) { least = std::min(least, distance(p, edge)); });
  return least;
}

double distance(const Polygon& a, const Polygon& b) {
  // With no edges that meet, one vertex tells whether a polygon lies in the other; each contains
  // the other's outer ring whole or not at all.
  if (contains(b, a.outer.front()) || contains(a, b.outer.front())) return 0.0;
  double least = kInfinity;
  for_each_edge(a, [&](const LineSegment& s) {
    for_each_edge(b, [&](const LineSegment& t) {
      if (least > 0.0) least = std::min(least, distance(s, t));
    });
  });
  return least;
}

double distance(const LineSegment& s, std::span<const Vec2, 4> quad) {
  if (intersects(s, quad)) return 0.0;
  double least = kInfinity;
  for (std::size_t i = 0; i < 4; ++i) {
    least = std::min(least, distance_if_disjoint(s, {quad[i], quad[(i + 1) % 4]}));
  }
  return least;
}

Vec2 CircularArc::point_at(double angle) const { return center + radius * direction_of(start_angle + angle); }

bool CircularArc::covers(double direction) const {
  const double turn = wrap_positive(sweep >= 0.0 ? direction - start_angle : start_angle - direction);
  return turn <= std::abs(sweep);
}

double distance(const CircularArc& arc, const Vec2& p) {
  const Vec2 from_center = p - arc.center;
  if (arc.covers(std::atan2(from_center.y(), from_center.x()))) return std::abs(from_center.norm() - arc.radius);
  return std::min((p - arc.start()).norm(), (p - arc.end()).norm());
}

double distance(const CircularArc& arc, const LineSegment& s) {
  double least = std::min(distance(arc, s.a), distance(arc, s.b));
  const double length = (s.b - s.a).norm();
  if (length == 0.0) return least;
  least = std::min({least, distance(arc.start(), s), distance(arc.end(), s)});

  const Vec2 along = (s.b - s.a) / length;
  const Vec2 to_center = arc.center - s.a;
  const double foot = to_center.dot(along);
  const double height = cross(along, to_center);  // of the center over the line
  if (foot >= 0.0 && foot <= length && height != 0.0) {
    const Vec2 to_line = -height * perpendicular(along);
    if (arc.covers(std::atan2(to_line.y(), to_line.x()))) {
      least = std::min(least, std::abs(std::abs(height) - arc.radius));
    }
  }
  if (std::abs(height) > arc.radius) return least;
  const double half_chord = std::sqrt((arc.radius - height) * (arc.radius + height));
  for (const double station : {foot - half_chord, foot + half_chord}) {
    if (station < 0.0 || station > length) continue;
    const Vec2 from_center = (station - foot) * along - height * perpendicular(along);
    if (arc.covers(std::atan2(from_center.y(), from_center.x()))) return 0.0;
  }
  return least;
}

}  // namespace arcway::internal

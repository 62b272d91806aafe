#include "core/zones/speed_zones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "arcway/angle.h"
#include "core/geometry/distance.h"
#include "core/geometry/ray_parity.h"

namespace arcway::internal {

namespace {

// Share of the map's size by which limits hold longer than their zone. Rounding of crossings is some 1e-15 of it.
constexpr double kCapMargin = 1e-9;
// Share of an edge by which it counts as longer, so that a crossing near its end is found on one edge at least.
// Crossings too many do no harm.
constexpr double kEdgeSlack = 1e-9;

constexpr double kNoCap = std::numeric_limits<double>::infinity();

// A closed box around all places of F.
Box box_around(const PathSegment& segment) {
  Box box;
  box.extend(segment.start.position());
  if (segment.is_line()) {
    box.extend(segment.end().position());
    return box;
  }
  const double radius = 1.0 / segment.curvature;
  const Vec2 center = segment.start.position() + radius * perpendicular(direction_of(segment.start.heading));
  const Vec2 reach = Vec2::Constant(std::min(2.0 * std::abs(radius), segment.length));
  box.min = (segment.start.position() - reach).cwiseMax(center - Vec2::Constant(std::abs(radius)));
  box.max = (segment.start.position() + reach).cwiseMin(center + Vec2::Constant(std::abs(radius)));
  return box;
}

bool is_on(double part) { return part >= -kEdgeSlack && part <= 1.0 + kEdgeSlack; }

void cross_line(const PathSegment& line, const LineSegment& edge, std::vector<double>& crossings) {
  const Vec2 ahead = sign_of(line.gear) * direction_of(line.start.heading), along = edge.b - edge.a;
  const Vec2 to_edge = edge.a - line.start.position();
  const double area = cross(ahead, along);
  if (area != 0.0 && is_on(cross(to_edge, ahead) / area)) crossings.push_back(cross(to_edge, along) / area);
}

// Where the circle of an arc meets the line of the edge.
void cross_arc(const PathSegment& arc, const LineSegment& edge, std::vector<double>& crossings) {
  const double radius = 1.0 / std::abs(arc.curvature), side = arc.curvature > 0.0 ? 1.0 : -1.0;
  const Vec2 inwards = side * perpendicular(direction_of(arc.start.heading));
  const Vec2 center = arc.start.position() + radius * inwards, along = edge.b - edge.a;
  const double length = along.norm();
  const Vec2 unit = along / length;
  const double foot = unit.dot(center - edge.a), away = cross(unit, center - edge.a);
  const double half = std::sqrt(std::max(0.0, (radius - away) * (radius + away)));
  if (std::abs(away) > radius * (1.0 + kEdgeSlack)) return;
  for (const double at : {foot - half, foot + half}) {
    if (!is_on(at / length)) continue;
    const Vec2 from_center = edge.a + at * unit - center;
    const double angle = side * sign_of(arc.gear) * std::atan2(cross(-inwards, from_center), -inwards.dot(from_center));
    for (double turn = angle < 0.0 ? angle + kTwoPi : angle; turn * radius < arc.length; turn += kTwoPi)
      crossings.push_back(turn * radius);
  }
}

}  // namespace

std::shared_ptr<const SpeedZones> SpeedZones::of(const World& world) {
  const bool has_limits = std::ranges::any_of(
      world.zones(), [](const Zone& zone) { return std::holds_alternative<SpeedLimit>(zone.rule); });
  return has_limits ? std::make_shared<const SpeedZones>(world.zones()) : nullptr;
}

SpeedZones::SpeedZones(std::span<const Zone> zones) {
  std::vector<Box> edge_boxes, zone_boxes;
  Box all;
  for (std::uint32_t i = 0; i < zones.size(); ++i) {
    const Zone& zone = zones[i];
    const auto* limit = std::get_if<SpeedLimit>(&zone.rule);
    if (limit == nullptr) continue;
    const auto first = static_cast<std::uint32_t>(edges_.size());
    add_ring(zone.area.outer);
    for (const Ring& hole : zone.area.holes) add_ring(hole);
    limits_.push_back({first, static_cast<std::uint32_t>(edges_.size()), limit->max_speed, i});
    Box box;
    for (const Vec2& p : zone.area.outer) box.extend(p);
    zone_boxes.push_back(box);
    all.extend(box);
  }
  for (const LineSegment& edge : edges_) edge_boxes.push_back(box_of(edge));
  if (limits_.empty()) return;
  edge_tree_ = BoxTree(edge_boxes);
  zone_tree_ = BoxTree(zone_boxes);
  margin_ = kCapMargin * std::max(all.max.cwiseAbs().maxCoeff(), all.min.cwiseAbs().maxCoeff());
}

void SpeedZones::add_ring(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) edges_.push_back({ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]});
}

double SpeedZones::cap_at(const Vec2& point) const {
  const Limit* lowest = lowest_at(point);
  return lowest == nullptr ? kNoCap : lowest->speed;
}

SpeedZones::Disc SpeedZones::disc_around(const Vec2& point) const {
  const Limit* lowest = lowest_at(point);
  if (lowest == nullptr) return {kNoCap, 0.0};
  double nearest = kNoCap;
  for (std::uint32_t e = lowest->first; e < lowest->last; ++e) nearest = std::min(nearest, distance(point, edges_[e]));
  return {lowest->speed, nearest};
}

std::uint32_t SpeedZones::zone_at(const Vec2& point) const {
  const Limit* lowest = lowest_at(point);
  return lowest == nullptr ? kNone : lowest->zone;
}

const SpeedZones::Limit* SpeedZones::lowest_at(const Vec2& point) const {
  const Limit* lowest = nullptr;
  zone_tree_.visit_overlaps(Box{point, point}, [&](std::uint32_t i) {
    const Limit& limit = limits_[i];
    if (lowest != nullptr && limit.speed >= lowest->speed) return true;
    RayParity parity(point);
    for (std::uint32_t e = limit.first; e < limit.last; ++e) parity.add(edges_[e].a, edges_[e].b);
    if (parity.location() != PointLocation::kOutside) lowest = &limit;
    return true;
  });
  return lowest;
}

void SpeedZones::find_crossings(const PathSegment& segment, std::vector<double>& crossings) const {
  edge_tree_.visit_overlaps(box_around(segment), [&](std::uint32_t e) {
    segment.is_line() ? cross_line(segment, edges_[e], crossings) : cross_arc(segment, edges_[e], crossings);
    return true;
  });
  std::erase_if(crossings, [&](double s) { return !(s > 0.0 && s < segment.length); });
  crossings.push_back(segment.length);
  std::ranges::sort(crossings);
}

void SpeedZones::cut(const PathSegment& segment, std::vector<Stretch>& stretches) const {
  stretches.clear();
  const bool is_outside = zone_tree_.visit_overlaps(box_around(segment), [](std::uint32_t) { return false; });
  if (is_outside) return stretches.push_back({segment.length, kNoCap});
  std::vector<double> crossings;
  find_crossings(segment, crossings);
  double from = 0.0;
  for (const double to : crossings) {
    // Parts within the margin have the limit of a neighbor.
    if (to - from <= margin_ && to < segment.length) continue;
    const double cap = cap_at(segment.at(0.5 * (from + to)).position());
    if (stretches.empty() || stretches.back().cap != cap) {
      // The lower one of two limits begins sooner, or ends later.
      const double shift = stretches.empty()            ? 0.0
                           : cap < stretches.back().cap ? -std::min(margin_, 0.5 * stretches.back().length)
                                                        : std::min(margin_, 0.5 * (to - from));
      if (!stretches.empty()) stretches.back().length += shift;
      stretches.push_back({to - from - shift, cap});
    } else {
      stretches.back().length += to - from;
    }
    from = to;
  }
}

void cut(std::span<const PathSegment> path, const SpeedZones& zones, CappedPath& capped) {
  capped.segments.clear();
  capped.caps.clear();
  capped.first.clear();
  std::vector<SpeedZones::Stretch> stretches;
  for (const PathSegment& segment : path) {
    capped.first.push_back(static_cast<std::uint32_t>(capped.segments.size()));
    zones.cut(segment, stretches);
    double along = 0.0;
    for (const SpeedZones::Stretch& stretch : stretches) {
      capped.segments.push_back(segment);
      if (along > 0.0) capped.segments.back().start = segment.at(along);
      capped.segments.back().length = stretch.length;
      capped.caps.push_back(stretch.cap);
      along += stretch.length;
    }
  }
  capped.first.push_back(static_cast<std::uint32_t>(capped.segments.size()));
}

}  // namespace arcway::internal

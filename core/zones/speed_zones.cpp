#include "core/zones/speed_zones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory_resource>
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

// Number of crossings of a segment up to which no memory is asked for.
constexpr std::size_t kUsualCrossings = 16;

constexpr double kNoCap = std::numeric_limits<double>::infinity();

bool is_on(double part) { return part >= -kEdgeSlack && part <= 1.0 + kEdgeSlack; }

// Where F is along a segment. Directions are computed once for all edges.
class Track {
 public:
  explicit Track(const PathSegment& segment)
      : segment_(segment), start_(segment.start.position()), ahead_(direction_of(segment.start.heading)) {
    if (segment.is_line()) return;
    radius_ = 1.0 / std::abs(segment.curvature);
    inwards_ = (segment.curvature > 0.0 ? 1.0 : -1.0) * perpendicular(ahead_);
    center_ = start_ + radius_ * inwards_;
  }

  [[nodiscard]] Vec2 at(double s) const {
    const double along = sign_of(segment_.gear) * s;
    if (segment_.is_line()) return start_ + along * ahead_;
    const double turn = along / radius_;
    return center_ + radius_ * (std::sin(turn) * ahead_ - std::cos(turn) * inwards_);
  }

  // A closed box around all places of F.
  [[nodiscard]] Box box() const {
    Box box;
    box.extend(start_);
    if (segment_.is_line()) {
      box.extend(at(segment_.length));
      return box;
    }
    const Vec2 reach = Vec2::Constant(std::min(2.0 * radius_, segment_.length)), all = Vec2::Constant(radius_);
    box.min = (start_ - reach).cwiseMax(center_ - all);
    box.max = (start_ + reach).cwiseMin(center_ + all);
    return box;
  }

  // Adds where F crosses an edge, in meters from the begin on; some lie outside of the segment.
  void add_crossings(const LineSegment& edge, std::pmr::vector<double>& crossings) const {
    segment_.is_line() ? add_by_line(edge, crossings) : add_by_arc(edge, crossings);
  }

 private:
  void add_by_line(const LineSegment& edge, std::pmr::vector<double>& crossings) const {
    const Vec2 along = edge.b - edge.a, to_edge = edge.a - start_;
    const double area = sign_of(segment_.gear) * cross(ahead_, along);
    if (area != 0.0 && is_on(sign_of(segment_.gear) * cross(to_edge, ahead_) / area))
      crossings.push_back(cross(to_edge, along) / area);
  }

  // Where the circle of an arc meets the line of the edge.
  void add_by_arc(const LineSegment& edge, std::pmr::vector<double>& crossings) const {
    const Vec2 along = edge.b - edge.a;
    const double length = along.norm();
    const Vec2 unit = along / length;
    const double foot = unit.dot(center_ - edge.a), away = cross(unit, center_ - edge.a);
    if (std::abs(away) > radius_ * (1.0 + kEdgeSlack)) return;
    const double half = std::sqrt(std::max(0.0, (radius_ - away) * (radius_ + away)));
    for (const double at : {foot - half, foot + half}) {
      if (!is_on(at / length)) continue;
      const Vec2 from_center = edge.a + at * unit - center_;
      const double angle = sign_of(segment_.gear) * std::atan2(from_center.dot(ahead_), -from_center.dot(inwards_));
      for (double turn = angle < 0.0 ? angle + kTwoPi : angle; turn * radius_ < segment_.length; turn += kTwoPi)
        crossings.push_back(turn * radius_);
    }
  }

  const PathSegment& segment_;
  Vec2 start_, ahead_;                         // ahead in the direction of the heading, whatever the gear
  double radius_ = 0.0;                        // of an arc
  Vec2 inwards_{0.0, 0.0}, center_{0.0, 0.0};  // of an arc, at its start
};

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

void SpeedZones::cut(const PathSegment& segment, std::vector<Stretch>& stretches) const {
  stretches.clear();
  const Track track(segment);
  const Box box = track.box();
  const bool is_outside = zone_tree_.visit_overlaps(box, [](std::uint32_t) { return false; });
  if (is_outside) return stretches.push_back({segment.length, kNoCap});
  std::array<std::byte, 2 * kUsualCrossings * sizeof(double)> buffer;
  std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size());
  std::pmr::vector<double> crossings(&memory);
  crossings.reserve(kUsualCrossings);
  edge_tree_.visit_overlaps(box, [&](std::uint32_t e) {
    track.add_crossings(edges_[e], crossings);
    return true;
  });
  std::erase_if(crossings, [&](double s) { return !(s > 0.0 && s < segment.length); });
  crossings.push_back(segment.length);
  std::ranges::sort(crossings);
  double from = 0.0;
  for (const double to : crossings) {
    // Parts within the margin have the limit of a neighbor.
    if (to - from <= margin_ && to < segment.length) continue;
    const double cap = cap_at(track.at(0.5 * (from + to)));
    // A segment that was cut before begins before the border by the margin, but for rounding,
    if (stretches.size() == 1 && from <= 2.0 * margin_ && cap < stretches.back().cap) {
      stretches.clear();
      from = 0.0;
    }
    // or ends behind it.
    const bool is_within_margin = to - from <= 2.0 * margin_ && !stretches.empty() && stretches.back().cap < cap;
    if (stretches.empty() || (stretches.back().cap != cap && !is_within_margin)) {
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

#include "core/validate/zone_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace arcway::internal {

namespace {

constexpr int kBisections = 100;     // more than a double has digits
constexpr double kSameTime = 1e-12;  // share of a duration that rounding may change

double time_with_top(const SegmentSpeeds& speeds, double top) {
  const double v1 = speeds.in, v3 = speeds.out, a = speeds.acceleration;
  const double ramps = (top * top - 0.5 * (v1 * v1 + v3 * v3)) / a;
  return (2.0 * top - v1 - v3) / a + std::max(0.0, speeds.length - ramps) / top;
}

double distance_to(const Vec2& p, const LineSegment& edge) {
  const Vec2 along = edge.b - edge.a;
  const double part = std::clamp((p - edge.a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - edge.a - part * along).norm();
}

}  // namespace

double SegmentSpeeds::at(double s) const {
  const double up = std::sqrt(in * in + 2.0 * acceleration * s);
  const double down = std::sqrt(out * out + 2.0 * acceleration * std::max(0.0, length - s));
  return std::min({up, down, top});
}

double SegmentSpeeds::fastest_between(double s0, double s1) const {
  return std::clamp(0.5 * length + (out - in) * (out + in) / (4.0 * acceleration), s0, s1);
}

double top_speed_within(const SegmentSpeeds& speeds, double duration) {
  const double reached =
      std::sqrt(speeds.acceleration * speeds.length + 0.5 * (speeds.in * speeds.in + speeds.out * speeds.out));
  double high = std::max({speeds.in, speeds.out, std::min(speeds.top, reached)});
  if (!(high > 0.0) || duration <= time_with_top(speeds, high) * (1.0 + kSameTime)) return high;
  double low = std::max(speeds.in, speeds.out);
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (time_with_top(speeds, middle) > duration ? low : high) = middle;
  }
  return high;
}

ZoneCheck::ZoneCheck(const Polygon& area) {
  const auto add = [this](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) edges_.push_back({ring[i], ring[(i + 1) % ring.size()]});
  };
  add(area.outer);
  for (const Ring& hole : area.holes) add(hole);
}

double ZoneCheck::depth(const Vec2& point) const {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (const LineSegment& edge : edges_) {
    nearest = std::min(nearest, distance_to(point, edge));
    if ((edge.a.y() > point.y()) == (edge.b.y() > point.y())) continue;
    const double x = edge.a.x() + (point.y() - edge.a.y()) / (edge.b.y() - edge.a.y()) * (edge.b.x() - edge.a.x());
    if (point.x() < x) inside = !inside;
  }
  return inside ? nearest : -nearest;
}

std::optional<double> ZoneCheck::too_fast(const PathSegment& segment, const SegmentSpeeds& speeds, double limit) const {
  std::vector<std::pair<double, double>> parts{{0.0, segment.length}};
  while (!parts.empty()) {
    const auto [s0, s1] = parts.back();
    parts.pop_back();
    const double fastest = speeds.fastest_between(s0, s1);
    if (speeds.at(fastest) <= limit) continue;
    const double middle = 0.5 * (s0 + s1), half = 0.5 * (s1 - s0), inside = depth(segment.at(middle).position());
    if (inside <= -half) continue;
    if (inside >= half + kBorder) return fastest;
    if (half < 0.25 * kBorder) continue;
    parts.emplace_back(middle, s1);
    parts.emplace_back(s0, middle);
  }
  return std::nullopt;
}

// The distance from an edge is convex along the chord, and the arc is nowhere further from the chord than its height.
bool ZoneCheck::is_along_border(const PathSegment& segment, double s0, double s1) const {
  const double height = std::abs(segment.curvature) * (s1 - s0) * (s1 - s0) / 8.0;
  const Vec2 from = segment.at(s0).position(), to = segment.at(s1).position();
  return std::ranges::any_of(edges_, [&](const LineSegment& edge) {
    return std::max(distance_to(from, edge), distance_to(to, edge)) + height <= kBorder;
  });
}

std::optional<double> ZoneCheck::against(const PathSegment& segment, double heading, double most) const {
  if (!(segment.length > 0.0)) return std::nullopt;  // no motion
  const double turned = segment.gear == Gear::kForward ? 0.0 : std::numbers::pi;
  std::vector<std::pair<double, double>> parts{{0.0, segment.length}};
  while (!parts.empty()) {
    const auto [s0, s1] = parts.back();
    parts.pop_back();
    const double middle = 0.5 * (s0 + s1), half = 0.5 * (s1 - s0);
    const Pose pose = segment.at(middle);
    const double off = std::abs(std::remainder(pose.heading + turned - heading, 2.0 * std::numbers::pi));
    if (off + half * std::abs(segment.curvature) <= most) continue;
    const double inside = depth(pose.position());
    if (off > most && inside > kBorder) return middle;
    if (inside + half <= kBorder || is_along_border(segment, s0, s1)) continue;
    if (half < 0.25 * kBorder) continue;
    parts.emplace_back(middle, s1);
    parts.emplace_back(s0, middle);
  }
  return std::nullopt;
}

}  // namespace arcway::internal

#include "core/zones/one_way_zones.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "arcway/angle.h"
#include "core/geometry/distance.h"
#include "core/geometry/ray_parity.h"

namespace arcway::internal {

namespace {

constexpr double kBorder = OneWayZones::kBorder;

// The direction of motion of a body.
double direction_in(Gear gear, double heading) { return gear == Gear::kForward ? heading : heading + kPi; }

Box box_around(const Vec2& center, double radius) {
  return {center - Vec2::Constant(radius), center + Vec2::Constant(radius)};
}

// Appends where a line is kBorder away from the line of an edge, or from the edge's first end.
void append_crossings(const Vec2& from, const Vec2& ahead, const LineSegment& edge, std::vector<double>& places) {
  const Vec2 along = (edge.b - edge.a).normalized();
  const double away = cross(along, from - edge.a), leaving = cross(along, ahead);
  if (leaving != 0.0)
    for (const double depth : {-kBorder, kBorder}) places.push_back((depth - away) / leaving);
  const double foot = ahead.dot(edge.a - from), aside = cross(ahead, edge.a - from);
  const double half = (kBorder - aside) * (kBorder + aside);
  if (half >= 0.0)
    for (const double place : {foot - std::sqrt(half), foot + std::sqrt(half)}) places.push_back(place);
}

// Appends the directions from the center of a circle in which it is kBorder away from the line of an edge, or from the
// edge's first end.
void append_crossings(const DrivenCircle& circle, const LineSegment& edge, std::vector<double>& angles) {
  const Vec2 along = edge.b - edge.a, to_end = edge.a - circle.center;
  const double angle = std::atan2(along.y(), along.x()), away = cross(along.normalized(), -to_end);
  for (const double depth : {-kBorder, kBorder}) {
    const double sine = (depth - away) / circle.radius;
    if (std::abs(sine) > 1.0) continue;
    angles.push_back(angle + std::asin(sine));
    angles.push_back(angle + kPi - std::asin(sine));
  }
  // Half of the angle that the disc around the end takes, from its sine: the cosine has no digits left.
  const double distance = to_end.norm(), apart = distance - circle.radius;
  const double square = (kBorder - apart) * (kBorder + apart) / (4.0 * distance * circle.radius);
  if (!(square >= 0.0 && square <= 1.0)) return;
  const double half = 2.0 * std::asin(std::sqrt(square)), end = std::atan2(to_end.y(), to_end.x());
  angles.push_back(end - half);
  angles.push_back(end + half);
}

}  // namespace

std::shared_ptr<const OneWayZones> OneWayZones::of(const World& world) {
  auto zones = std::make_shared<const OneWayZones>(world.zones());
  return zones->areas_.empty() ? nullptr : zones;
}

OneWayZones::OneWayZones(std::span<const Zone> zones) {
  std::vector<Box> boxes;
  for (std::uint32_t i = 0; i < zones.size(); ++i) {
    const Zone& zone = zones[i];
    const auto* rule = std::get_if<OneWay>(&zone.rule);
    if (rule == nullptr || rule->tolerance >= kPi) continue;
    const auto first = static_cast<std::uint32_t>(edges_.size());
    add_ring(zone.area.outer);
    for (const Ring& hole : zone.area.holes) add_ring(hole);
    areas_.push_back(
        {first, static_cast<std::uint32_t>(edges_.size()), rule->heading, rule->tolerance + kSameDirection, i});
    Box box;
    for (const Vec2& p : zone.area.outer) box.extend(p);
    boxes.push_back(box);
  }
  if (!boxes.empty()) tree_ = BoxTree(boxes);
}

bool OneWayZones::Area::allows(double direction) const { return std::abs(wrap_signed(direction - heading)) <= most; }

void OneWayZones::add_ring(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) edges_.push_back({ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]});
}

std::span<const LineSegment> OneWayZones::edges_of(const Area& area) const {
  return std::span(edges_).subspan(area.first, area.last - area.first);
}

// Whether a point is deeper inside than kBorder.
bool OneWayZones::has_inside(const Area& area, const Vec2& p) const {
  RayParity parity(p);
  for (const LineSegment& edge : edges_of(area)) {
    if (distance(p, edge) <= kBorder) return false;
    parity.add(edge.a, edge.b);
  }
  return parity.location() == PointLocation::kInside;
}

// How far a line of this length leads until it is inside; nothing if it does not get there.
std::optional<double> OneWayZones::entry(const Area& area, const Pose& from, double length) const {
  const Vec2 ahead = direction_of(from.heading);
  std::vector<double> places{0.0, length};
  for (const LineSegment& edge : edges_of(area)) append_crossings(from.position(), ahead, edge, places);
  std::erase_if(places, [&](double s) { return !(s >= 0.0 && s <= length); });
  std::ranges::sort(places);
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    if (has_inside(area, from.position() + 0.5 * (places[i] + places[i + 1]) * ahead)) return places[i];
  return std::nullopt;
}

bool OneWayZones::allows_line(const Pose& from, double length, Gear gear) const {
  if (!(length > 0.0)) return true;
  const double direction = direction_in(gear, from.heading);
  Box box{from.position(), from.position()};
  box.extend(from.position() + length * direction_of(from.heading));
  return tree_.visit_overlaps(
      box, [&](std::uint32_t i) { return areas_[i].allows(direction) || !entry(areas_[i], from, length); });
}

bool OneWayZones::are_near(const Vec2& center, double radius) const {
  return !tree_.visit_overlaps(box_around(center, radius), [](std::uint32_t) { return false; });
}

void OneWayZones::append_forbidden(const DrivenCircle& circle, std::vector<HeadingInterval>& forbidden) const {
  tree_.visit_overlaps(box_around(circle.center, circle.radius), [&](std::uint32_t i) {
    find_forbidden(areas_[i], circle, forbidden);
    return true;
  });
}

void OneWayZones::find_forbidden(const Area& area, const DrivenCircle& circle,
                                 std::vector<HeadingInterval>& forbidden) const {
  const double ahead = sign_of(circle.side) * 0.5 * kPi;  // from the direction of F to the heading of the body
  std::vector<double> headings;
  for (const LineSegment& edge : edges_of(area)) append_crossings(circle, edge, headings);
  for (double& angle : headings) angle = wrap_positive(angle + ahead);
  for (const double most : {-area.most, area.most})
    headings.push_back(wrap_positive(direction_in(circle.gear, area.heading + most)));
  std::ranges::sort(headings);
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const double low = headings[i], high = i + 1 < headings.size() ? headings[i + 1] : headings[0] + kTwoPi;
    const double middle = 0.5 * (low + high);
    if (area.allows(direction_in(circle.gear, middle))) continue;
    if (has_inside(area, circle.center + circle.radius * direction_of(middle - ahead)))
      forbidden.push_back({low, high});
  }
}

double OneWayZones::allowed_length(const PathSegment& motion, Gear driven) const {
  double allowed = motion.length;
  if (motion.is_line()) {
    const double direction = direction_in(driven, motion.start.heading);
    const Pose from{motion.start.x, motion.start.y, direction_in(motion.gear, motion.start.heading)};
    Box box{from.position(), from.position()};
    box.extend(motion.end().position());
    tree_.visit_overlaps(box, [&](std::uint32_t i) {
      if (areas_[i].allows(direction)) return true;
      if (const std::optional<double> place = entry(areas_[i], from, allowed)) allowed = *place;
      return true;
    });
    return allowed;
  }
  const Side side = motion.curvature > 0.0 ? Side::kLeft : Side::kRight;
  const double radius = 1.0 / std::abs(motion.curvature);
  const Vec2 center =
      motion.start.position() + sign_of(side) * radius * perpendicular(direction_of(motion.start.heading));
  std::vector<HeadingInterval> forbidden;
  append_forbidden({center, radius, side, driven}, forbidden);
  const double turning = sign_of(side) * sign_of(motion.gear);
  for (const HeadingInterval& interval : forbidden) {
    const bool begins_inside = wrap_positive(motion.start.heading - interval.low) < interval.high - interval.low;
    const double turn = turning > 0.0 ? wrap_positive(interval.low - motion.start.heading)
                                      : wrap_positive(motion.start.heading - interval.high);
    allowed = begins_inside ? 0.0 : std::min(allowed, turn * radius);
    if (begins_inside) break;
  }
  return allowed;
}

std::uint32_t OneWayZones::zone_against(const Pose& pose, Gear gear) const {
  std::uint32_t against = kNone;
  tree_.visit_overlaps(Box{pose.position(), pose.position()}, [&](std::uint32_t i) {
    const Area& area = areas_[i];
    if (!area.allows(direction_in(gear, pose.heading)) && has_inside(area, pose.position()))
      against = std::min(against, area.zone);
    return true;
  });
  return against;
}

std::vector<std::uint32_t> OneWayZones::zones() const {
  std::vector<std::uint32_t> zones;
  for (const Area& area : areas_) zones.push_back(area.zone);
  return zones;
}

}  // namespace arcway::internal

#include "arcway/vehicle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/base/shortest_text.h"
#include "core/model/swept_widths.h"

namespace arcway {

using namespace internal;
namespace {

void require(bool holds, std::string_view name, double value, std::string_view limit) {
  if (holds) return;
  throw std::invalid_argument("vehicle: " + std::string(name) + " is " + shortest_text(value) + ", must be " +
                              std::string(limit));
}

void require_positive(double value, std::string_view name) {
  require(value >= kSmallestVehicleNumber && value <= kLargestVehicleNumber, name, value,
          "from " + shortest_text(kSmallestVehicleNumber) + " to " + shortest_text(kLargestVehicleNumber));
}

void require_steering_angle(double value, std::string_view name) {
  require(value >= kSmallestVehicleNumber && value < 0.5 * std::numbers::pi, name, value,
          ">= " + shortest_text(kSmallestVehicleNumber) + " and < pi/2 rad");
}

double radius_by_angle(const VehicleParameters& p, double angle) {
  const double radius = p.wheelbase / std::tan(angle);
  return p.steering == Steering::kSymmetric ? 0.5 * radius : radius;
}

// Share by which a turning radius and a steering angle may differ that are given both.
constexpr double kSameRadius = 1e-6;

void require_same(double angle, std::string_view angle_name, double radius, std::string_view radius_name,
                  const VehicleParameters& p) {
  const double by_angle = radius_by_angle(p, angle);
  if (std::abs(radius - by_angle) <= kSameRadius * radius) return;
  throw std::invalid_argument("vehicle: " + std::string(radius_name) + " is " + shortest_text(radius) + ", but " +
                              std::string(angle_name) + " of " + shortest_text(angle) + " leads to " +
                              shortest_text(by_angle) + " m; give one of the two");
}

// The limits of steering by side: as angles or as radii.
void check_sides(const VehicleParameters& p) {
  if (p.max_steering_angle_right) require_steering_angle(*p.max_steering_angle_right, "max_steering_angle_right");
  if (!p.min_turning_radius && p.min_turning_radius_right)
    throw std::invalid_argument("vehicle: min_turning_radius_right is " + shortest_text(*p.min_turning_radius_right) +
                                " without min_turning_radius; give both, or max_steering_angle_right instead");
  if (!p.min_turning_radius) return;
  require_positive(*p.min_turning_radius, "min_turning_radius");
  if (p.min_turning_radius_right) require_positive(*p.min_turning_radius_right, "min_turning_radius_right");
  if (p.max_steering_angle != VehicleParameters{}.max_steering_angle)
    require_same(p.max_steering_angle, "max_steering_angle", *p.min_turning_radius, "min_turning_radius", p);
  if (p.max_steering_angle_right)
    require_same(*p.max_steering_angle_right, "max_steering_angle_right",
                 p.min_turning_radius_right.value_or(*p.min_turning_radius), "min_turning_radius_right", p);
}

void check(const ConstantTurnSpeed& law) { require_positive(law.speed, "turn_speed.speed"); }

void check(const LateralAccelerationLimit& law) {
  require_positive(law.lateral_acceleration, "turn_speed.lateral_acceleration");
}

void check(const TurnSpeedTable& law) {
  if (law.entries.empty()) throw std::invalid_argument("vehicle: turn_speed.entries has 0 entries, must have >= 1");
  double previous = 0.0;
  for (std::size_t i = 0; i < law.entries.size(); ++i) {
    const auto& [radius, speed] = law.entries[i];
    const std::string entry = "turn_speed.entries[" + std::to_string(i) + "]";
    require(std::isfinite(radius) && radius > previous, entry + ".radius", radius,
            "finite and > " + shortest_text(previous));
    require_positive(speed, entry + ".speed");
    previous = radius;
  }
}

// The rectangle by its axles, about F at `offset` from the middle between them.
Footprint rectangle_of(const VehicleParameters& p, double offset) {
  const double half_width = 0.5 * p.width;
  if (!p.front_overhang) {
    const double a = 0.5 * p.length;
    return {a - offset, a + offset, half_width, half_width};
  }
  const double half = 0.5 * p.wheelbase;
  return {half - offset + *p.front_overhang, half + offset + *p.rear_overhang, half_width, half_width};
}

Footprint footprint_of(const Box& box) { return {box.max.x(), -box.min.x(), box.max.y(), -box.min.y()}; }

void check_overhangs(const VehicleParameters& p) {
  if (p.front_overhang.has_value() != p.rear_overhang.has_value())
    throw std::invalid_argument(std::string("vehicle: ") + (p.front_overhang ? "rear" : "front") +
                                "_overhang is missing, give both overhangs or neither");
  if (!p.front_overhang) return;
  const auto require_finite = [](double value, std::string_view name) {
    require(std::abs(value) <= kLargestVehicleNumber, name, value,
            "of a magnitude up to " + shortest_text(kLargestVehicleNumber));
  };
  require_finite(*p.front_overhang, "front_overhang");
  require_finite(*p.rear_overhang, "rear_overhang");
  require_positive(p.wheelbase + *p.front_overhang + *p.rear_overhang, "front_overhang + wheelbase + rear_overhang");
}

void check_footprint(const VehicleParameters& p) {
  if (p.front_overhang) throw std::invalid_argument("vehicle: both footprint and overhangs are given, leave one out");
  for (const double value : {p.footprint_origin.x(), p.footprint_origin.y()})
    require(std::abs(value) <= kLargestVehicleNumber, "footprint_origin", value,
            "of a magnitude up to " + shortest_text(kLargestVehicleNumber));
}

std::vector<Ring> about_reference(std::vector<Ring> rings, const Vec2& origin) {
  for (Ring& ring : rings)
    for (Vec2& p : ring) p += origin;
  return rings;
}

double speed_by(const ConstantTurnSpeed& law, double /*radius*/) { return law.speed; }

double speed_by(const LateralAccelerationLimit& law, double radius) {
  return std::sqrt(law.lateral_acceleration) * std::sqrt(radius);
}

double speed_by(const TurnSpeedTable& law, double radius) {
  const auto& entries = law.entries;
  if (radius <= entries.front().first) return entries.front().second;
  if (radius >= entries.back().first) return entries.back().second;
  const auto above = std::upper_bound(entries.begin(), entries.end(), radius,
                                      [](double r, const auto& entry) { return r < entry.first; });
  const auto below = above - 1;
  return std::lerp(below->second, above->second, (radius - below->first) / (above->first - below->first));
}

double speed_by(const TurnSpeedLaw& law, double radius) {
  return std::visit([radius](const auto& kind) { return speed_by(kind, radius); }, law);
}

/// Reaches of a body from F along its axis as turning sees them.
struct Reach {
  double far;  ///< to the farther end
  double gap;  ///< from F to the nearer end; 0 while F lies on the body
};
Reach reach_of(const Footprint& body) {
  return {std::max(body.front, body.rear), std::max(0.0, -std::min(body.front, body.rear))};
}

/// The radius from which on the swept width falls. Below, the nearest point of the body is not the inner corner or
/// side that recedes with the radius.
double widest_radius(const Reach& reach, double half_width) {
  return half_width * ((reach.far + reach.gap) / (reach.far - reach.gap));
}

/// How much further a body reaches to a side than to both sides from its middle. Turned to that side by a radius, it
/// sweeps what it sweeps from a point in its middle by a radius that is smaller by so much.
double off_middle(const Footprint& body, Side side) { return 0.5 * (body.beside(side) - body.beside(opposite(side))); }

/// w_s - 2b by the radius of the body's middle. The differences are rationalised: they cancel at large radii.
double excess_width(const Footprint& body, double radius) {
  const double b = 0.5 * body.width();
  if (radius < b) return swept_annulus({body.front, body.rear, b, b}, Side::kLeft, std::abs(radius)).width() - 2.0 * b;
  const auto [far, gap] = reach_of(body);
  const double outer = far * (far / (std::hypot(far, radius + b) + (radius + b)));
  return gap == 0.0 ? outer : outer - gap * (gap / (std::hypot(gap, radius - b) + (radius - b)));
}

}  // namespace

bool Body::covers(const Vec2& point) const {
  if (shape == nullptr) return Box{{-rear, -right}, {front, left}}.contains(point);
  return std::ranges::any_of(shape->pieces, [&](const Ring& piece) {
    for (std::size_t i = 0; i < piece.size(); ++i)
      if (cross(piece[(i + 1) % piece.size()] - piece[i], point - piece[i]) < 0.0) return false;
    return true;
  });
}

std::optional<Vec2> rotation_center(double wheelbase, double front_angle, double rear_angle) {
  const double front = std::tan(front_angle);
  const double rear = std::tan(rear_angle);
  const double t = front - rear;
  if (t == 0.0) return std::nullopt;
  return Vec2{-0.5 * wheelbase * ((front + rear) / t), wheelbase / t};
}

// A shape and what was grown of it. Pointers to these stay valid.
struct Vehicle::Shapes {
  explicit Shapes(BodyShape s) : shape(std::move(s)) {}

  const GrownBody* grown(double margin) const {
    const std::lock_guard lock(mutex);
    return &by_margin.try_emplace(margin, shape, margin).first->second;
  }

  const SweptWidths& swept_widths(Side side) const {
    const std::lock_guard lock(mutex);
    auto& widths = side == Side::kLeft ? swept_left : swept_right;
    if (!widths) widths.emplace(shape.parts(), side);
    return *widths;
  }

  BodyShape shape;
  mutable std::mutex mutex;
  mutable std::map<double, GrownBody> by_margin;
  mutable std::optional<SweptWidths> swept_left, swept_right;
};

Vehicle::Vehicle(VehicleParameters parameters) : parameters_(std::move(parameters)) {
  const VehicleParameters& p = parameters_;
  require_positive(p.length, "length");
  require_positive(p.width, "width");
  require_positive(p.wheelbase, "wheelbase");
  require_steering_angle(p.max_steering_angle, "max_steering_angle");
  check_sides(p);
  require_positive(p.max_speed, "max_speed");
  std::visit([](const auto& law) { check(law); }, p.turn_speed);
  if (p.max_reverse_speed) require_positive(*p.max_reverse_speed, "max_reverse_speed");
  require_positive(p.max_acceleration, "max_acceleration");
  require_positive(p.safety_margin, "safety_margin");
  check_overhangs(p);
  // What others take the place of is the default, so that vehicles are the same if their bodies are.
  if (p.front_overhang || !p.footprint.empty()) parameters_.length = VehicleParameters{}.length;
  if (!p.footprint.empty()) parameters_.width = VehicleParameters{}.width;
  box_ = rectangle_of(p, reference_offset());
  if (p.footprint.empty()) return;
  check_footprint(p);
  BodyShape shape(about_reference(p.footprint, p.footprint_origin));
  box_ = footprint_of(shape.bounds());
  if (!shape.is_rectangle()) shapes_ = std::make_shared<const Shapes>(std::move(shape));
}

double Vehicle::reference_offset() const {
  switch (parameters_.steering) {
    case Steering::kFront:
      return -0.5 * parameters_.wheelbase;
    case Steering::kRear:
      return 0.5 * parameters_.wheelbase;
    case Steering::kSymmetric:
      break;
  }
  return 0.0;
}

double Vehicle::min_turning_radius(Side side) const {
  const VehicleParameters& p = parameters_;
  const bool is_left = side == Side::kLeft;
  if (p.min_turning_radius)
    return is_left ? *p.min_turning_radius : p.min_turning_radius_right.value_or(*p.min_turning_radius);
  return radius_by_angle(p, is_left ? p.max_steering_angle : p.max_steering_angle_right.value_or(p.max_steering_angle));
}

double Vehicle::steering_angle(double curvature) const {
  switch (parameters_.steering) {
    case Steering::kFront:
      return std::atan(parameters_.wheelbase * curvature);
    case Steering::kRear:
      return -std::atan(parameters_.wheelbase * curvature);
    case Steering::kSymmetric:
      return std::atan(0.5 * parameters_.wheelbase * curvature);
  }
  return 0.0;
}

Footprint Vehicle::footprint(double growth) const {
  return shapes_ ? footprint_of(shapes_->grown(growth)->bounds) : box_.grown(growth);
}

Body Vehicle::body(double growth) const& {
  Body body = footprint(growth);
  if (shapes_) body.shape = shapes_->grown(growth);
  return body;
}

const BodyShape* Vehicle::shape() const { return shapes_ ? &shapes_->shape : nullptr; }

std::vector<Ring> Vehicle::outline() const {
  if (shapes_) return {shapes_->shape.parts().begin(), shapes_->shape.parts().end()};
  return {Polygon::rectangle(-box_.rear, -box_.right, box_.front, box_.left).outer};
}

std::vector<Ring> Vehicle::outline(const Pose& pose) const {
  const Vec2 ahead = direction_of(pose.heading);
  std::vector<Ring> rings = outline();
  for (Ring& ring : rings)
    for (Vec2& p : ring) p = pose.position() + p.x() * ahead + p.y() * perpendicular(ahead);
  return rings;
}

double Vehicle::turn_speed(double radius) const {
  return std::min(speed_by(parameters_.turn_speed, radius), max_speed());
}

double Vehicle::reverse_turn_speed(double radius) const {
  return std::min(speed_by(parameters_.turn_speed, radius), max_reverse_speed());
}

Vehicle Vehicle::with_gears_swapped() const {
  Vehicle swapped = *this;
  swapped.parameters_.max_speed = max_reverse_speed();
  swapped.parameters_.max_reverse_speed = max_speed();
  return swapped;
}

bool Vehicle::fits_straight(double gap_width) const { return gap_width > box_.width(); }

SweptAnnulus Vehicle::swept_annulus(Side side, double radius, double growth) const {
  if (!shapes_) return arcway::swept_annulus(box_.grown(growth), side, radius);
  return SweptOutline(shapes_->grown(growth)->pieces, side).annulus(radius);
}

bool Vehicle::fits_turn(double gap_width, double radius, Side side) const {
  if (shapes_) return gap_width > shapes_->swept_widths(side).at(radius);
  const Footprint body = footprint();
  return gap_width - box_.width() > excess_width(body, radius - off_middle(body, side));
}

std::vector<RadiusRange> Vehicle::fitting_radii(double gap_width, Side side) const {
  const double least = min_turning_radius(side);
  if (shapes_) return shapes_->swept_widths(side).below(gap_width, least);
  const Footprint body = footprint();
  if (least - off_middle(body, side) < widest_radius(reach_of(body), 0.5 * body.width()))
    return SweptWidths(outline(), side).below(gap_width, least);
  const std::optional<double> smallest = smallest_fitting_radius(gap_width, side);
  if (!smallest) return {};
  return {{*smallest, std::numeric_limits<double>::infinity()}};
}

std::optional<double> Vehicle::smallest_fitting_radius(double gap_width, Side side) const {
  if (shapes_) {
    const std::vector<RadiusRange> ranges = fitting_radii(gap_width, side);
    if (ranges.empty() || std::isfinite(ranges.back().high)) return std::nullopt;
    return ranges.back().low;
  }
  if (!fits_straight(gap_width)) return std::nullopt;
  const Footprint body = footprint();
  const double off = off_middle(body, side);  // radii below are those of the body's middle
  const Reach reach = reach_of(body);
  const double b = 0.5 * body.width();
  const double lowest = min_turning_radius(side) - off;
  const double widest = std::max(lowest, widest_radius(reach, b));
  if (gap_width - box_.width() > excess_width(body, widest)) return min_turning_radius(side);
  // hypot(A, r + b) - hypot(g, r - b) = D, squared twice; the larger root is the one beyond the widest radius.
  const double d = gap_width;
  const double spare = d - box_.width();
  double radius = 0.0;
  if (reach.gap == 0.0) {
    radius = 0.5 * (reach.far * (reach.far / spare) - d);
  } else {
    const double g = reach.gap;
    const double squares = (reach.far - g) * (reach.far + g);
    const double half_k = 0.5 * (squares - d * d);
    const double square_coefficient = spare * (d + box_.width());
    const double linear = b * squares;
    const double constant = (d * std::hypot(g, b) - half_k) * (d * std::hypot(g, b) + half_k);
    const double discriminant = linear * linear - square_coefficient * constant;
    radius = (linear + std::sqrt(std::max(0.0, discriminant))) / square_coefficient;
  }
  return std::max(radius, widest) + off;
}

SweptAnnulus swept_annulus(const Footprint& footprint, Side side, double radius) {
  const auto [far, gap] = reach_of(footprint);
  // How far the sides lie from the center: towards it, and away from it.
  const double towards = radius - footprint.beside(side), away = radius + footprint.beside(opposite(side));
  const double inner = std::max({0.0, towards, -away}), outer = std::max(away, -towards);
  return {gap == 0.0 ? inner : std::hypot(gap, inner), std::hypot(far, outer)};
}

std::string to_string(Steering steering) {
  switch (steering) {
    case Steering::kFront:
      return "front";
    case Steering::kRear:
      return "rear";
    case Steering::kSymmetric:
      return "symmetric";
  }
  return "unknown";
}

namespace {

std::string turns_text(const Vehicle& vehicle) {
  const double left = vehicle.min_turning_radius(Side::kLeft), right = vehicle.min_turning_radius(Side::kRight);
  if (left == right) return rounded_text(left) + " m";
  return rounded_text(left) + " m to the left and " + rounded_text(right) + " m to the right";
}

}  // namespace

std::string to_string(const Vehicle& vehicle) {
  const VehicleParameters& p = vehicle.parameters();
  const Footprint box = vehicle.footprint();
  std::string body;
  if (const BodyShape* shape = vehicle.shape()) {
    std::size_t corners = 0;
    for (const Ring& part : shape->parts()) corners += part.size();
    const std::size_t parts = shape->parts().size();
    body = std::to_string(corners) + " corners" + (parts > 1 ? " in " + std::to_string(parts) + " parts, " : ", ");
  }
  return body + rounded_text(box.length()) + " m x " + rounded_text(box.width()) + " m, " + to_string(p.steering) +
         " steering, turning radius " + turns_text(vehicle) + ", " + rounded_text(p.max_speed) + " m/s, " +
         rounded_text(p.max_acceleration) + " m/s^2";
}

}  // namespace arcway

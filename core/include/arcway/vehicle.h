#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "arcway/body_shape.h"
#include "arcway/export.h"
#include "arcway/path.h"
#include "arcway/polygon.h"
#include "arcway/text.h"
#include "arcway/vec2.h"

namespace arcway {

/// Which axle steers. The reference point F, whose velocity is along the body, lies on the other axle. If both steer,
/// it lies at the center.
enum class Steering { kFront, kRear, kSymmetric };
/// "front", "rear" or "symmetric".
ARCWAY_API std::string to_string(Steering steering);

/// Speed on arcs: one value for all radii [m/s].
struct ConstantTurnSpeed {
  double speed;
  friend bool operator==(const ConstantTurnSpeed&, const ConstantTurnSpeed&) = default;
};
/// Speed on arcs [m/s]: min(max_speed, sqrt(lateral_acceleration * radius)).
struct LateralAccelerationLimit {
  double lateral_acceleration;  ///< [m/s^2]
  friend bool operator==(const LateralAccelerationLimit&, const LateralAccelerationLimit&) = default;
};
/// Speed on arcs: linear between pairs (radius [m], speed [m/s]) of ascending radius, constant beyond both ends.
struct TurnSpeedTable {
  std::vector<std::pair<double, double>> entries;
  friend bool operator==(const TurnSpeedTable&, const TurnSpeedTable&) = default;
};
using TurnSpeedLaw = std::variant<ConstantTurnSpeed, LateralAccelerationLimit, TurnSpeedTable>;

/// A rectangle along the heading, by how far it reaches from the reference point F [m]: the body, or what bounds it. A
/// reach is negative where F lies off it.
struct Footprint {
  double front;  ///< reach ahead of F
  double rear;   ///< reach behind F
  double left;   ///< reach to the left of F
  double right;  ///< reach to the right of F
  [[nodiscard]] double length() const { return front + rear; }
  [[nodiscard]] double width() const { return left + right; }
  /// The reach to one side.
  [[nodiscard]] double beside(Side side) const { return side == Side::kLeft ? left : right; }
  /// Whether F lies on the body.
  [[nodiscard]] bool covers_reference() const { return std::min(front, rear) >= 0.0 && std::min(left, right) >= 0.0; }
  /// The distance of the farthest corner from F.
  [[nodiscard]] double farthest() const { return std::hypot(std::max(front, rear), std::max(left, right)); }
  /// The body grown by `growth` [m] on every side.
  [[nodiscard]] Footprint grown(double growth) const {
    return {front + growth, rear + growth, left + growth, right + growth};
  }
  /// The body as it is seen when it is turned by pi about F.
  [[nodiscard]] Footprint reversed() const { return {rear, front, right, left}; }
};

/// The annulus about the rotation center that the body sweeps when it turns [m].
struct SweptAnnulus {
  double inner;  ///< rho_in; 0 if the center lies in the body
  double outer;  ///< rho_out
  [[nodiscard]] double width() const { return outer - inner; }
};
/// Turning radii from `low` to `high` [m]; `high` may be infinite.
struct RadiusRange {
  double low;
  double high;
};

/// The body as queries are asked about it: a rectangle, or a shape and the rectangle that bounds it.
struct ARCWAY_API Body : Footprint {
  Body() = default;
  /// A rectangle.
  Body(const Footprint& rectangle) : Footprint(rectangle) {}
  Body(double front_reach, double rear_reach, double left_reach, double right_reach)
      : Footprint{front_reach, rear_reach, left_reach, right_reach} {}
  /// Whether a point about F belongs to the body, by the signs of rounded areas.
  [[nodiscard]] bool covers(const Vec2& point) const;
  [[nodiscard]] bool covers_reference() const { return covers(Vec2(0.0, 0.0)); }
  /// None: the rectangle. It belongs to the vehicle that gave the body, and lives as long as any copy of that.
  const GrownBody* shape = nullptr;
};

/// The instantaneous center of rotation in the body frame, (1) [m].
/// @param wheelbase  [m]; the angles are the wheels' [rad].
/// @return nothing if tan(front_angle) == tan(rear_angle): the vehicle drives straight.
ARCWAY_API std::optional<Vec2> rotation_center(double wheelbase, double front_angle, double rear_angle);

/// The range of a vehicle's numbers, far enough from the ends of the doubles for all that is computed from them.
inline constexpr double kSmallestVehicleNumber = 1e-50, kLargestVehicleNumber = 1e50;

/// The numbers of a vehicle. The defaults are the paper's robot.
struct VehicleParameters {
  double length = 1.5;     ///< 2a [m]
  double width = 0.8;      ///< 2b [m]
  double wheelbase = 1.3;  ///< l [m]; each axle is l/2 from the body's center
  Steering steering = Steering::kFront;
  double max_steering_angle = 0.78539816339744831;   ///< gamma [rad], in (0, pi/2); to the left, if the sides differ
  double max_speed = 12.0;                           ///< v_ms [m/s]
  TurnSpeedLaw turn_speed = ConstantTurnSpeed{8.0};  ///< v_mc(rho), at most v_ms
  std::optional<double> max_reverse_speed = {};      ///< in place of v_ms when driving backwards [m/s]; none: v_ms
  double max_acceleration = 50.0;                    ///< a_max, driving and braking [m/s^2]
  /// Paths pass vertices at this distance from the body, and keep the body at least half of it away from every obstacle
  /// [m], > 0.
  double safety_margin = 1e-3;
  /// Reach of the body ahead of the front axle and behind the rear axle [m], both or none; negative if an axle lies off
  /// the body. They take the place of `length`.
  std::optional<double> front_overhang = {}, rear_overhang = {};
  /// The body as one or several simple polygons [m], in place of length, width and overhangs: see BodyShape. They are
  /// about F, or about another origin.
  std::vector<Ring> footprint = {};
  /// The place of the origin of `footprint` about F [m]. Where the polygons are about a base link that lies 0.3 m ahead
  /// of F, it is (0.3, 0).
  Vec2 footprint_origin = Vec2(0.0, 0.0);
  /// gamma to the right [rad], in (0, pi/2); none: as to the left.
  std::optional<double> max_steering_angle_right = {};
  /// rho_min [m], in place of what wheelbase and steering angles lead to; to the left, if the sides differ. The
  /// wheelbase still says where F lies. A steering angle given as well must lead to the same radius.
  std::optional<double> min_turning_radius = {};
  /// rho_min to the right [m]; none: as to the left.
  std::optional<double> min_turning_radius_right = {};
  /// What KeepOut::vehicles calls the vehicle; empty: no name, so that only keep-outs for all vehicles hold.
  std::string name = {};
  friend bool operator==(const VehicleParameters&, const VehicleParameters&) = default;
};

/// A car-like robot, which may turn more tightly to one side than to the other, with the paper's equations (1) and (5)
/// to (7) as functions. Immutable, thread-safe.
class ARCWAY_API Vehicle {
 public:
  /// @throws std::invalid_argument naming the parameter, its value and its limit.
  explicit Vehicle(VehicleParameters parameters = {});

  [[nodiscard]] const VehicleParameters& parameters() const { return parameters_; }
  /// The x of F, and of the rotation center, in the body frame [m]: -l/2, +l/2 or 0 by steering.
  [[nodiscard]] double reference_offset() const;
  /// rho_min of turns to a side [m]: as given, else l / tan(gamma), or l / (2 tan(gamma)) if symmetric.
  [[nodiscard]] double min_turning_radius(Side side) const;
  /// rho_min [m], the smaller one of both sides.
  [[nodiscard]] double min_turning_radius() const {
    return std::min(min_turning_radius(Side::kLeft), min_turning_radius(Side::kRight));
  }
  /// The angle of the steered axle that drives this curvature [1/m], of each if both steer [rad]. Left is positive at
  /// the front.
  [[nodiscard]] double steering_angle(double curvature) const;
  /// The rectangle that bounds the body about F, grown by `growth` [m] on every side.
  [[nodiscard]] Footprint footprint(double growth = 0.0) const;
  /// The body about F, grown by `growth` [m]. Its shape belongs to this vehicle and its copies.
  [[nodiscard]] Body body(double growth = 0.0) const&;
  Body body(double growth = 0.0) const&& = delete;
  /// The shape of a body that is no rectangle, else null.
  [[nodiscard]] const BodyShape* shape() const;
  /// The outline of the body about F: its parts, counter-clockwise [m].
  [[nodiscard]] std::vector<Ring> outline() const;
  /// The outline where F stands at a pose, rounded, as for pictures [m].
  [[nodiscard]] std::vector<Ring> outline(const Pose& pose) const;

  [[nodiscard]] double max_speed() const { return parameters_.max_speed; }
  [[nodiscard]] double max_acceleration() const { return parameters_.max_acceleration; }
  [[nodiscard]] double safety_margin() const { return parameters_.safety_margin; }
  /// v_mc(radius) [m/s], at most max_speed(). Precondition: radius > 0 [m].
  [[nodiscard]] double turn_speed(double radius) const;
  [[nodiscard]] double max_reverse_speed() const { return parameters_.max_reverse_speed.value_or(max_speed()); }
  /// v_mc(radius) when driving backwards [m/s], at most max_reverse_speed(). Precondition: radius > 0 [m].
  [[nodiscard]] double reverse_turn_speed(double radius) const;
  /// The highest speed in either gear [m/s].
  [[nodiscard]] double top_speed() const { return std::max(max_speed(), max_reverse_speed()); }
  /// The vehicle with the speeds of the two gears exchanged.
  [[nodiscard]] Vehicle with_gears_swapped() const;

  /// (6): whether the vehicle can drive straight through a gap of this width [m], D_min > 2b.
  [[nodiscard]] bool fits_straight(double gap_width) const;
  /// The annulus that the body sweeps in a turn to a side, exact for any body. O(corners). Precondition: radius >= 0.
  /// @param growth  by which the body is grown, as in body() [m].
  [[nodiscard]] SweptAnnulus swept_annulus(Side side, double radius, double growth = 0.0) const;
  /// (7): whether the vehicle can turn with this radius to a side in a gap of this width [m], D_min > w_s(radius).
  [[nodiscard]] bool fits_turn(double gap_width, double radius, Side side) const;
  /// (7) solved: the smallest radius >= min_turning_radius(side) beyond which every radius fits a gap of this width
  /// [m]. Nothing if none does, see (6). Closed form for rectangles, correct to a few units in the last place; for
  /// other bodies the start of the last of fitting_radii().
  [[nodiscard]] std::optional<double> smallest_fitting_radius(double gap_width, Side side) const;
  /// (7) solved in full: all radii >= min_turning_radius(side) that fit a gap of this width, ascending. The swept width
  /// of a body may rise and fall with the radius several times; a bent body may fit a gap in turns that it does not
  /// fit straight. The first call of a side costs O(corners^3), later ones O(corners^2).
  [[nodiscard]] std::vector<RadiusRange> fitting_radii(double gap_width, Side side) const;

  /// Whether all parameters are the same.
  friend bool operator==(const Vehicle& a, const Vehicle& b) { return a.parameters_ == b.parameters_; }

 private:
  struct Shapes;

  VehicleParameters parameters_;
  Footprint box_{};                       // around the body
  std::shared_ptr<const Shapes> shapes_;  // none: the body is the box
};

/// "1.5 m x 0.8 m, front steering, turning radius 1.3 m, 12 m/s, 50 m/s^2".
ARCWAY_API std::string to_string(const Vehicle& vehicle);

/// The annulus of a turn to a side with a radius > 0 [m], (5) with its slips corrected. With h the reach to that side
/// and o to the other one, rho_out is hypot(max(front, rear), max(radius + o, h - radius)). rho_in is radius - h if F
/// lies on the body and h < radius, else the distance of the nearest point of the body; 0 if the center lies in it.
/// Of a body that is no rectangle it contains the swept area: see Vehicle::swept_annulus.
ARCWAY_API SweptAnnulus swept_annulus(const Footprint& footprint, Side side, double radius);

}  // namespace arcway

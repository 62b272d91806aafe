#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "arcway/export.h"
#include "arcway/vec2.h"

namespace arcway {

/// Which axle steers. F, the reference point whose velocity is along the body, is on the axle that
/// does not (front: on the rear axle; rear: on the front axle; symmetric: at the center).
enum class Steering { kFront, kRear, kSymmetric };

/// Speed on an arc: one value for all radii [m/s].
struct ConstantTurnSpeed {
  double speed;
  friend bool operator==(const ConstantTurnSpeed&, const ConstantTurnSpeed&) = default;
};
/// Speed on an arc: min(max_speed, sqrt(lateral_acceleration * radius)).
struct LateralAccelerationLimit {
  double lateral_acceleration;  ///< [m/s^2]
  friend bool operator==(const LateralAccelerationLimit&, const LateralAccelerationLimit&) = default;
};
/// Speed on an arc: linear between (radius [m], speed [m/s]) pairs of rising radius, constant beyond both ends.
struct TurnSpeedTable {
  std::vector<std::pair<double, double>> entries;
  friend bool operator==(const TurnSpeedTable&, const TurnSpeedTable&) = default;
};
using TurnSpeedLaw = std::variant<ConstantTurnSpeed, LateralAccelerationLimit, TurnSpeedTable>;

/// A rectangle around the reference point F, heading along +x [m].
struct Footprint {
  double front;       ///< reach ahead of F
  double rear;        ///< reach behind F
  double half_width;  ///< reach to either side
};

/// Position of the instantaneous center of rotation in the body frame, (1).
/// @returns nothing if tan(front_angle) == tan(rear_angle): the vehicle drives straight.
ARCWAY_API std::optional<Vec2> rotation_center(double wheelbase, double front_angle, double rear_angle);

/// Of all numbers of a vehicle: far enough from the ends of the doubles for all that is computed from them.
inline constexpr double kSmallestVehicleNumber = 1e-50, kLargestVehicleNumber = 1e50;

/// The defaults are the paper's robot.
struct VehicleParameters {
  double length = 1.5;     ///< 2a [m]
  double width = 0.8;      ///< 2b [m]
  double wheelbase = 1.3;  ///< l [m]; the axles are l/2 from the body's center
  Steering steering = Steering::kFront;
  double max_steering_angle = 0.78539816339744831;   ///< gamma [rad], in (0, pi/2)
  double max_speed = 12.0;                           ///< v_ms [m/s]
  TurnSpeedLaw turn_speed = ConstantTurnSpeed{8.0};  ///< v_mc(rho), at most v_ms
  std::optional<double> max_reverse_speed = {};      ///< in place of v_ms where it drives backwards; none: v_ms [m/s]
  double max_acceleration = 50.0;                    ///< a_max, driving and braking [m/s^2]
  /// Every path keeps the body at least half of this from every obstacle; paths round vertices at this distance. [m], >
  /// 0
  double safety_margin = 1e-3;
  friend bool operator==(const VehicleParameters&, const VehicleParameters&) = default;
};

/// A rectangular car-like robot: the paper's equations (1) and (5) to (7) as functions. Immutable, thread-safe.
class ARCWAY_API Vehicle {
 public:
  /// @throws std::invalid_argument naming the parameter, its value and its limit.
  explicit Vehicle(VehicleParameters parameters = {});

  [[nodiscard]] const VehicleParameters& parameters() const { return parameters_; }
  /// x of F (and of the rotation center) in the body frame: -l/2, +l/2 or 0 by steering.
  [[nodiscard]] double reference_offset() const;
  /// rho_min: l / tan(gamma), or l / (2 tan(gamma)) if symmetric.
  [[nodiscard]] double min_turning_radius() const;
  /// The body about F, grown by `growth` on every side.
  [[nodiscard]] Footprint footprint(double growth = 0.0) const;

  [[nodiscard]] double max_speed() const { return parameters_.max_speed; }
  [[nodiscard]] double max_acceleration() const { return parameters_.max_acceleration; }
  [[nodiscard]] double safety_margin() const { return parameters_.safety_margin; }
  /// v_mc(radius), never above v_ms. radius > 0.
  [[nodiscard]] double turn_speed(double radius) const;
  [[nodiscard]] double max_reverse_speed() const { return parameters_.max_reverse_speed.value_or(max_speed()); }
  /// v_mc(radius), never above max_reverse_speed().
  [[nodiscard]] double reverse_turn_speed(double radius) const;
  /// No speed of the vehicle is higher, in either gear.
  [[nodiscard]] double top_speed() const { return std::max(max_speed(), max_reverse_speed()); }
  /// The vehicle that drives forwards as fast as this one backwards, and the other way round.
  [[nodiscard]] Vehicle with_gears_swapped() const;

  /// (6): whether a passage of this width lets the vehicle go straight, D_min > 2b.
  [[nodiscard]] bool fits_straight(double gap_width) const;
  /// (7): whether a passage of this width lets it turn with this radius, D_min > w_s(radius).
  [[nodiscard]] bool fits_turn(double gap_width, double radius) const;
  /// (7) solved: the smallest radius >= min_turning_radius beyond which every radius fits a passage of this width;
  /// nothing if none does, (6). Closed form, to a few units in the last place.
  [[nodiscard]] std::optional<double> smallest_fitting_radius(double gap_width) const;

  /// Whether all parameters are the same.
  friend bool operator==(const Vehicle&, const Vehicle&) = default;

 private:
  VehicleParameters parameters_;
};

/// Annulus about the rotation center that the body sweeps when turning with a radius [m].
struct SweptAnnulus {
  double inner;  ///< rho_in; 0 if the center lies in the body
  double outer;  ///< rho_out
  [[nodiscard]] double width() const { return outer - inner; }
};
/// rho_out = hypot(max(front, rear), radius + half_width); rho_in = radius - half_width while F lies
/// on the body, else the distance to the nearer corner. (5) with the slips mended. radius > 0.
ARCWAY_API SweptAnnulus swept_annulus(const Footprint& footprint, double radius);

}  // namespace arcway

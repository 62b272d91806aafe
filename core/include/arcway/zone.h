#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "arcway/export.h"
#include "arcway/polygon.h"
#include "arcway/text.h"

namespace arcway {

/// A zone that vehicles may not enter with any point of their bodies. It is an obstacle for them.
struct KeepOut {
  /// Names of the vehicles that it is for: VehicleParameters::name. Empty: all vehicles.
  std::vector<std::string> vehicles = {};
  /// Whether it is an obstacle for the vehicle of a name.
  [[nodiscard]] ARCWAY_API bool is_for(std::string_view vehicle) const;
  friend bool operator==(const KeepOut&, const KeepOut&) = default;
};

/// A zone in which vehicles drive slowly: while F is in it, border included, the speed is at most max_speed.
struct SpeedLimit {
  double max_speed;  ///< in either gear [m/s], > 0
  friend bool operator==(const SpeedLimit&, const SpeedLimit&) = default;
};

/// A zone that vehicles drive in one direction only. While F is inside, and moves, its direction of motion differs from
/// `heading` by at most `tolerance`. In reverse, the direction of motion is opposite to the body's heading. The border
/// is not inside: a path along it has any direction.
struct OneWay {
  double heading;    ///< counter-clockwise from +x, from -2 pi to 2 pi [rad]
  double tolerance;  ///< to either side, from 0 to pi [rad]; pi allows all directions
  friend bool operator==(const OneWay&, const OneWay&) = default;
};

/// A zone in which vehicles keep a distance from obstacles where that pays: ClearancePreference, as far as F is in the
/// zone, border included. Costs of zones that overlap, and that of the planner's own preference, add up.
struct KeepClear {
  double distance;  ///< by which the body is grown [m], above 0 and at most ClearancePreference::kMost
  double cost;      ///< of driving close [s/m], from 0 to ClearancePreference::kMost; 0: measured only
  friend bool operator==(const KeepClear&, const KeepClear&) = default;
};

/// What a zone asks of vehicles.
using ZoneRule = std::variant<KeepOut, SpeedLimit, OneWay, KeepClear>;

/// A part of the map with a rule for vehicles. Zones may overlap, nest, and cover obstacles; all rules hold.
struct Zone {
  Polygon area;           ///< checked as an obstacle's polygon is, see World
  ZoneRule rule = {};     ///< what holds in it
  std::string name = {};  ///< for messages; need not be unique
};

/// The role of a zone in map files: "keepout", "speed_limit", "one_way" or "clearance".
ARCWAY_API const char* role_of(const Zone& zone);

/// "keepout zone \"dock\"", or "zone 3 (keepout)" without a name.
/// @param index  among the zones of a world.
ARCWAY_API std::string zone_text(const Zone& zone, std::size_t index);

/// Thrown for a zone that World refuses.
class ARCWAY_API ZoneError : public std::invalid_argument {
 public:
  ZoneError(const std::string& message, std::size_t zone) : std::invalid_argument(message), zone_(zone) {}
  /// Index of the zone at fault.
  [[nodiscard]] std::size_t zone() const { return zone_; }

 private:
  std::size_t zone_;
};

}  // namespace arcway

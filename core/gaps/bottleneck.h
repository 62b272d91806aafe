#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/base/stop_clock.h"
#include "core/gaps/vehicle_gaps.h"
#include "core/geometry/vec2.h"
#include "core/model/path.h"
#include "core/model/vehicle.h"
#include "core/model/world.h"

namespace [[gnu::visibility("default")]] arcway {

/// The narrowest place of the widest way between two poses, and what the vehicle takes.
struct Bottleneck {
  double width = 0.0;           ///< 0: obstacles that meet, or one that lies all around a pose, leave no way at all [m]
  double needed = 0.0;          ///< see widest_hopeless_gap [m]
  double needed_to_turn = 0.0;  ///< swept width of the tightest turn, (7), with the safety margin [m]
  ObstacleId obstacle_a = 0, obstacle_b = 0;  ///< on both sides; may be the same
  Vec2 on_a{0.0, 0.0}, on_b{0.0, 0.0};        ///< where they are nearest to each other
  [[nodiscard]] bool too_narrow() const { return width < needed; }
  /// "the widest way narrows to 0.52 m between obstacle 3 at (1, 2) and the bounds at (1, 2.52)".
  [[nodiscard]] std::string text(const World& world) const;
};

/// "obstacle 17" or "the bounds".
std::string region_text(const World& world, ObstacleId region);
/// A length as people read it: to a millimetre, without trailing zeros.
std::string rounded_text(double metres);

/// Finds bottlenecks on one map for one vehicle. Thread-safe.
class BottleneckFinder {
 public:
  BottleneckFinder(const World& world, const Vehicle& vehicle);
  /// @param gaps  of the same map and vehicle, known to others as well.
  BottleneckFinder(const World& world, const Vehicle& vehicle, std::shared_ptr<const VehicleGaps> gaps);

  /// Nothing if the widest way is wide enough for the tightest turn, or as wide as the room around one of the poses.
  /// Precondition: the body grown by half of the safety margin is free at both poses.
  /// Time as GapMap::bottleneck, where the gaps were asked for before.
  /// @param clock  ends the search: then nothing.
  [[nodiscard]] std::optional<Bottleneck> operator()(const Pose& from, const Pose& to,
                                                     const StopClock& clock = {}) const;

 private:
  World world_;
  Footprint body_;
  Bottleneck vehicle_takes_;  // no place yet
  std::shared_ptr<const VehicleGaps> gaps_;
};

}  // namespace arcway

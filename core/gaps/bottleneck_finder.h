#pragma once

#include <memory>
#include <optional>
#include <string>

#include "arcway/bottleneck.h"
#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "core/base/shortest_text.h"
#include "core/gaps/vehicle_gaps.h"

namespace arcway::internal {

/// "obstacle 17" or "the bounds".
std::string region_text(const World& world, ObstacleId region);

/// Finds bottlenecks on one map for one vehicle. Thread-safe.
class BottleneckFinder {
 public:
  BottleneckFinder(const World& world, const Vehicle& vehicle);
  /// @param gaps  of the same map and vehicle, shared with other users.
  BottleneckFinder(const World& world, const Vehicle& vehicle, std::shared_ptr<const VehicleGaps> gaps);

  /// The bottleneck between two poses. Nothing if it is wide enough for the tightest turn, or as wide as the room
  /// around one of the poses. Precondition: the body grown by half of the safety margin is free at both poses. Takes as
  /// long as GapMap::bottleneck, after the first call.
  /// @param clock  may end the search; the result is nothing then.
  [[nodiscard]] std::optional<Bottleneck> operator()(const Pose& from, const Pose& to,
                                                     const StopClock& clock = {}) const;

 private:
  World world_;
  Footprint body_;
  Bottleneck vehicle_takes_;  // widths that the vehicle needs; no place yet
  std::shared_ptr<const VehicleGaps> gaps_;
};

}  // namespace arcway::internal

#pragma once

#include "arcway/stop_clock.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "core/base/late_value.h"
#include "core/gaps/gap_map.h"

namespace arcway::internal {

/// The gaps of a map that are not too wide to matter to a vehicle: what BottleneckFinder and find_gap_circles look at.
/// Found when first asked for. Thread-safe.
class VehicleGaps {
 public:
  /// @param radius  the smallest turning radius of the paths.
  VehicleGaps(const World& world, const Vehicle& vehicle, double radius);

  /// The first call takes as long as GapMap.
  [[nodiscard]] const GapMap& map() const { return *map(StopClock()); }
  /// Nothing if the clock is over before the gaps are known.
  [[nodiscard]] const GapMap* map(const StopClock& clock) const;
  /// Of the vehicle, see widest_hopeless_gap [m].
  [[nodiscard]] double widest_hopeless() const { return hopeless_; }

 private:
  World world_;
  double hopeless_, widest_;
  LateValue<GapMap> map_;
};

/// No motion of the vehicle, forwards or backwards, leads through a gap that is not wider: the body grown by half of
/// the safety margin, less a thousandth for rounding, has a disc of this diameter in its middle [m].
double widest_hopeless_gap(const Vehicle& vehicle);

}  // namespace arcway::internal

#pragma once

#include "arcway/stop_clock.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "core/base/late_value.h"
#include "core/gaps/gap_map.h"
#include "core/model/side_radii.h"

namespace arcway::internal {

/// The gaps of a map up to the largest width that matters to a vehicle, for BottleneckFinder and find_gap_circles.
/// Found when first asked for. Thread-safe.
class VehicleGaps {
 public:
  /// @param radii  the smallest turning radii of the paths.
  VehicleGaps(const World& world, const Vehicle& vehicle, const SideRadii& radii);

  /// The gaps. The first call takes as long as GapMap.
  [[nodiscard]] const GapMap& map() const { return *map(StopClock()); }
  /// The gaps, or null if the clock is over before they are known.
  [[nodiscard]] const GapMap* map(const StopClock& clock) const;
  /// See widest_hopeless_gap [m].
  [[nodiscard]] double widest_hopeless() const { return hopeless_; }

 private:
  World world_;
  double hopeless_, widest_;
  LateValue<GapMap> map_;
};

/// The widest gap that no motion of the vehicle can pass, forwards or backwards [m]. It is the diameter of the largest
/// disc in the body, grown by half of the safety margin, less a thousandth for rounding.
double widest_hopeless_gap(const Vehicle& vehicle);

}  // namespace arcway::internal

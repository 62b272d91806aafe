#include "core/gaps/vehicle_gaps.h"

#include <algorithm>

#include "arcway/sweep_query.h"
#include "core/model/body_size.h"

namespace arcway::internal {

namespace {

constexpr double kProved = 1.0 - 0x1p-10;  // share of the safety margin that proofs count on; the rest is for rounding

}  // namespace

double widest_hopeless_gap(const Vehicle& vehicle) {
  const double disc =
      vehicle.shape() != nullptr ? vehicle.shape()->disc() : std::min(body_length(vehicle), body_width(vehicle));
  return disc + kProved * vehicle.safety_margin();
}

// A turn at a right angle to a wall takes the outer radius of the swept annulus, which is more than its width.
VehicleGaps::VehicleGaps(const World& world, const Vehicle& vehicle, const SideRadii& radii)
    : world_(world), hopeless_(widest_hopeless_gap(vehicle)), widest_(hopeless_) {
  const Footprint grown = vehicle.footprint(vehicle.safety_margin());
  for (const Side side : {Side::kLeft, Side::kRight})
    widest_ = std::max(widest_, swept_annulus(grown, side, radii.of(side)).outer);
}

const GapMap* VehicleGaps::map(const StopClock& clock) const {
  return map_.get(clock, [&] { return GapMap(world_, widest_, clock); });
}

}  // namespace arcway::internal

#include "core/planner/slim_maps.h"

#include <utility>
#include <vector>

#include "arcway/executor.h"

namespace arcway::internal {

namespace {

Vehicle slimmer(const Vehicle& vehicle, double share) {
  VehicleParameters parameters = vehicle.parameters();
  parameters.width *= 1.0 - share;
  parameters.length *= 1.0 - 0.5 * share;
  return Vehicle(std::move(parameters));
}

}  // namespace

const Roadmap* SlimMaps::operator()(std::size_t i, const StopClock& clock) const {
  return maps_[i].get(clock, [&] {
    const Vehicle vehicle = slimmer(map_.vehicle, kSlimmer[i]);
    const std::vector<double> radii{map_.radii.front()};
    FeasibleGraph lazy(map_.world, vehicle, rows_, map_.queries, radii, SerialExecutor(), GraphMode::kLazy);
    Roadmap slim(map_.world, vehicle, map_.queries, radii, std::move(lazy), map_.outlines);
    slim.gaps = map_.gaps;  // the real body gets through no others
    return slim;
  });
}

}  // namespace arcway::internal

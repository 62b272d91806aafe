#include "core/planner/slim_maps.h"

#include <memory>
#include <utility>
#include <vector>

#include "arcway/executor.h"
#include "core/roadmap/lazy_feasible_graph.h"

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
    const Vehicle vehicle = slimmer(map_.vehicle, kSlimBodies[i]);
    const std::vector<double> radii{map_.radii.front()};
    auto lazy = std::make_shared<const LazyFeasibleGraph>(
        FeasibleGraphInputs{map_.world, vehicle, rows_, map_.queries, radii}, SerialExecutor());
    Roadmap slim(map_.world, vehicle, map_.queries, radii, std::move(lazy), map_.outlines);
    slim.gaps = map_.gaps;  // the real body gets through no others
    return slim;
  });
}

}  // namespace arcway::internal

#include "core/planner/slim_maps.h"

#include <memory>
#include <utility>
#include <vector>

#include "arcway/executor.h"
#include "core/roadmap/lazy_feasible_graph.h"

namespace arcway::internal {

Vehicle slimmer(const Vehicle& vehicle, double share) {
  VehicleParameters parameters = vehicle.parameters();
  const Vec2 scale(1.0 - 0.5 * share, 1.0 - share);
  parameters.width *= scale.y();
  parameters.length *= scale.x();
  if (parameters.front_overhang) {
    const double shorter = 0.5 * (1.0 - scale.x()) * vehicle.footprint().length();
    *parameters.front_overhang -= shorter;
    *parameters.rear_overhang -= shorter;
  }
  Box box;
  for (const Ring& ring : parameters.footprint)
    for (const Vec2& p : ring) box.extend(p);
  for (Ring& ring : parameters.footprint)
    for (Vec2& p : ring) p += (scale - Vec2::Ones()).cwiseProduct(p - 0.5 * (box.min + box.max));
  return Vehicle(std::move(parameters));
}

Roadmap roadmap_for(const Vehicle& vehicle, const CircleRadii& radii, const Roadmap& map,
                    const std::shared_ptr<const VisibilityRows>& rows, const StopClock& clock) {
  const SerialExecutor serial;
  const StoppableExecutor executor(serial, clock);  // circles take milliseconds
  auto lazy = std::make_shared<const LazyFeasibleGraph>(
      FeasibleGraphInputs{map.world, vehicle, rows, map.queries, radii}, executor);
  return {map.world, vehicle, map.queries, radii, std::move(lazy), map.outlines, nullptr, clock};
}

const Roadmap* SlimMaps::operator()(std::size_t i, const StopClock& clock) const {
  return maps_[i].get(clock, [&] {
    Roadmap slim = roadmap_for(slimmer(map_.vehicle, kSlimBodies[i]), map_.radii.first(1), map_, rows_, clock);
    slim.gaps = map_.gaps;  // the real body gets through no others
    return slim;
  });
}

}  // namespace arcway::internal

#include "core/collision/path_cost.h"

#include <cstddef>

namespace arcway::internal {

double path_cost(std::span<const PathSegment> path, const Vehicle& vehicle, const PathCosts& costs,
                 SpeedProfile& profile, double enough) {
  const double cost = travel_time(path, vehicle, costs.ends, profile, costs.zones) +
                      costs.cusp_cost * static_cast<double>(cusps_of(path));
  return cost < enough ? cost + clearance_cost(costs.clearance, path) : cost;
}

double path_cost(std::span<const PathSegment> path, const Vehicle& vehicle, const PathCosts& costs) {
  SpeedProfile profile;
  return path_cost(path, vehicle, costs, profile);
}

}  // namespace arcway::internal

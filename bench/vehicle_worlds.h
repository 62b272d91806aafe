#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "arcway/datasets/catalog.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"

namespace arcway::internal::bench {

/// The wall-to-wall turning radius [m]: that of the circle that the body sweeps in its tightest turn.
inline double outer_turning_radius(const Vehicle& vehicle) {
  return swept_annulus(vehicle.footprint(), Side::kLeft, vehicle.min_turning_radius()).outer;
}

/// The factor between worlds for a vehicle and those of the catalog, which are made for the paper's robot: the ratio of
/// their wall-to-wall turning radii. Every vehicle thus has the same number of its turning circles from side to side.
inline double world_scale(const Vehicle& vehicle) {
  return outer_turning_radius(vehicle) / outer_turning_radius(Vehicle());
}

/// A world of the catalog, scaled by world_scale about the origin.
inline World world_for(const Vehicle& vehicle, std::string_view name) {
  MapFile map = catalog_map(name);
  const double scale = world_scale(vehicle);
  const auto enlarge = [scale](Ring& ring) {
    for (Vec2& point : ring) point *= scale;
  };
  for (Polygon& obstacle : map.obstacles) {
    enlarge(obstacle.outer);
    for (Ring& hole : obstacle.holes) enlarge(hole);
  }
  if (map.bounds) enlarge(*map.bounds);
  return to_world(map, name);
}

/// Random pose pairs of the vehicle in its own world, by random_queries: the same for the same arguments.
inline std::vector<PlanRequest> queries_for(const Vehicle& vehicle, const World& world, std::size_t count,
                                            std::uint64_t seed) {
  return random_queries(world, make_reference_queries(world), vehicle, {.count = count, .seed = seed});
}

}  // namespace arcway::internal::bench

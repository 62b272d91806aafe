#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "arcway/export.h"
#include "arcway/planner.h"
#include "arcway/query_set.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"

namespace arcway {

struct RandomQueryParameters {
  std::size_t count = 50;
  double min_distance = 0.3;  ///< between start and goal, as a share of the longer side of the map's box, in [0, 1]
  std::uint64_t seed = 1;
  /// Only pairs between which a disc that fits into the body can move: there is a path of any motion only between such.
  bool passable = false;
};

/// Random pose pairs in the map's box, with the body, grown by the vehicle's safety margin, free at both ends. Uniform
/// in position and heading; the same for the same world, vehicle and parameters. That there is a path is not said, even
/// where a disc can move.
/// @param queries  about `world`; all implementations give the same poses.
/// @throws std::invalid_argument for parameters out of range or a map without extent; std::runtime_error if a pair
///   is not found in 10,000 draws.
ARCWAY_API std::vector<PlanRequest> random_queries(const World& world, const QuerySet& queries, const Vehicle& vehicle,
                                                   const RandomQueryParameters& parameters = {});

}  // namespace arcway

#pragma once

#include <cstddef>
#include <cstdint>

#include "arcway/curved_plan.h"
#include "arcway/export.h"

namespace arcway {

struct CurvedWorldParameters {
  std::size_t curves = 12;
  std::uint64_t seed = 1;
};

/// Disjoint smooth ponds in a square, each a ClosedSpline through 6 to 10 random points, counter-clockwise, without
/// bends tighter than about 2 m; 3 m or more between the circles round them. The points are the same on every platform
/// for the same parameters. The polygons are empty until the curves take their place.
/// @throws std::invalid_argument unless there are 1 to 100,000 curves.
ARCWAY_API CurvedWorld generate_curved_world(const CurvedWorldParameters& parameters);

}  // namespace arcway

#pragma once

#include <memory>

#include "arcway/query_set.h"
#include "arcway/vehicle.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"
#include "core/roadmap/circle_radii.h"

namespace arcway::internal {

/// What a feasible graph is built from.
struct FeasibleGraphInputs {
  World world;
  Vehicle vehicle;
  std::shared_ptr<const VisibilityRows> rows;  ///< of the reduced visibility graph of the world
  QuerySet queries;                            ///< about the world
  CircleRadii radii;                           ///< of the turn circles [m]: positive, ascending, at least one
};

}  // namespace arcway::internal

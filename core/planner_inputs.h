#pragma once

#include "core/planner.h"
#include "core/query/query_set.h"
#include "core/vehicle.h"
#include "core/world.h"

namespace arcway {

/// The options with their radii: those given, ascending, or those of turning_radii.
/// @throws std::invalid_argument as Planner's constructors do.
PlannerOptions checked_options(const World& world, const Vehicle& vehicle, PlannerOptions options);

/// @throws std::invalid_argument if one is missing.
void require_queries(const QuerySet& queries);

}  // namespace arcway

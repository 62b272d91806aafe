#pragma once

#include <string>

#include "arcway/backend.h"
#include "arcway/path.h"
#include "arcway/planner.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "arcway/world_change.h"

namespace arcway::internal {

/// The options with their radii: those given, ascending, or those of turning_radii; and with their suboptimality.
/// @throws std::invalid_argument as Planner's constructors do.
PlannerOptions checked_options(const World& world, const Vehicle& vehicle, PlannerOptions options);

/// @throws std::invalid_argument if the backend is not of this world, as far as vertices tell.
void require_world(const World& world, const Backend& backend);

/// @throws std::invalid_argument if the change does not lead from one to the other, as far as numbers of vertices tell.
void require_change(const WorldChange& change, const World& before, const World& after);

/// @param name  of the pose, for the error.
/// @throws std::invalid_argument naming the pose, the value and the limits of what this vehicle can be planned for.
void require_pose(const std::string& name, const Pose& pose, const Vehicle& vehicle);

/// The same pose with its heading within a turn of 0 if it has so many that its rounding would show at the end of a
/// path. With fewer it stays as it is, since its size tells how far it is rounded.
/// @param distance  from start to goal [m].
Pose without_many_turns(const Pose& pose, double distance);

}  // namespace arcway::internal

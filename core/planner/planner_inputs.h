#pragma once

#include <span>
#include <string>
#include <vector>

#include "arcway/backend.h"
#include "arcway/path.h"
#include "arcway/planner.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "arcway/world_change.h"

namespace arcway::internal {

/// The options with radii and suboptimality filled in: the given radii, ascending, or those of turning_radii.
/// @throws std::invalid_argument as Planner's constructors do.
PlannerOptions checked_options(const World& world, const Vehicle& vehicle, PlannerOptions options);

/// The backend of the world that a vehicle meets: the given one, or that after the change to this world.
/// @param given  of `world` or of `closed`.
/// @param closed  World::for_vehicle of `world`.
/// @throws std::invalid_argument if it is of neither, as far as vertices tell, or cannot be changed where it must.
Backend backend_for(const World& world, const World& closed, const Backend& given);

/// Checks that a change leads from one world to the other, as far as numbers of vertices tell.
/// @throws std::invalid_argument
void require_change(const WorldChange& change, const World& before, const World& after);

/// Checks that two worlds have the same one-way zones, in the same order: lines and headings that were found free stay
/// so after a change only then.
/// @throws std::invalid_argument naming the number of each, or the first that differs.
void require_same_one_way(const World& before, const World& after);

/// The ids of the obstacles with some keys, ascending.
/// @throws std::invalid_argument naming the first key that is of none, or that is there twice.
std::vector<ObstacleId> obstacles_with(const World& world, std::span<const ObstacleKey> keys);

/// Checks that this vehicle can be planned for at a pose.
/// @param name  of the pose, for the error.
/// @throws std::invalid_argument naming the pose, the value and the limits.
void require_pose(const std::string& name, const Pose& pose, const Vehicle& vehicle);

/// Checks that this vehicle can be planned for between the poses of a request.
/// @throws std::invalid_argument naming the first pose, limit or cost at fault.
void require_request(const PlanRequest& request, const PlanLimits& limits, const Vehicle& vehicle);

/// A pose whose heading is reduced to less than a turn from 0, if it has so many turns that its rounding would show at
/// the end of a path. Other headings stay as they are, since their size tells how far they are rounded.
/// @param distance  from start to goal [m].
Pose without_many_turns(const Pose& pose, double distance);

}  // namespace arcway::internal

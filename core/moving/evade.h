#pragma once

#include <span>

#include "arcway/moving_obstacle.h"
#include "arcway/trajectory.h"
#include "core/zones/speed_zones.h"

namespace arcway::internal {

/// As the public function of that name, within the speed limits of zones as well.
/// @param zones  of the map; null: none.
Evasion evade(const Trajectory& trajectory, std::span<const MovingObstacle> obstacles, const EvasionOptions& options,
              const SpeedZones* zones);

}  // namespace arcway::internal

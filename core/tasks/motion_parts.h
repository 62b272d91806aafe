#pragma once

#include <span>
#include <vector>

#include "arcway/path.h"
#include "arcway/trajectory.h"
#include "arcway/vehicle.h"

namespace arcway::internal {

/// What is left of a motion from a moment on.
std::vector<TimedSegment> rest_of(const Trajectory& motion, const TrajectoryState& now);

/// A motion up to a place on it.
std::vector<TimedSegment> begin_of(const Trajectory& motion, const TrajectoryState& there);

/// A motion along the same path that begins with a speed. It is nowhere faster than before, and as fast from where it
/// has caught up on.
/// @param speed  at most that of the motion at its start [m/s].
std::vector<TimedSegment> begun_at(double speed, std::vector<TimedSegment> motion, const Vehicle& vehicle);

/// How long a motion takes [s].
double time_of(std::span<const TimedSegment> motion);

}  // namespace arcway::internal

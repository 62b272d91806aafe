#pragma once

#include "arcway/stop_clock.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "core/gaps/gap_map.h"
#include "core/model/side_radii.h"
#include "core/roadmap/added_circles.h"

namespace arcway::internal {

/// Added circles for the gaps of a world that are narrow but wide enough to drive through. There, the circle on the
/// bisector of a vertex beside the gap may collide, or turn too early or too late.
///
/// | circles | where |
/// |---|---|
/// | around a vertex that faces an edge or another vertex | the outer swept circle touches what the vertex faces |
/// | tangent to a gap straight | the turn onto it or off it is as late or as early as a vertex beside it allows |
///
/// If a gap is too narrow for the tightest turn, circles around its vertex have the smallest radius of each range that
/// (7) allows, and lie on the line across the gap. In a wider gap two circles of the given radius lie to both sides of
/// that line. On a gap straight the body is in the middle of a gap. A turn at its limit has a vertex on the inner swept
/// circle, or on the circle of a corner of the body.
///
/// Contacts are those of the body grown by the safety margin. Whether circles are free is not checked. Gaps are
/// examined up to the width of a turn at a right angle to a wall: the outer radius of the swept annulus. O(gaps log
/// gaps), O(gaps) circles.
/// @param gaps  of VehicleGaps.
/// @param radii  the smallest turning radii.
/// @throws Canceled if the clock is over before all are found.
AddedCircles find_gap_circles(const World& world, const GapMap& gaps, const Vehicle& vehicle, const SideRadii& radii,
                              const StopClock& clock = {});

}  // namespace arcway::internal

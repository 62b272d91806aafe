#pragma once

#include "arcway/stop_clock.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "core/gaps/gap_map.h"
#include "core/roadmap/added_circles.h"

namespace arcway::internal {

/// Circles for the gaps of a world that are wide enough to drive through, but narrow. There the circle on the bisector
/// of a vertex beside the gap may collide, or turn too early or too late:
///
/// - Where a vertex faces an edge or another vertex, circles round it whose outer swept circle touches what it faces:
///   if the gap is too narrow for the tightest turn, the circle of the smallest radius that condition (7) allows, on
///   the line across the gap; if it is wider, the circles of the given radius to both sides of that line.
/// - Gap straights: the straight across the middle of a gap, and circles of the given radius tangent to it. A path may
/// turn off
///   it as early, and onto it as late, as one of the vertices beside it lets it: where the inner swept circle passes
///   through a vertex on the inside, or a corner's circle through one on the outside.
///
/// Contacts are those of the body grown by the safety margin; whether circles are free is not asked. Gaps are looked at
/// up to the width that a turn takes at a right angle to a wall, the outer radius of the swept annulus.
/// @param gaps    those of VehicleGaps.
/// @param radius  the smallest turning radius.
/// O(gaps log gaps), O(gaps) circles.
/// @throws Canceled if the clock is over before all are found.
AddedCircles find_gap_circles(const World& world, const GapMap& gaps, const Vehicle& vehicle, double radius,
                              const StopClock& clock = {});

}  // namespace arcway::internal

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arcway/export.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"

namespace arcway {

/// The radii of the turn circles that a planner chooses [m], ascending, at most five. If the vehicle turns more tightly
/// to one side, they are those of that side. To the other side as many radii reach from its smallest one to the
/// largest.
/// 1. The first is the vehicle's smallest radius. It is the only one if the speed on arcs does not depend on the
///    radius.
/// 2. Each further one is at least twice the one before, as long as a wider turn is a faster one.
/// 3. The last is the smallest radius with the highest v_mc, or the map's extent. It is at least 1.4 times the one
///    before.
/// 4. If none of these leads around a vertex to both sides, 1.5 times the body's larger reach to a side is added.
ARCWAY_API std::vector<double> turning_radii(const Vehicle& vehicle, const World& world);

/// The number of radii, from the first, up to the first one that leads around a vertex to both sides; all of them if
/// none does. On a circle of at most the body's reach to its side the body covers the center, where the vertex would
/// be.
/// @param grown_body  the body grown by the safety margin [m].
/// @param radii  ascending [m].
ARCWAY_API std::size_t tightest_radii(const Footprint& grown_body, std::span<const double> radii);

}  // namespace arcway

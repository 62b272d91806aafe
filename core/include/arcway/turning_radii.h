#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arcway/export.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"

namespace arcway {

/// The radii that are worth a turn circle [m], ascending: the smallest one of the vehicle and, as long as a wider turn
/// is a faster one, each at least twice the one before. The last one is the smallest with the highest v_mc, or the
/// map's extent; the last one at least 1.4 times the one before. Five of them at most; one if v_mc is constant. And if
/// the widest leads round no vertex, 1.5 half widths of the body as well.
ARCWAY_API std::vector<double> turning_radii(const Vehicle& vehicle, const World& world);

/// How many of some ascending radii it takes until one of them leads round vertices, all of them if none does: on a
/// circle of no more than half the body's width the body gets over the middle, where the vertex would be.
/// @param grown_body  by the safety margin.
ARCWAY_API std::size_t tightest_radii(const Footprint& grown_body, std::span<const double> radii);

}  // namespace arcway

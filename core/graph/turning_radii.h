#pragma once

#include <vector>

#include "core/vehicle.h"
#include "core/world.h"

namespace [[gnu::visibility("default")]] arcway {

/// The radii that are worth a turn circle [m], ascending: the smallest one of the vehicle and, as long as a wider turn
/// is a faster one, at least twice the one before, up to where v_mc ends to rise or the map's extent does; five of them
/// at most. One radius if v_mc is constant.
std::vector<double> turning_radii(const Vehicle& vehicle, const World& world);

}  // namespace arcway

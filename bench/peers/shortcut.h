#pragma once

#include <functional>
#include <span>

#include "bench/peers/exact_motion.h"
#include "datasets/io/random.h"

namespace arcway::internal::peers {

/// Shortens a path: replaces random stretches by collision-free Dubins words while that lowers the travel time of the
/// whole path. Each word takes one of the radii at random. It ends after `patience` failed attempts in a row, or when
/// `stop` returns true. Never returns a slower path.
/// @param radii  at least one, none below the vehicle's smallest.
Path shortcut(Path path, const Problem& problem, std::span<const double> radii, Random& random, int patience,
              const std::function<bool()>& stop);

}  // namespace arcway::internal::peers

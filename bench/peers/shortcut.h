#pragma once

#include <functional>
#include <span>

#include "bench/peers/exact_motion.h"
#include "datasets/io/random.h"

namespace arcway::internal::peers {

/// Replaces random stretches of a path by Dubins words of one of the radii, taken by chance, while that lowers the
/// travel time of the whole and the words are free. It ends when `patience` attempts in a row have failed or `stop`
/// says so. Never returns a slower path.
/// @param radii  at least one, none below the vehicle's smallest.
Path shortcut(Path path, const Problem& problem, std::span<const double> radii, Random& random, int patience,
              const std::function<bool()>& stop);

}  // namespace arcway::internal::peers

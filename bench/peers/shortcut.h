#pragma once

#include <functional>
#include <span>

#include "bench/peers/exact_motion.h"
#include "datasets/io/random.h"

namespace arcway::internal::peers {

struct ShortcutOptions {
  std::span<const double> radii;  ///< at least one, none below the vehicle's smallest [m]
  int patience = 0;               ///< failed attempts in a row that end it
  std::function<bool()> stop;     ///< whether to end now
};

/// Shortens a path: replaces random stretches by collision-free Dubins words while that lowers the travel time of the
/// whole path. Each word takes one of the radii at random. It ends after `patience` failed attempts in a row, or when
/// `stop` returns true. Never returns a slower path.
Path shortcut(Path path, const Problem& problem, const ShortcutOptions& options, Random& random);

}  // namespace arcway::internal::peers

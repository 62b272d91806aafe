#pragma once

#include <cstdint>

namespace arcway {

struct RefineOptions {
  /// Paths whose travel time is tried, at most; some microseconds each. Beside that, pairs of places on the lines of a
  /// path of n turns are told from their distances, O(n^2) after each change. 0: no refinement.
  std::uint32_t max_trials = 4000;
  /// Centers and radii slide in steps down to this part of the smallest turning radius, > 0.
  double smallest_step = 1.0 / 128.0;
};

}  // namespace arcway

#pragma once

#include <cstdint>

namespace arcway {

/// Local optimization of a path.
struct RefineOptions {
  /// Number of paths whose travel time is tried, at most; some microseconds each. 0: no refinement. For a path of n
  /// turns, refinement also compares distances of pairs of points on its lines, O(n^2) after each change. A step of the
  /// optimizer of all turns counts as one, too; it takes some microseconds for each turn.
  std::uint32_t max_trials = 4000;
  /// Smallest step by which centers and radii move, as a share of the smallest turning radius, > 0.
  double smallest_step = 1.0 / 128.0;
  /// Bit i: the i-th move of refinement is tried. PlannerOptions::leave_out says by name which are not.
  std::uint32_t moves = 0xFFFF'FFFF;
};

}  // namespace arcway

#pragma once

#include <span>
#include <vector>

#include "arcway/moving_obstacle.h"
#include "core/motion/motion_phases.h"
#include "core/moving/blocked_places.h"

namespace arcway::internal {

/// A phase of a motion along a path.
struct PlacedPhase {
  double from;  ///< arc length since the path's start [m]
  double time;  ///< at its start, since the motion's start [s]
  Phase phase;

  [[nodiscard]] double to() const { return from + phase.length; }
  /// The time at an arc length [s]; that of the nearer end off the phase.
  [[nodiscard]] double time_at(double s) const;
};

/// Intervals of times, disjoint and ascending.
class TimeSet {
 public:
  TimeSet() = default;
  /// The union of intervals in any order.
  explicit TimeSet(std::vector<TimeInterval> intervals);
  /// Valid while the set lives.
  [[nodiscard]] std::span<const TimeInterval> intervals() const { return intervals_; }
  [[nodiscard]] bool contains(double time) const;
  /// The open intervals between from and to that are not covered, as closed ones.
  [[nodiscard]] std::vector<TimeInterval> gaps(double from, double to) const;

 private:
  std::vector<TimeInterval> intervals_;
};

/// The times at which a motion must not begin, as it would be at a blocked place at a blocked time.
///
/// A motion that begins at t0 is at arc length s at t0 + time(s). It is at a corner or on a side of a polygon for t0 =
/// t - time(s). On a side, t is an affine function of s, so that t0 is extreme at ends, where phases change, and where
/// the speed is the side's. The polygon is convex, so that these times are one interval. O(corners x phases) a polygon.
TimeSet blocked_starts(std::span<const PlacedPhase> motion, std::span<const BlockedPlaces> blocked);

/// The times at which a place is blocked.
TimeSet blocked_stays(double place, std::span<const BlockedPlaces> blocked);

}  // namespace arcway::internal

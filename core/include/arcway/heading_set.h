#pragma once

#include <span>
#include <vector>

#include "arcway/export.h"
#include "arcway/path.h"

namespace arcway {

/// Headings from `low` counter-clockwise to `high`, ends included; 0 <= low < 2 pi, low <= high <= low + 2 pi.
struct HeadingInterval {
  double low;
  double high;
};

/// How far one can turn from a heading towards a side within an interval [rad]: at most 2 pi; negative if the heading
/// is not in it.
ARCWAY_API double reach_within(const HeadingInterval& interval, double heading, Side side);

/// A set of headings as disjoint intervals, ascending by `low`; only the last one may pass 2 pi. The full
/// circle is the one interval [0, 2 pi].
class ARCWAY_API HeadingSet {
 public:
  HeadingSet() = default;

  static HeadingSet full() { return HeadingSet({{0.0, kFullCircle}}); }
  /// The complement of the union of closed intervals, each of at most a full circle, in any order. The ends belong to
  /// the intervals given, so the result leaves them out: its own ends are the next double inwards.
  static HeadingSet complement(std::vector<HeadingInterval> blocked);
  /// The same into a set whose memory is used again; `blocked` is used up, but keeps its memory.
  static void complement(std::vector<HeadingInterval>& blocked, HeadingSet& result);
  /// The set that has these intervals.
  /// @throws std::invalid_argument naming the first one that breaks the rules above.
  static HeadingSet of_intervals(std::vector<HeadingInterval> intervals);

  [[nodiscard]] std::span<const HeadingInterval> intervals() const { return intervals_; }
  [[nodiscard]] bool empty() const { return intervals_.empty(); }
  [[nodiscard]] bool is_full() const;
  [[nodiscard]] bool contains(double heading) const { return find(heading) >= 0; }
  /// Index of the interval that has the heading, or -1. O(log intervals).
  [[nodiscard]] int find(double heading) const;
  /// How far one can turn from a heading towards a side without leaving its interval [rad]: at most 2 pi; negative if
  /// the heading is not in the set.
  [[nodiscard]] double reach(double heading, Side side) const;
  /// Removes an interval found by `find`.
  void erase(int index) { intervals_.erase(intervals_.begin() + index); }
  /// What can be reached from a heading by turning to either side, but no further than `most` < pi [rad].
  [[nodiscard]] HeadingSet around(double heading, double most) const;

 private:
  static constexpr double kFullCircle = 6.283185307179586;
  explicit HeadingSet(std::vector<HeadingInterval> intervals) : intervals_(std::move(intervals)) {}
  std::vector<HeadingInterval> intervals_;
};

}  // namespace arcway

#pragma once

#include <span>
#include <vector>

#include "arcway/export.h"
#include "arcway/path.h"

namespace arcway {

/// The headings from `low` counter-clockwise to `high` [rad], ends included. 0 <= low < 2 pi and low <= high <= low + 2
/// pi.
struct HeadingInterval {
  double low;
  double high;
};

/// How far the heading can turn towards a side within the interval [rad], at most 2 pi. Negative if the interval does
/// not contain the heading.
ARCWAY_API double reach_within(const HeadingInterval& interval, double heading, Side side);

/// A set of headings [rad] as disjoint intervals, ascending by `low`. Only the last interval may pass 2 pi. The full
/// circle is the one interval [0, 2 pi].
class ARCWAY_API HeadingSet {
 public:
  HeadingSet() = default;

  static HeadingSet full() { return HeadingSet({{0.0, kFullCircle}}); }
  /// The complement of a union of closed intervals, which may come in any order and be up to a full circle long. Their
  /// ends belong to them, so that the result's intervals end at the next double inwards. O(n log n).
  static HeadingSet complement(std::vector<HeadingInterval> blocked);
  /// Overload that writes into a set whose memory is used again. `blocked` is left unspecified and keeps its memory.
  static void complement(std::vector<HeadingInterval>& blocked, HeadingSet& result);
  /// The set of these intervals.
  /// @throws std::invalid_argument naming the first interval that breaks the rules above.
  static HeadingSet of_intervals(std::vector<HeadingInterval> intervals);

  [[nodiscard]] std::span<const HeadingInterval> intervals() const { return intervals_; }
  [[nodiscard]] bool empty() const { return intervals_.empty(); }
  [[nodiscard]] bool is_full() const;
  [[nodiscard]] bool contains(double heading) const { return find(heading) >= 0; }
  /// The index of the interval that contains the heading, or -1. O(log intervals).
  [[nodiscard]] int find(double heading) const;
  /// How far the heading can turn towards a side within its interval [rad], at most 2 pi. Negative if the set does not
  /// contain the heading.
  [[nodiscard]] double reach(double heading, Side side) const;
  /// Removes an interval found by `find`.
  void erase(int index) { intervals_.erase(intervals_.begin() + index); }
  /// The headings of the set that turning from a heading to either side reaches, by at most `most` < pi [rad].
  [[nodiscard]] HeadingSet around(double heading, double most) const;

 private:
  static constexpr double kFullCircle = 6.283185307179586;
  explicit HeadingSet(std::vector<HeadingInterval> intervals) : intervals_(std::move(intervals)) {}
  std::vector<HeadingInterval> intervals_;
};

}  // namespace arcway

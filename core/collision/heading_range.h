#pragma once

#include <vector>

#include "arcway/heading_set.h"
#include "arcway/sweep_query.h"
#include "arcway/vec2.h"
#include "core/collision/turning_headings.h"

namespace arcway::internal {

/// The free headings of a turning body within a range of headings, among the edges given to it. Within the range they
/// have the same bits as those of all edges around the circle. Only edges near the swept area need be given: few, where
/// the circle is large.
class HeadingRange {
 public:
  struct Memory {
    std::vector<HeadingInterval> blocked;
    HeadingSet free;
  };

  /// @param low  the first heading of the range [rad].
  /// @param angle  size of the range, counter-clockwise from there [rad], >= 0.
  /// @param memory  used again by the next one; must outlive this.
  HeadingRange(const TurningBody& body, double low, double angle, Memory& memory);

  /// The disc of radius `reach()` [m] around `middle()`. Edges outside of it need not be given.
  [[nodiscard]] const Vec2& middle() const { return middle_; }
  [[nodiscard]] double reach() const { return reach_; }

  /// Counts an edge. Constant time.
  /// @returns is_clear().
  bool add(const LineSegment& edge);

  /// False if an edge is touched in the range for certain.
  [[nodiscard]] bool is_clear() const { return is_clear_; }

  /// O(edges log edges).
  [[nodiscard]] const HeadingSet& free_headings();

 private:
  [[nodiscard]] bool is_near(const LineSegment& edge) const;

  const TurningBody& body_;
  EdgeContacts contacts_;
  double low_, angle_;
  Vec2 along_;  // axis of the box below, from the center
  Box box_;     // around the swept area, in the frame of the center and that axis, with a slack
  Vec2 middle_;
  double reach_;
  bool is_clear_ = true;
  Memory& memory_;
};

}  // namespace arcway::internal

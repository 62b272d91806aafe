#pragma once

#include <vector>

#include "arcway/heading_set.h"
#include "arcway/sweep_query.h"
#include "arcway/vec2.h"

namespace arcway::internal {

/// The headings at which a turning body touches none of the edges it is given, of a range of headings alone: there the
/// same bits as those of all edges around the circle, from the edges near the swept area. Those are few where the
/// circle is large.
class HeadingRange {
 public:
  struct Memory {
    std::vector<HeadingInterval> blocked;
    HeadingSet free;
  };

  /// @param low     the first heading of the range [rad].
  /// @param angle   how far it goes on from there to the left, >= 0 [rad].
  /// @param memory  used again by the next one; must outlive this.
  HeadingRange(const TurningBody& body, double low, double angle, Memory& memory);

  /// The disc `reach()` around `middle()`: edges outside of it need not be given.
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
  double low_, angle_;
  Vec2 along_;  // axis of the box below, from the center
  Box box_;     // around the swept area, in the frame of the center and that axis, with a slack
  Vec2 middle_;
  double reach_;
  bool is_clear_ = true;
  Memory& memory_;
};

}  // namespace arcway::internal

#pragma once

#include <span>
#include <vector>

#include "arcway/vec2.h"
#include "core/geometry/box_tree.h"

namespace arcway::internal {

/// Boxes grown by a distance, for asking what may lie near them. Immutable and thread-safe.
class NearBoxes {
 public:
  /// @param reach  by which each box grows to every side [m].
  explicit NearBoxes(std::span<const Box> boxes, double reach = 0.0);

  [[nodiscard]] bool empty() const { return boxes_.empty(); }
  /// False only if no point of the segment lies in a box. O(log n) beside the boxes that the segment's own box meets.
  [[nodiscard]] bool may_meet(const Vec2& a, const Vec2& b) const;
  [[nodiscard]] bool may_meet(const Box& box) const {
    return !tree_.visit_overlaps(box, [](std::uint32_t) { return false; });
  }

 private:
  std::vector<Box> boxes_;
  BoxTree tree_;
};

}  // namespace arcway::internal

#include "core/collision/walled_sweep.h"

#include <algorithm>

#include "core/collision/swept_shape.h"
#include "core/collision/turning_headings.h"
#include "core/geometry/predicates.h"

namespace arcway::internal {

void WalledSweep::do_straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const {
  base_->straight_free(rectangles, free);
  for (std::size_t i = 0; i < rectangles.size(); ++i)
    for (const LineSegment& wall : walls_)
      if (free[i] != 0 && intersects(wall, rectangles[i])) free[i] = 0;
}

void WalledSweep::do_straight_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const {
  base_->straight_free(bodies, free);
  SweptShape::Memory memory;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const SweptShape shape(bodies[i], memory);
    for (const LineSegment& wall : walls_)
      if (free[i] != 0 && shape.meets(wall)) free[i] = 0;
  }
}

void WalledSweep::do_free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const {
  base_->free_headings(bodies, result);
  std::vector<HeadingInterval> blocked;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (result[i].empty()) continue;
    blocked.clear();
    EdgeContacts contacts(bodies[i]);
    for (const LineSegment& wall : walls_)
      if (contacts.may_touch(wall)) contacts.append_blocked(wall, blocked);
    remove_headings(blocked, result[i]);
  }
}

}  // namespace arcway::internal

#include "core/geometry/near_boxes.h"

#include "core/geometry/predicates.h"

namespace arcway::internal {

namespace {

// Whether the line through two points passes a box, or the points are one.
bool passes(const Vec2& a, const Vec2& b, const Box& box) {
  int sum = 0;
  for (const Vec2& corner : box.corners()) sum += orientation(a, b, corner);
  return sum > -4 && sum < 4;
}

}  // namespace

NearBoxes::NearBoxes(std::span<const Box> boxes, double reach) : boxes_(boxes.begin(), boxes.end()) {
  for (Box& box : boxes_) box = box.grown(reach);
  tree_ = BoxTree(boxes_);
}

bool NearBoxes::may_meet(const Vec2& a, const Vec2& b) const {
  return !tree_.visit_overlaps(box_of({a, b}), [&](std::uint32_t i) { return !passes(a, b, boxes_[i]); });
}

}  // namespace arcway::internal

#include "core/attach/circle_places.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <utility>
#include <vector>

namespace arcway::internal {

namespace {

void extend_by(Box& box, const TurnCircle& circle) {
  const Vec2 half(circle.radius, circle.radius);
  box.extend(circle.center - half);
  box.extend(circle.center + half);
}

}  // namespace

CirclePlaces::CirclePlaces(const TurnCircles& circles, std::shared_ptr<const Outlines> outlines)
    : outlines_(std::move(outlines)) {
  const Outlines& pieces = *outlines_;
  const std::span<const TurnCircle> all = circles.all();
  HugeVector<Box> boxes(pieces.size());
  circles_.reserve(all.size());
  groups_.reserve(pieces.size());
  first_group_.reserve(pieces.size() + 1);
  struct Sized {
    int magnitude;  // of the radius
    std::uint32_t circle;
    auto operator<=>(const Sized&) const = default;
  };
  std::vector<Sized> here;
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    const Outlines::Piece piece = pieces[i];
    here.clear();
    for (std::size_t k = 0; k < piece.edge_count(); ++k)
      circles.visit_by_first(static_cast<VertexId>(piece.first + k), [&](std::uint32_t c) {
        here.push_back({std::ilogb(all[c].radius), c});
      });
    std::ranges::sort(here);
    boxes[i] = piece.box;
    first_group_.push_back(static_cast<std::uint32_t>(groups_.size()));
    for (std::size_t k = 0; k < here.size(); ++k) {
      const auto at = static_cast<std::uint32_t>(circles_.size());
      if (k == 0 || here[k].magnitude != here[k - 1].magnitude) groups_.push_back({at, at, Box()});
      Group& group = groups_.back();
      group.last = at + 1;
      circles_.push_back(here[k].circle);
      extend_by(group.box, all[here[k].circle]);
    }
    for (std::size_t g = first_group_.back(); g < groups_.size(); ++g) boxes[i].extend(groups_[g].box);
  }
  first_group_.push_back(static_cast<std::uint32_t>(groups_.size()));
  tree_ = pieces.tree().with_boxes(boxes);
}

}  // namespace arcway::internal

#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/base/huge_pages.h"
#include "core/geometry/box_tree.h"
#include "core/model/outlines.h"
#include "core/roadmap/turn_circles.h"

namespace arcway::internal {

/// The circles of a graph by place: each with the piece of outline on which it goes round its first vertex, those of
/// about one radius in a box of their own. Immutable and thread-safe.
class CirclePlaces {
 public:
  CirclePlaces(const TurnCircles& circles, std::shared_ptr<const Outlines> outlines);

  /// Circles of a piece whose radii differ by less than a factor of two, and a box around them.
  struct Group {
    std::uint32_t first, last;
    Box box;
  };
  /// Calls visit(piece, index) for each piece that lies with all of its circles in a box that passes a test, those near
  /// a position early. See BoxTree::visit_near_first.
  template <class Test, class Visitor>
  void visit_near_first(const Vec2& position, Test&& passes, Visitor&& visit) const {
    tree_.visit_near_first(position, passes, [&](std::uint32_t i) { visit((*outlines_)[i], i); });
  }
  /// Of a piece, by its index.
  [[nodiscard]] std::span<const Group> groups(std::uint32_t piece) const {
    return std::span(groups_).subspan(first_group_[piece], first_group_[piece + 1] - first_group_[piece]);
  }
  [[nodiscard]] std::span<const std::uint32_t> circles(const Group& group) const {
    return std::span(circles_).subspan(group.first, group.last - group.first);
  }

 private:
  std::shared_ptr<const Outlines> outlines_;
  HugeVector<std::uint32_t> circles_;
  HugeVector<Group> groups_;
  HugeVector<std::uint32_t> first_group_;  // by piece, one more
  BoxTree tree_;                           // of the pieces
};

}  // namespace arcway::internal

#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/base/huge_pages.h"
#include "core/geometry/box_tree.h"
#include "core/model/outlines.h"
#include "core/roadmap/turn_circles.h"

namespace arcway::internal {

/// A spatial index of a roadmap's circles. Each circle belongs to the piece of outline that has its first vertex.
/// Circles of similar radius share a box. Immutable and thread-safe.
class CirclePlaces {
 public:
  CirclePlaces(const TurnCircles& circles, std::shared_ptr<const Outlines> outlines);

  /// Circles of one piece whose radii differ by less than a factor of 2, and their box [m].
  struct Group {
    std::uint32_t first, last;
    Box box;
  };
  /// Calls visit(piece, index) for each piece that lies, with all of its circles, in a box that passes a test. Pieces
  /// near a position tend to come early: see BoxTree::visit_near_first.
  template <class Test, class Visitor>
  void visit_near_first(const Vec2& position, Test&& passes, Visitor&& visit) const {
    tree_.visit_near_first(position, passes, [&](std::uint32_t i) { visit((*outlines_)[i], i); });
  }
  /// The groups of a piece, by its index.
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

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "arcway/world.h"
#include "core/base/huge_pages.h"
#include "core/geometry/box_tree.h"

namespace arcway::internal {

/// The outlines of all regions in short pieces, to be looked up by place. Every edge is in one piece, up to its
/// direction. Immutable and thread-safe. O(n log n), about 35 bytes a vertex.
class Outlines {
 public:
  explicit Outlines(const World& world);

  /// Some edges of a ring one after the other.
  struct Piece {
    VertexId first;                ///< vertex at points[0]; the next ones follow, but for the last point
    std::span<const Vec2> points;  ///< one more than edges; the last one begins the next piece
    const Box& box;                ///< around them
    [[nodiscard]] std::size_t edge_count() const { return points.size() - 1; }
  };

  /// How many pieces; those of a ring follow each other, as do rings and regions.
  [[nodiscard]] std::size_t size() const { return boxes_.size(); }
  [[nodiscard]] Piece operator[](std::uint32_t i) const {
    return {starts_[i].vertex, std::span(points_).subspan(starts_[i].point, starts_[i + 1].point - starts_[i].point),
            boxes_[i]};
  }

  /// Their boxes.
  [[nodiscard]] const BoxTree& tree() const { return tree_; }

  /// Calls visit(piece) for each piece whose box, and all boxes around it, pass a test, until a call returns false.
  /// Returns whether none did. See BoxTree::visit_if.
  template <class Test, class Visitor>
  bool visit_if(Test&& passes, Visitor&& visit) const {
    return tree_.visit_if(passes, [&](std::uint32_t i) { return visit((*this)[i]); });
  }
  /// The same, those near a place early, see BoxTree::visit_near_first.
  template <class Test, class Visitor>
  void visit_near_first(const Vec2& place, Test&& passes, Visitor&& visit) const {
    tree_.visit_near_first(place, passes, [&](std::uint32_t i) { visit((*this)[i]); });
  }

 private:
  struct Start {
    VertexId vertex;
    std::uint32_t point;
  };
  HugeVector<Vec2> points_;
  HugeVector<Start> starts_;  // one more than pieces
  HugeVector<Box> boxes_;
  BoxTree tree_;
};

}  // namespace arcway::internal

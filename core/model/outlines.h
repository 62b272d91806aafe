#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "arcway/world.h"
#include "core/base/huge_pages.h"
#include "core/geometry/box_tree.h"

namespace arcway::internal {

/// A spatial index of the outlines of all regions, as short pieces. Every edge is in exactly one piece. Immutable and
/// thread-safe. O(n log n) to build, about 35 bytes a vertex.
class Outlines {
 public:
  explicit Outlines(const World& world);

  /// Consecutive edges of a ring.
  struct Piece {
    VertexId first;                ///< vertex at points[0]; the others follow, except at the last point
    std::span<const Vec2> points;  ///< one more than edges [m]; the last one begins the next piece
    const Box& box;                ///< of the points [m]
    [[nodiscard]] std::size_t edge_count() const { return points.size() - 1; }
  };

  /// The number of pieces. Pieces of a ring are consecutive, and so are rings of a region, and regions.
  [[nodiscard]] std::size_t size() const { return boxes_.size(); }
  [[nodiscard]] Piece operator[](std::uint32_t i) const {
    return {starts_[i].vertex, std::span(points_).subspan(starts_[i].point, starts_[i + 1].point - starts_[i].point),
            boxes_[i]};
  }

  /// The tree of the pieces' boxes.
  [[nodiscard]] const BoxTree& tree() const { return tree_; }

  /// Calls visit(piece) for each piece whose box, and all boxes around it, pass a test, until a call returns false.
  /// Returns whether all calls returned true. See BoxTree::visit_if.
  template <class Test, class Visitor>
  bool visit_if(Test&& passes, Visitor&& visit) const {
    return tree_.visit_if(passes, [&](std::uint32_t i) { return visit((*this)[i]); });
  }
  /// Calls visit(piece) for the pieces of visit_if, those near a place early. See BoxTree::visit_near_first.
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

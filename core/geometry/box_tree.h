#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "arcway/vec2.h"
#include "core/base/huge_pages.h"

namespace arcway::internal {

/// Static bounding-box tree over a set of boxes, for overlap queries.
///
///     const BoxTree tree(boxes);
///     tree.visit_overlaps(query, [&](std::uint32_t i) { hits.push_back(i); return true; });
///
/// Split at the median of the longer side, or of the other one where the middles of boxes spread much further along it.
/// Nodes are packed in preorder. Build O(n log n); a query is
/// O(log n + hits) for boxes that are small beside their spread. Immutable and thread-safe.
class BoxTree {
 public:
  BoxTree() = default;
  /// Item i is boxes[i]; the boxes must not be empty. They are copied. Fewer than 2^31 of them.
  explicit BoxTree(std::span<const Box> boxes);

  /// The tree of as many other boxes, divided like this one, which is good for boxes that lie much as those here: O(n).
  [[nodiscard]] BoxTree with_boxes(std::span<const Box> boxes) const;

  [[nodiscard]] std::size_t size() const { return items_.size(); }

  /// Calls `visit(index)` for each item whose closed box meets `query`, in no useful but always the
  /// same order, until a call returns false. Returns whether all calls returned true.
  template <class Visitor>
  bool visit_overlaps(const Box& query, Visitor&& visit) const {
    return visit_if([&query](const Box& box) { return box.overlaps(query); }, visit);
  }

  /// The same for each item whose own box and all boxes around it pass a test that no box passes unless every box
  /// around it does.
  template <class Test, class Visitor>
  bool visit_if(Test&& passes, Visitor&& visit) const {
    for (std::uint32_t i = 0; i < nodes_.size();) {
      const Node& node = nodes_[i];
      if (!passes(node.box)) {
        i = node.skip;
        continue;
      }
      for (std::uint32_t k = node.first; k < node.last; ++k) {
        if (passes(items_[k].box) && !visit(items_[k].index)) return false;
      }
      ++i;
    }
    return true;
  }

  /// Calls visit(index) for the items that visit_if visits, those near a place early: of the two halves of a box the
  /// nearer one comes first, of two that hold the place the smaller one, so that what lies there may decide whether the
  /// other passes.
  template <class Test, class Visitor>
  void visit_near_first(const Vec2& place, Test&& passes, Visitor&& visit) const {
    const auto is_nearer = [&](const Box& a, const Box& b) {
      const double to_a = (a.closest_point(place) - place).squaredNorm();
      const double to_b = (b.closest_point(place) - place).squaredNorm();
      return to_a != to_b ? to_a < to_b : (a.max - a.min).squaredNorm() <= (b.max - b.min).squaredNorm();
    };
    std::array<std::uint32_t, kMostLevels> waiting{};
    std::size_t count = nodes_.empty() ? 0 : 1;
    while (count > 0) {
      const std::uint32_t i = waiting[--count];
      const Node& node = nodes_[i];
      if (!passes(node.box)) continue;
      for (std::uint32_t k = node.first; k < node.last; ++k)
        if (passes(items_[k].box)) visit(items_[k].index);
      if (node.first < node.last) continue;
      const std::uint32_t low = i + 1, high = nodes_[low].skip;
      const bool low_is_near = is_nearer(nodes_[low].box, nodes_[high].box);
      waiting[count++] = low_is_near ? high : low;
      waiting[count++] = low_is_near ? low : high;
    }
  }

 private:
  static constexpr std::size_t kMostLevels = 33;  // halves of less than 2^31 items, one of which waits in each

  struct Node {
    Box box;
    std::uint32_t first, last;  ///< items of a leaf; none for an inner node
    std::uint32_t skip;         ///< the node after this one's subtree
  };
  struct Item {
    Box box;
    std::uint32_t index;
  };
  void build(std::uint32_t first, std::uint32_t last);

  HugeVector<Node> nodes_;
  HugeVector<Item> items_;
};

}  // namespace arcway::internal

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "arcway/stop_clock.h"
#include "arcway/vec2.h"
#include "core/base/huge_pages.h"

namespace arcway::internal {

/// A static bounding-box tree, for overlap queries.
///
///     const BoxTree tree(boxes);
///     tree.visit_overlaps(query, [&](std::uint32_t i) { hits.push_back(i); return true; });
///
/// Nodes are split at the median of the longer side, or of the other side if the middles of the boxes spread much
/// further along it. They are packed in preorder. O(n log n) to build; O(log n + hits) a query, for boxes that are
/// small beside their spread. Immutable and thread-safe.
class BoxTree {
 public:
  BoxTree() = default;
  /// @param boxes  of items 0, 1, ...; not empty, fewer than 2^31. They are copied.
  /// @throws Canceled if the clock is over before the tree is built.
  explicit BoxTree(std::span<const Box> boxes, const StopClock& clock = {});

  /// A tree of as many other boxes, divided like this one: good for boxes that lie much as these. O(n).
  [[nodiscard]] BoxTree with_boxes(std::span<const Box> boxes) const;

  [[nodiscard]] std::size_t size() const { return items_.size(); }

  /// Calls visit(index) for each item whose closed box meets `query`, until a call returns false. The order is the same
  /// every time, but has no meaning. Returns whether all calls returned true.
  template <class Visitor>
  bool visit_overlaps(const Box& query, Visitor&& visit) const {
    return visit_if([&query](const Box& box) { return box.overlaps(query); }, visit);
  }

  /// Calls visit(index) for each item whose own box, and all boxes around it, pass a test, until a call returns false.
  /// A box may pass only if every box around it passes. Returns whether all calls returned true.
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

  /// Calls visit(index) for the items of visit_if, those near a place early. Of two halves of a box, the nearer one
  /// comes first; if both contain the place, the smaller one does. What is found there may decide whether the other one
  /// passes.
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
  void build(std::uint32_t first, std::uint32_t last, StopTicker& ticker);

  HugeVector<Node> nodes_;
  HugeVector<Item> items_;
};

}  // namespace arcway::internal

#include "core/geometry/box_tree.h"

#include <algorithm>

#include "arcway/executor.h"

namespace arcway::internal {
namespace {

constexpr std::uint32_t kLeafSize = 4;
// Boxes are divided along the shorter side of all if their middles spread this many times as far along it. Long edges
// of nested squares have equal middles along the longer side. Halves by that side would overlap wholly, and a query
// would visit all boxes.
constexpr double kMuchFurther = 4.0;

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes, const StopClock& clock) {
  items_.reserve(boxes.size());
  for (const Box& box : boxes) items_.push_back({box, static_cast<std::uint32_t>(items_.size())});
  nodes_.reserve(boxes.size() + 1);
  StopTicker ticker(clock);
  if (!items_.empty()) build(0, static_cast<std::uint32_t>(items_.size()), ticker);
}

void BoxTree::build(std::uint32_t first, std::uint32_t last, StopTicker& ticker) {
  end_if_over(ticker);
  Box box, middles;  // the latter doubled
  for (std::uint32_t i = first; i < last; ++i) {
    box.extend(items_[i].box);
    middles.extend(Vec2(items_[i].box.min + items_[i].box.max));
  }
  const std::size_t node = nodes_.size();
  if (last - first <= kLeafSize) {
    nodes_.push_back({box, first, last, static_cast<std::uint32_t>(node + 1)});
    return;
  }
  nodes_.push_back({box, 0, 0, 0});
  Eigen::Index axis = box.max.x() - box.min.x() >= box.max.y() - box.min.y() ? 0 : 1;
  const Vec2 spread = middles.max - middles.min;
  if (spread[1 - axis] > kMuchFurther * spread[axis]) axis = 1 - axis;
  const auto before = [axis](const Item& a, const Item& b) {
    const double center_a = a.box.min[axis] + a.box.max[axis];
    const double center_b = b.box.min[axis] + b.box.max[axis];
    return center_a != center_b ? center_a < center_b : a.index < b.index;
  };
  const std::uint32_t middle = first + (last - first) / 2;
  std::nth_element(items_.begin() + first, items_.begin() + middle, items_.begin() + last, before);
  build(first, middle, ticker);
  build(middle, last, ticker);
  nodes_[node].skip = static_cast<std::uint32_t>(nodes_.size());
}

BoxTree BoxTree::with_boxes(std::span<const Box> boxes) const {
  BoxTree tree = *this;
  for (Item& item : tree.items_) item.box = boxes[item.index];
  for (std::size_t i = tree.nodes_.size(); i-- > 0;) {  // the halves of a node follow it
    Node& node = tree.nodes_[i];
    node.box = Box();
    for (std::uint32_t k = node.first; k < node.last; ++k) node.box.extend(tree.items_[k].box);
    if (node.first < node.last) continue;
    const Node& low = tree.nodes_[i + 1];
    node.box.extend(low.box);
    node.box.extend(tree.nodes_[low.skip].box);
  }
  return tree;
}

}  // namespace arcway::internal

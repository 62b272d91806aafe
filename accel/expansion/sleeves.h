#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/base/big_vector.h"
#include "accel/expansion/free_space_triangulation.h"
#include "core/base/prefetch.h"
#include "core/geometry/predicates.h"

namespace arcway::internal {

/// Sleeves between two convex chains: triangles that follow each other without branches, each with one boundary edge.
///
/// What is visible through a sleeve is found by a search along each of its chains, instead of triangle by triangle. A
/// chain consists of vertices with simple nodes and leads from left to right or from right to left, so it turns by less
/// than half a circle. All other triangles lie between sleeves. Each sleeve is stored twice, once for each direction.
class Sleeves {
 public:
  /// The nodes of one of a sleeve's chains, in the order in which the sleeve passes them, and how the chain turns.
  struct Reach {
    std::uint32_t first_node = 0;
    std::uint32_t count = 0;
    float edge_x = 1.0F, edge_y = 0.0F;  ///< direction of the edge to the first node
    float nodes_per_quarter = 0.0F;      ///< nodes for a quarter of a turn, on average
  };

  /// A sleeve as entered at one of its ends.
  struct Sleeve {
    Reach left;                ///< chain on the left, counter-clockwise around its obstacle
    Reach right;               ///< chain on the right, clockwise around its obstacle
    std::uint32_t exit;        ///< half-edge out of its last triangle
    std::uint32_t first_turn;  ///< start of its entries in turns_
    bool is_back;              ///< whether these entries are those of the other direction
  };

  /// One of a sleeve's convex chains: nodes by their index along it.
  template <int kStep>  // 1 on the left, -1 on the right
  class Chain {
   public:
    using Node = FreeSpaceTriangulation::Node;
    Chain(const Reach& reach, std::span<const Node> nodes) : reach_(&reach), first_(nodes.data() + reach.first_node) {}

    [[nodiscard]] std::uint32_t count() const { return reach_->count; }
    [[nodiscard]] std::uint32_t index_of_node(std::uint32_t i) const {
      return reach_->first_node + static_cast<std::uint32_t>(kStep) * i;
    }
    [[nodiscard]] const Node& node(std::uint32_t i) const { return first_[kStep * static_cast<std::ptrdiff_t>(i)]; }
    [[nodiscard]] static const Vec2& ahead_of(const Node& node) { return kStep > 0 ? node.next : node.previous; }
    [[nodiscard]] static const Vec2& before(const Node& node) { return kStep > 0 ? node.previous : node.next; }
    /// Side of the ray from s through p on which q lies: +1 on the chain's side, -1 on the other side.
    [[nodiscard]] static int turn(const Vec2& s, const Vec2& p, const Vec2& q) { return kStep * orientation(s, p, q); }

    /// Prefetches what a search that begins at a node reads.
    void fetch(std::uint32_t i) const {
      will_need(&node(i).at);
      will_need(&ahead_of(node(i)));
    }

    /// Estimate of the node that a ray in this direction touches.
    [[nodiscard]] std::uint32_t guess(const Vec2& direction) const;
    /// The node among the chain's first `nodes` that bounds the view from s; kNone if the end of the half-edge before
    /// them does.
    /// @param passed  number of the chain's nodes passed before s, if s lies on the other chain; else 0.
    /// @param guess   estimate of the node, where the search begins.
    /// @param sure    FreeSpaceTriangulation::sure_cross_product.
    [[nodiscard]] std::uint32_t bounding_node_from(const Vec2& s, std::uint32_t nodes, std::uint32_t passed,
                                                   std::uint32_t guess, double sure) const;

   private:
    const Reach* reach_;
    const Node* first_;
  };

  /// No sleeves.
  Sleeves() = default;
  /// Finds the sleeves of at least `least` triangles. O(triangles), the same result for any executor.
  Sleeves(const FreeSpaceTriangulation& triangulation, std::uint32_t least,
          const Executor& executor = SerialExecutor());

  [[nodiscard]] bool empty() const { return sleeves_.empty(); }
  [[nodiscard]] std::size_t size() const { return sleeves_.size(); }
  /// The sleeve that a half-edge enters, or null.
  [[nodiscard]] const Sleeve* behind(std::uint32_t half_edge) const {
    const Mark& mark = marks_[half_edge / kHalfEdgesPerMark];
    const std::uint64_t bit = std::uint64_t{1} << half_edge % kHalfEdgesPerMark;
    if ((mark.half_edges & bit) == 0) return nullptr;
    return &sleeves_[mark.before + static_cast<std::uint32_t>(std::popcount(mark.half_edges & (bit - 1)))];
  }
  /// Number of the right chain's nodes passed before the left chain's node with this index.
  [[nodiscard]] std::uint32_t right_before(const Sleeve& sleeve, std::uint32_t left) const {
    return sleeve.is_back ? sleeve.right.count - first_ones(sleeve, sleeve.left.count - 1 - left) : turns(sleeve)[left];
  }
  [[nodiscard]] std::uint32_t left_before(const Sleeve& sleeve, std::uint32_t right) const {
    return sleeve.is_back ? sleeve.left.count - turns(sleeve)[sleeve.right.count - 1 - right]
                          : first_ones(sleeve, right);
  }

  /// Angle from u counter-clockwise to v, in quarters of a turn from 0 to 2; approximate.
  static double quarters_of_turn(const Vec2& u, const Vec2& v) {
    const double along = u.dot(v), across = u.x() * v.y() - u.y() * v.x();
    if (!(across > 0.0)) return 0.0;
    const double p = across / (std::abs(along) + across);
    const double angle = p - 0.46 * p * (1.0 - p) * (1.0 - 2.0 * p);  // error below 0.005 quarters
    return along >= 0.0 ? angle : 2.0 - angle;
  }

 private:
  static constexpr std::uint32_t kHalfEdgesPerMark = 64;
  struct Mark {
    std::uint64_t half_edges = 0;  ///< by bit, whether a sleeve begins there
    std::uint32_t before = 0;      ///< number of sleeves that begin at half-edges before these
  };

  /// For each node of one chain, the number of the other chain's nodes passed before it.
  [[nodiscard]] std::span<const std::uint32_t> turns(const Sleeve& sleeve) const {
    return std::span(turns_).subspan(sleeve.first_turn, sleeve.is_back ? sleeve.right.count : sleeve.left.count);
  }
  /// Number of that chain's nodes passed before a node of the other chain.
  [[nodiscard]] std::uint32_t first_ones(const Sleeve& sleeve, std::uint32_t other) const {
    const auto all = turns(sleeve);
    return static_cast<std::uint32_t>(std::upper_bound(all.begin(), all.end(), other) - all.begin());
  }

  std::vector<Mark> marks_;         // of 64 half-edges each
  std::vector<Sleeve> sleeves_;     // in the order of their half-edges
  BigVector<std::uint32_t> turns_;  // by sleeve and node of one of its chains
};

template <int kStep>
std::uint32_t Sleeves::Chain<kStep>::guess(const Vec2& direction) const {
  const Vec2 edge(reach_->edge_x, reach_->edge_y);
  const double quarters = kStep > 0 ? quarters_of_turn(edge, direction) : quarters_of_turn(direction, edge);
  const double nodes = quarters * reach_->nodes_per_quarter;
  const std::uint32_t last = std::max(count(), 1u) - 1;
  return nodes < last ? static_cast<std::uint32_t>(nodes) : last;
}

// The view from a point before the sleeve narrows along a convex chain, node by node, up to the bounding node. Later
// nodes lie behind it, or all nodes lie behind the end of the half-edge. From the other chain the last node passed is
// visible.
template <int kStep>
std::uint32_t Sleeves::Chain<kStep>::bounding_node_from(const Vec2& s, std::uint32_t nodes, std::uint32_t passed,
                                                        std::uint32_t guess, double sure) const {
  const auto is_ahead = [&](const Vec2& p, const Vec2& q) {
    const double area = kStep * ((p.x() - s.x()) * (q.y() - s.y()) - (p.y() - s.y()) * (q.x() - s.x()));
    if (area < -sure) return true;
    return area <= sure && turn(s, p, q) < 0;
  };
  if (nodes == 0) return kNone;
  std::uint32_t low = std::max(passed, 1u) - 1, high = nodes - 1;
  std::uint32_t middle = std::clamp(guess, low, std::max(high, low + 1) - 1);
  for (std::uint32_t far = 1; low < high; far = std::min(2 * far, nodes)) {  // distance to the next node tried
    const Node& n = node(middle);
    if (is_ahead(n.at, ahead_of(n))) {
      low = middle + 1;
      middle = low + std::min(far - 1, (high - low) / 2);
    } else {
      high = middle;
      middle = high - std::min(far, (high - low + 1) / 2);
    }
  }
  return low == 0 && passed == 0 && !is_ahead(before(*first_), first_->at) ? kNone : low;
}

/// Sleeves, if finding and crossing them takes less time than crossing their triangles one by one. None unless most
/// vertices lie on long convex chains.
Sleeves worthwhile_sleeves(const World& world, const FreeSpaceTriangulation& triangulation,
                           const Executor& executor = SerialExecutor());

}  // namespace arcway::internal

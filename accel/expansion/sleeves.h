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

/// Where triangles follow each other between two convex walls, and one cannot but go on from the first to the last:
/// what is seen there is found by a search along each of the walls, instead of triangle by triangle.
///
/// A wall is followed over vertices with plain nodes only, from left to right or from right to left: it turns by less
/// than half a circle. Triangles that do otherwise are between sleeves. Each sleeve is there twice, once from each end.
class Sleeves {
 public:
  /// Nodes that somebody who enters a sleeve reaches along one of its walls, and how the wall turns.
  struct Reach {
    std::uint32_t first_node = 0;
    std::uint32_t count = 0;
    float edge_x = 1.0F, edge_y = 0.0F;  ///< direction of the edge to the first node
    float nodes_per_quarter = 0.0F;      ///< how many make a quarter of a turn, on average
  };

  /// Seen by somebody who enters it at one of its ends.
  struct Sleeve {
    Reach left;                ///< the next nodes around the obstacle
    Reach right;               ///< the ones before
    std::uint32_t exit;        ///< the half-edge behind its last triangle
    std::uint32_t first_turn;  ///< see right_before
    bool is_back;              ///< whether its turns are those of the other end
  };

  /// One of a sleeve's walls: nodes by their index along it.
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
    /// Which way a point q lies from the ray from s through p: +1 behind the wall's side of it, -1 on the other side.
    [[nodiscard]] static int turn(const Vec2& s, const Vec2& p, const Vec2& q) { return kStep * orientation(s, p, q); }

    /// Fetches what a search that begins at a node needs.
    void fetch(std::uint32_t i) const {
      will_need(&node(i).at);
      will_need(&ahead_of(node(i)));
    }

    /// A node that may be near the one that a ray in this direction touches.
    [[nodiscard]] std::uint32_t guess(const Vec2& direction) const;
    /// The node that limits what is seen from s past the first nodes; kNone if that is the end of the half-edge before
    /// them.
    /// @param passed  nodes of the wall that were passed before s, if s is on the other wall: 0 if it is not.
    /// @param guess   a node that may be near it.
    /// @param sure    FreeSpaceTriangulation::sure_cross_product.
    [[nodiscard]] std::uint32_t bounding_node_from(const Vec2& s, std::uint32_t nodes, std::uint32_t passed,
                                                   std::uint32_t guess, double sure) const;

   private:
    const Reach* reach_;
    const Node* first_;
  };

  /// None.
  Sleeves() = default;
  /// Those of at least so many triangles. O(triangles), the same for any executor.
  Sleeves(const FreeSpaceTriangulation& triangulation, std::uint32_t least,
          const Executor& executor = SerialExecutor());

  [[nodiscard]] bool empty() const { return sleeves_.empty(); }
  [[nodiscard]] std::size_t size() const { return sleeves_.size(); }
  /// That which is entered by a half-edge, nullptr if none is.
  [[nodiscard]] const Sleeve* behind(std::uint32_t half_edge) const {
    const Mark& mark = marks_[half_edge / kHalfEdgesPerMark];
    const std::uint64_t bit = std::uint64_t{1} << half_edge % kHalfEdgesPerMark;
    if ((mark.half_edges & bit) == 0) return nullptr;
    return &sleeves_[mark.before + static_cast<std::uint32_t>(std::popcount(mark.half_edges & (bit - 1)))];
  }
  /// How many nodes of the right wall are passed before the one of the left wall with this index.
  [[nodiscard]] std::uint32_t right_before(const Sleeve& sleeve, std::uint32_t left) const {
    return sleeve.is_back ? sleeve.right.count - first_ones(sleeve, sleeve.left.count - 1 - left) : turns(sleeve)[left];
  }
  [[nodiscard]] std::uint32_t left_before(const Sleeve& sleeve, std::uint32_t right) const {
    return sleeve.is_back ? sleeve.left.count - turns(sleeve)[sleeve.right.count - 1 - right]
                          : first_ones(sleeve, right);
  }

  /// About the angle from u counter-clockwise to v, in quarters of a turn from 0 to 2.
  static double quarters_of_turn(const Vec2& u, const Vec2& v) {
    const double along = u.dot(v), across = u.x() * v.y() - u.y() * v.x();
    if (!(across > 0.0)) return 0.0;
    const double p = across / (std::abs(along) + across);
    const double angle = p - 0.46 * p * (1.0 - p) * (1.0 - 2.0 * p);  // within 0.005
    return along >= 0.0 ? angle : 2.0 - angle;
  }

 private:
  static constexpr std::uint32_t kHalfEdgesPerMark = 64;
  struct Mark {
    std::uint64_t half_edges = 0;  ///< by bit, whether a sleeve begins there
    std::uint32_t before = 0;      ///< sleeves that begin at half-edges before these
  };

  /// By node of one of the walls, how many nodes of the other one are passed before it.
  [[nodiscard]] std::span<const std::uint32_t> turns(const Sleeve& sleeve) const {
    return std::span(turns_).subspan(sleeve.first_turn, sleeve.is_back ? sleeve.right.count : sleeve.left.count);
  }
  /// How many of them are passed before a node of that other one.
  [[nodiscard]] std::uint32_t first_ones(const Sleeve& sleeve, std::uint32_t other) const {
    const auto all = turns(sleeve);
    return static_cast<std::uint32_t>(std::upper_bound(all.begin(), all.end(), other) - all.begin());
  }

  std::vector<Mark> marks_;         // of 64 half-edges each
  std::vector<Sleeve> sleeves_;     // in the order of their half-edges
  BigVector<std::uint32_t> turns_;  // by sleeve and node of one of its walls
};

template <int kStep>
std::uint32_t Sleeves::Chain<kStep>::guess(const Vec2& direction) const {
  const Vec2 edge(reach_->edge_x, reach_->edge_y);
  const double quarters = kStep > 0 ? quarters_of_turn(edge, direction) : quarters_of_turn(direction, edge);
  const double nodes = quarters * reach_->nodes_per_quarter;
  const std::uint32_t last = std::max(count(), 1u) - 1;
  return nodes < last ? static_cast<std::uint32_t>(nodes) : last;
}

// Seen from a point before the sleeve, nodes of a convex wall come nearer to the other wall one after the other, up to
// the one that limits what is seen. Further ones lie behind it; or all of them lie behind the end of the half-edge.
// From the other wall the last node that was passed is in sight.
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
  for (std::uint32_t far = 1; low < high; far = std::min(2 * far, nodes)) {  // how far the next one is looked for
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

/// Those that take less time to be found and passed than their triangles one by one. None unless most vertices are on
/// long convex walls.
Sleeves worthwhile_sleeves(const World& world, const FreeSpaceTriangulation& triangulation,
                           const Executor& executor = SerialExecutor());

}  // namespace arcway::internal

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "arcway/world.h"

namespace arcway::internal {

/// Pairs of a world's convex vertices whose line is tangent at both: tested in batches in single precision, and exactly
/// where that cannot decide.
///
/// Coordinates are centered and scaled into [-1, 1]; directions of the two edges at a vertex are scaled to |x| + |y| =
/// 1. The cross product of a difference of coordinates and such a direction is off by less than 2^-21. That is 2^-23
/// each from the rounding of the difference, the direction, the products and their difference.
class TangentFilter {
 public:
  static constexpr float kError = 0x1p-20f;

  explicit TangentFilter(const World& world);

  /// Indices of a region's vertices among World::convex_vertices, [first, last).
  struct Range {
    std::size_t first, last;
  };
  [[nodiscard]] Range range_of(ObstacleId region) const { return {starts_[region], starts_[region + 1]}; }

  /// Calls `found(v)` for each convex vertex v with an index in [range.first, range.last) whose line to the convex
  /// vertex of index u is tangent at both, ascending. Exact.
  template <class Found>
  void for_each_tangent(std::size_t u, Range range, const Found& found) const {
    for (std::size_t first = range.first; first < range.last; first += kBlock) {
      // Tests a full block always: the arrays are longer than the number of vertices.
      const std::array<float, kBlock> certainty = refuse(u, first);
      const std::size_t count = std::min(kBlock, range.last - first);
      for (std::size_t k = 0; k < count; ++k)
        if (certainty[k] <= kError && is_tangent_pair(u, first + k)) found(vertices_[first + k]);
    }
  }

 private:
  static constexpr std::size_t kBlock = 16;

  /// How certainly the lines from u to the vertices [first, first + kBlock) are not tangent. More than kError is a
  /// proof.
  [[nodiscard]] std::array<float, kBlock> refuse(std::size_t u, std::size_t first) const;
  [[nodiscard]] bool is_tangent_pair(std::size_t u, std::size_t v) const;

  World world_;
  std::span<const VertexId> vertices_;
  std::vector<std::size_t> starts_;  // one more than regions
  std::vector<float> x_, y_;
  std::vector<float> back_x_, back_y_;    // towards the previous vertex
  std::vector<float> ahead_x_, ahead_y_;  // towards the next
};

}  // namespace arcway::internal

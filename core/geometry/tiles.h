#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "arcway/vec2.h"

namespace arcway::internal {

/// Points in tiles of some dozens along a Hilbert curve: what is near in the plane is near in this order, and so in
/// memory or in time. Order within a tile is left to a stable sort.
class Tiles {
 public:
  Tiles(const Box& box, std::size_t point_count);

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(ranks_.size()); }
  /// The tile of a point, in the order of the curve; points outside of the box count as its nearest.
  [[nodiscard]] std::uint32_t of(const Vec2& p) const;

 private:
  Vec2 origin_;
  Vec2 scale_;
  std::uint32_t side_;
  std::vector<std::uint32_t> ranks_;  // by cell, row by row
};

/// Where items go in the stable order of their tiles.
/// @param tiles  of each item, below tile_count.
std::vector<std::uint32_t> places_by_tile(std::vector<std::uint32_t> tiles, std::uint32_t tile_count);
/// The items' indices in that order.
std::vector<std::uint32_t> sorted_by_tile(std::vector<std::uint32_t> tiles, std::uint32_t tile_count);

}  // namespace arcway::internal

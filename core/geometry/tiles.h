#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "arcway/vec2.h"

namespace arcway::internal {

/// Sorts points into tiles of some dozens along a Hilbert curve, so that points near in the plane are near in memory.
/// The order within a tile is left to a stable sort.
class Tiles {
 public:
  Tiles(const Box& box, std::size_t point_count);

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(ranks_.size()); }
  /// The tile of a point, in the order of the curve. A point outside the box has the tile of the nearest point of the
  /// box.
  [[nodiscard]] std::uint32_t of(const Vec2& p) const;

 private:
  Vec2 origin_;
  Vec2 scale_;
  std::uint32_t side_;
  std::vector<std::uint32_t> ranks_;  // by cell, row by row
};

/// The position of each item in the stable order of tiles.
/// @param tiles  of each item, below tile_count.
std::vector<std::uint32_t> places_by_tile(std::vector<std::uint32_t> tiles, std::uint32_t tile_count);
/// The items' indices in the stable order of tiles.
std::vector<std::uint32_t> sorted_by_tile(std::vector<std::uint32_t> tiles, std::uint32_t tile_count);

}  // namespace arcway::internal

#include "core/geometry/tiles.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace arcway::internal {

namespace {

constexpr std::size_t kPointsPerTile = 64;
constexpr std::uint32_t kMaxSide = 1024;

// Place of a cell on the Hilbert curve through side x side cells; side is a power of two.
std::uint32_t hilbert_rank(std::uint32_t side, std::uint32_t x, std::uint32_t y) {
  std::uint32_t rank = 0;
  for (std::uint32_t half = side / 2; half > 0; half /= 2) {
    const std::uint32_t right = (x & half) > 0 ? 1 : 0;
    const std::uint32_t up = (y & half) > 0 ? 1 : 0;
    rank += half * half * ((3 * right) ^ up);
    if (up == 0) {
      if (right == 1) {
        x = side - 1 - x;
        y = side - 1 - y;
      }
      std::swap(x, y);
    }
  }
  return rank;
}

}  // namespace

Tiles::Tiles(const Box& box, std::size_t point_count) : origin_(box.min), side_(1) {
  while (side_ < kMaxSide && std::size_t{side_} * side_ * kPointsPerTile < point_count) side_ *= 2;
  const Vec2 size = box.max - box.min;
  for (const Eigen::Index axis : {0, 1}) {
    const double scale = side_ / size[axis];
    scale_[axis] = std::isfinite(scale) ? scale : 0.0;
  }
  ranks_.resize(std::size_t{side_} * side_);
  for (std::uint32_t y = 0; y < side_; ++y)
    for (std::uint32_t x = 0; x < side_; ++x) ranks_[y * side_ + x] = hilbert_rank(side_, x, y);
}

std::uint32_t Tiles::of(const Vec2& p) const {
  const double last = side_ - 1;
  const auto x = static_cast<std::uint32_t>(std::clamp((p.x() - origin_.x()) * scale_.x(), 0.0, last));
  const auto y = static_cast<std::uint32_t>(std::clamp((p.y() - origin_.y()) * scale_.y(), 0.0, last));
  return ranks_[y * side_ + x];
}

std::vector<std::uint32_t> places_by_tile(std::vector<std::uint32_t> tiles, std::uint32_t tile_count) {
  std::vector<std::uint32_t> starts(tile_count + 1, 0);
  for (const std::uint32_t tile : tiles) ++starts[tile + 1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  for (std::uint32_t& item : tiles) item = starts[item]++;
  return tiles;
}

std::vector<std::uint32_t> sorted_by_tile(std::vector<std::uint32_t> tiles, std::uint32_t tile_count) {
  const std::vector<std::uint32_t> places = places_by_tile(std::move(tiles), tile_count);
  std::vector<std::uint32_t> order(places.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[places[i]] = i;
  return order;
}

}  // namespace arcway::internal

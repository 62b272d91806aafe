#pragma once

#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry/tiles.h"

namespace arcway::internal {

/// Indices of items grouped by key, as one array with the offset of each group.
class BucketIndex {
 public:
  BucketIndex() = default;
  /// @param keys  key of each item; items with the key `key_count` belong to no group.
  BucketIndex(std::vector<std::uint32_t> keys, std::uint32_t key_count) : first_(key_count + 2, 0) {
    for (const std::uint32_t key : keys) ++first_[key + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    items_ = sorted_by_tile(std::move(keys), key_count + 1);
  }

  /// Indices of the items with a key, ascending.
  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t key) const {
    return std::span(items_).subspan(first_[key], first_[key + 1] - first_[key]);
  }

 private:
  std::vector<std::uint32_t> first_;  // by key
  std::vector<std::uint32_t> items_;
};

}  // namespace arcway::internal

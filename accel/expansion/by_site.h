#pragma once

#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry/tiles.h"

namespace arcway::internal {

/// Items by the site that each of them belongs to.
class BySite {
 public:
  BySite() = default;
  /// @param sites  of each item; those at site_count belong to none.
  BySite(std::vector<std::uint32_t> sites, std::uint32_t site_count) : first_(site_count + 2, 0) {
    for (const std::uint32_t site : sites) ++first_[site + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    items_ = sorted_by_tile(std::move(sites), site_count + 1);
  }

  /// Their indices, ascending.
  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t site) const {
    return std::span(items_).subspan(first_[site], first_[site + 1] - first_[site]);
  }

 private:
  std::vector<std::uint32_t> first_;  // by site
  std::vector<std::uint32_t> items_;
};

}  // namespace arcway::internal

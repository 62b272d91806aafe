#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "arcway/world.h"
#include "core/base/huge_pages.h"
#include "core/base/prefetch.h"

namespace arcway::internal {

/// An index for each circle of a graph, at first kNone. All are forgotten in constant time.
class PerCircle {
 public:
  void reset(std::size_t circles) {
    if (values_.size() < circles) values_.resize(circles, {0, kNone});
    if (++epoch_ == 0) {
      std::fill(values_.begin(), values_.end(), Value{0, kNone});
      epoch_ = 1;
    }
  }
  [[nodiscard]] std::uint32_t get(std::uint32_t circle) const {
    return values_[circle].epoch == epoch_ ? values_[circle].index : kNone;
  }
  /// Prefetches the index of a circle.
  void prefetch(std::uint32_t circle) const { will_need(&values_[circle]); }
  void set(std::uint32_t circle, std::uint32_t index) { values_[circle] = {epoch_, index}; }

 private:
  struct Value {
    std::uint32_t epoch;
    std::uint32_t index;
  };
  HugeVector<Value> values_;
  std::uint32_t epoch_ = 0;
};

}  // namespace arcway::internal

#pragma once

#include <cstddef>
#include <cstdint>

#include "arcway/world.h"
#include "core/base/paged_array.h"
#include "core/base/prefetch.h"

namespace arcway::internal {

/// An index for each circle of a graph, at first kNone. All are forgotten in constant time. Takes memory where indices
/// are set.
class PerCircle {
 public:
  /// Forgets all indices.
  void reset(std::size_t circles) {
    values_.make_room(circles);
    if (++epoch_ == 0) {
      values_.clear();
      epoch_ = 1;
    }
  }
  /// Forgets all indices, and takes the memory of all circles.
  void warm_up(std::size_t circles) {
    reset(circles);
    values_.warm_up(circles);
  }
  [[nodiscard]] std::uint32_t get(std::uint32_t circle) const {
    const Value* const value = values_.find(circle);
    return value != nullptr && value->epoch == epoch_ ? value->index : kNone;
  }
  /// Prefetches the index of a circle.
  void prefetch(std::uint32_t circle) const {
    if (const Value* const value = values_.find(circle)) will_need(value);
  }
  void set(std::uint32_t circle, std::uint32_t index) { values_[circle] = {epoch_, index}; }

 private:
  struct Value {
    std::uint32_t epoch = 0;  // in which it was set; 0: none
    std::uint32_t index = kNone;
  };
  PagedArray<Value> values_;
  std::uint32_t epoch_ = 0;
};

}  // namespace arcway::internal

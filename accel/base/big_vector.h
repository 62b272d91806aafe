#pragma once

#include <new>
#include <utility>
#include <vector>

#include "core/base/huge_pages.h"

namespace arcway::internal {

/// Allocator of large arrays in huge pages. `resize` leaves numbers uninitialized: the arrays are filled once and then
/// read in any order.
template <class T>
class BigAllocator : public HugePageAllocator<T> {
 public:
  BigAllocator() = default;
  template <class U>
  explicit BigAllocator(const BigAllocator<U>& /*other*/) {}

  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    if constexpr (sizeof...(Arguments) == 0) {
      ::new (static_cast<void*>(place)) U;
    } else {
      ::new (static_cast<void*>(place)) U{std::forward<Arguments>(arguments)...};
    }
  }
};

template <class T>
using BigVector = std::vector<T, BigAllocator<T>>;

}  // namespace arcway::internal

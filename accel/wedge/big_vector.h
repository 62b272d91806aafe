#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace [[gnu::visibility("default")]] arcway {

/// Memory for large arrays: in huge pages where the system has some to give, so that neither first touches nor the
/// translation of addresses cost much.
/// @throws std::bad_alloc
void* allocate_big(std::size_t bytes);
void free_big(void* memory, std::size_t bytes);

/// For arrays that are filled once, and not by being resized, and then read all over the place.
template <class T>
class BigAllocator {
 public:
  using value_type = T;

  BigAllocator() = default;
  template <class U>
  explicit BigAllocator(const BigAllocator<U>& /*other*/) {}

  T* allocate(std::size_t count) { return static_cast<T*>(allocate_big(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t count) { free_big(memory, count * sizeof(T)); }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    if constexpr (sizeof...(Arguments) == 0) {
      ::new (static_cast<void*>(place)) U;
    } else {
      ::new (static_cast<void*>(place)) U{std::forward<Arguments>(arguments)...};
    }
  }
  friend bool operator==(const BigAllocator&, const BigAllocator&) { return true; }
};

template <class T>
using BigVector = std::vector<T, BigAllocator<T>>;

}  // namespace arcway

#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

namespace arcway::internal {

/// Observer of the memory mapped for large arrays, for programs that count their memory: none of it passes through
/// operator new. It is told the bytes mapped, and minus the bytes given back, by any thread. Null at first.
inline std::atomic<void (*)(std::ptrdiff_t bytes)> huge_pages_observer{nullptr};

/// Memory for an array, aligned to a cache line; that of large ones is in pages of 2 MB, where the system has them.
/// Some of what was freed is kept for the next array of the same length, see BlockPool.
void* allocate_large(std::size_t bytes);
void free_large(void* memory, std::size_t bytes) noexcept;

/// Allocates large arrays in pages of 2 MB, where the system has them. With small pages, random access misses the
/// processor's address translation cache, which costs as much as the memory access itself. To get a small page from the
/// system costs as much as to fill it. Each large array is mapped on its own, since the heap would keep the memory
/// between two of them.
template <class T>
class HugePageAllocator {
 public:
  using value_type = T;

  HugePageAllocator() = default;
  template <class U>
  explicit HugePageAllocator(const HugePageAllocator<U>&) {}

  T* allocate(std::size_t count) {
    if (count > SIZE_MAX / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(allocate_large(count * sizeof(T)));
  }
  void deallocate(T* memory, std::size_t count) noexcept { free_large(memory, count * sizeof(T)); }

  friend bool operator==(const HugePageAllocator&, const HugePageAllocator&) { return true; }
};

template <class T>
using HugeVector = std::vector<T, HugePageAllocator<T>>;

/// Empties an array but keeps memory for `count` elements.
template <class T>
void empty_with_memory(HugeVector<T>& array, std::size_t count) {
  array.resize(count);
  array.clear();
}

}  // namespace arcway::internal

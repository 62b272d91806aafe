#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace arcway::internal {

/// Observer of the memory mapped for large arrays, for programs that count their memory: none of it passes through
/// operator new. It is told the bytes mapped, and minus the bytes given back, by any thread. Null at first.
inline std::atomic<void (*)(std::ptrdiff_t bytes)> huge_pages_observer{nullptr};

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
    const std::size_t bytes = count * sizeof(T);
    return static_cast<T*>(is_mapped(bytes) ? map(bytes) : ::operator new(bytes, kCacheLine));
  }
  void deallocate(T* memory, std::size_t count) noexcept {
    const std::size_t bytes = count * sizeof(T);
    if (is_mapped(bytes)) {
      unmap(memory, bytes);
    } else {
      ::operator delete(memory, kCacheLine);
    }
  }

  friend bool operator==(const HugePageAllocator&, const HugePageAllocator&) { return true; }

 private:
  static constexpr std::align_val_t kCacheLine{64};
#ifdef __linux__
  static constexpr std::size_t kHugePage = std::size_t{1} << 21;

  static bool is_mapped(std::size_t bytes) { return bytes >= kHugePage; }
  // Lengths are multiples of a huge page, as the remaining small pages would take longer than all others. The unaligned
  // ends are given back.
  static void* map(std::size_t bytes) {
    if (bytes > SIZE_MAX - 2 * kHugePage) throw std::bad_alloc();
    const std::size_t length = whole_pages(bytes);
    void* const mapped = mmap(nullptr, length + kHugePage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED) throw std::bad_alloc();
    char* const begin = static_cast<char*>(mapped);
    const std::size_t before = (kHugePage - reinterpret_cast<std::uintptr_t>(mapped) % kHugePage) % kHugePage;
    if (before > 0) munmap(begin, before);
    munmap(begin + before + length, kHugePage - before);
    madvise(begin + before, length, MADV_HUGEPAGE);
    tell(static_cast<std::ptrdiff_t>(length));
    return begin + before;
  }
  static void unmap(void* memory, std::size_t bytes) noexcept {
    munmap(memory, whole_pages(bytes));
    tell(-static_cast<std::ptrdiff_t>(whole_pages(bytes)));
  }
  static void tell(std::ptrdiff_t bytes) {
    if (auto* const observer = huge_pages_observer.load(std::memory_order_relaxed)) observer(bytes);
  }
  static std::size_t whole_pages(std::size_t bytes) { return (bytes + kHugePage - 1) / kHugePage * kHugePage; }
#else
  static bool is_mapped(std::size_t) { return false; }
  static void* map(std::size_t) { return nullptr; }
  static void unmap(void*, std::size_t) noexcept {}
#endif
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

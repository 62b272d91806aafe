#include "bench/suites/allocations.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "core/base/huge_pages.h"

namespace arcway::internal::bench {
namespace {

std::atomic<std::uint64_t> allocations{0};
std::atomic<std::int64_t> live{0};
std::atomic<std::int64_t> peak{0};

void count(std::ptrdiff_t bytes) {
  const std::int64_t now = live.fetch_add(bytes, std::memory_order_relaxed) + bytes;
  if (bytes < 0) return;
  allocations.fetch_add(1, std::memory_order_relaxed);
  std::int64_t highest = peak.load(std::memory_order_relaxed);
  while (now > highest && !peak.compare_exchange_weak(highest, now, std::memory_order_relaxed)) {
  }
}

[[maybe_unused]] void* counted(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  count(static_cast<std::ptrdiff_t>(malloc_usable_size(memory)));
  return memory;
}

[[maybe_unused]] void release(void* memory) {
  if (memory == nullptr) return;
  count(-static_cast<std::ptrdiff_t>(malloc_usable_size(memory)));
  std::free(memory);
}

[[maybe_unused]] const bool counts_huge_pages = [] {
  huge_pages_observer = count;
  return true;
}();

}  // namespace

HeapUse heap_use() { return {allocations.load(), live.load(), peak.load()}; }
void reset_heap_peak() { peak.store(live.load()); }

}  // namespace arcway::internal::bench

// Sanitizers bring operators of their own; nothing is counted there.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ARCWAY_SANITIZED
#endif
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ARCWAY_SANITIZED
#endif

#ifndef ARCWAY_SANITIZED
void* operator new(std::size_t size) { return arcway::internal::bench::counted(std::malloc(size == 0 ? 1 : size)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  return arcway::internal::bench::counted(std::aligned_alloc(step, (size + step - 1) / step * step));
}
void operator delete(void* memory) noexcept { arcway::internal::bench::release(memory); }
void operator delete(void* memory, std::size_t) noexcept { arcway::internal::bench::release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { arcway::internal::bench::release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { arcway::internal::bench::release(memory); }
#endif

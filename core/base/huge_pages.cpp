#include "core/base/huge_pages.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>

#include "core/base/block_pool.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace arcway::internal {
namespace {

constexpr std::align_val_t kCacheLine{64};
constexpr std::size_t kHugePage = std::size_t{1} << 21;
// From this length on the heap of glibc gives memory back to the system at once; below, it keeps it by itself.
constexpr std::size_t kLarge = std::size_t{1} << 17;
constexpr std::size_t kStep = std::size_t{1} << 16;  // of lengths from there on, so that similar arrays share blocks

// Under a sanitizer nothing is kept, so that it sees who reads what is gone.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kKeeps = false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool kKeeps = false;
#else
constexpr bool kKeeps = true;
#endif
#else
constexpr bool kKeeps = true;
#endif

std::size_t up_to_multiple(std::size_t bytes, std::size_t step) { return (bytes + step - 1) / step * step; }

#ifdef __linux__
void tell(std::ptrdiff_t bytes) {
  if (auto* const observer = huge_pages_observer.load(std::memory_order_relaxed)) observer(bytes);
}

bool is_mapped(std::size_t length) { return length >= kHugePage; }

// The unaligned ends are given back. The first part is in small pages: searches take memory for more than most of them
// need, and to clear one huge page takes as long as a short search.
void* map(std::size_t length) {
  void* const mapped = mmap(nullptr, length + kHugePage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
  char* const begin = static_cast<char*>(mapped);
  const std::size_t before = (kHugePage - reinterpret_cast<std::uintptr_t>(mapped) % kHugePage) % kHugePage;
  if (before > 0) munmap(begin, before);
  munmap(begin + before + length, kHugePage - before);
  if (length > kHugePage) madvise(begin + before + kHugePage, length - kHugePage, MADV_HUGEPAGE);
  tell(static_cast<std::ptrdiff_t>(length));
  return begin + before;
}

void unmap(void* memory, std::size_t length) noexcept {
  munmap(memory, length);
  tell(-static_cast<std::ptrdiff_t>(length));
}
#else
bool is_mapped(std::size_t) { return false; }
void* map(std::size_t) { return nullptr; }
void unmap(void*, std::size_t) noexcept {}
#endif

// Lengths of mapped blocks are multiples of a huge page, as the remaining small pages would take longer than all
// others.
std::size_t length_of(std::size_t bytes) {
  if (bytes > SIZE_MAX - 2 * kHugePage) throw std::bad_alloc();
  return up_to_multiple(bytes, bytes > kHugePage - kStep ? kHugePage : kStep);
}

void* fresh(std::size_t length) { return is_mapped(length) ? map(length) : ::operator new(length, kCacheLine); }

void release(void* memory, std::size_t length) noexcept {
  if (is_mapped(length)) {
    unmap(memory, length);
  } else {
    ::operator delete(memory, kCacheLine);
  }
}

// Never destroyed, as arrays of static objects come back after all else.
constinit BlockPool pool(release);
static_assert(std::is_trivially_destructible_v<BlockPool>);

}  // namespace

void* allocate_large(std::size_t bytes) {
  if (bytes < kLarge) return ::operator new(bytes, kCacheLine);
  const std::size_t length = length_of(bytes);
  if (!kKeeps) return fresh(length);
  if (void* const kept = pool.take(length)) return kept;
  void* const memory = fresh(length);
  pool.add_used(length);
  return memory;
}

void free_large(void* memory, std::size_t bytes) noexcept {
  if (bytes < kLarge) {
    ::operator delete(memory, kCacheLine);
  } else if (kKeeps) {
    pool.give(memory, length_of(bytes));
  } else {
    release(memory, length_of(bytes));
  }
}

}  // namespace arcway::internal

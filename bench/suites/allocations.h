#pragma once

#include <cstdint>

namespace arcway::internal::bench {

/// What this program has asked of the heap, counted by its own operator new and delete, and of the system for large
/// arrays; all threads.
struct HeapUse {
  std::uint64_t allocations = 0;
  std::int64_t live_bytes = 0;
  std::int64_t peak_bytes = 0;  ///< since the last reset
};
HeapUse heap_use();
/// From now on the peak is what is alive now.
void reset_heap_peak();

}  // namespace arcway::internal::bench

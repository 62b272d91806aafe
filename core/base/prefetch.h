#pragma once

namespace arcway::internal {

/// Prefetches the memory at any address for reading or writing.
///
/// GCC drops calls of functions that contain nothing but __builtin_prefetch, as if they had no effect. The empty
/// statement is an effect.
[[gnu::always_inline]] inline void will_need(const void* address) {
  __builtin_prefetch(address);
  asm volatile("" : :);
}

}  // namespace arcway::internal

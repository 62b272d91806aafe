#pragma once

namespace arcway::internal {

/// Says that what lies there will be read or written soon. Any address will do.
///
/// GCC takes a function that does nothing but __builtin_prefetch for one without effect, and drops its calls; the empty
/// statement is an effect.
[[gnu::always_inline]] inline void will_need(const void* address) {
  __builtin_prefetch(address);
  asm volatile("" : :);
}

}  // namespace arcway::internal

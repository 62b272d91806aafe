#pragma once

#include <atomic>
#include <cstddef>
#include <memory>

#include "core/base/huge_pages.h"

namespace arcway::internal {

/// A fixed number of values. Each is made when first asked for, and kept until the cache is destroyed. Lock-free: if
/// two threads make the same value at once, one of the two is dropped. Making a value must therefore have no side
/// effects, and always the same result.
template <class Value>
class SlotCache {
 public:
  explicit SlotCache(std::size_t count) : slots_(count) {}
  SlotCache(const SlotCache&) = delete;
  SlotCache& operator=(const SlotCache&) = delete;
  ~SlotCache() {
    for (const auto& slot : slots_) delete slot.load(std::memory_order_relaxed);
  }

  /// The value of slot i, if it has been made.
  [[nodiscard]] const Value* find(std::size_t i) const { return slots_[i].load(std::memory_order_acquire); }

  /// The value of slot i.
  /// @param make  returns it as a unique_ptr<const Value>; called at most once by each caller.
  template <class Make>
  const Value& get(std::size_t i, Make&& make) const {
    if (const Value* known = find(i)) return *known;
    std::unique_ptr<const Value> made = make();
    const Value* other = nullptr;
    if (slots_[i].compare_exchange_strong(other, made.get(), std::memory_order_acq_rel)) return *made.release();
    return *other;
  }

 private:
  mutable HugeVector<std::atomic<const Value*>> slots_;
};

}  // namespace arcway::internal

#pragma once

#include <atomic>
#include <cstddef>
#include <memory>

#include "core/base/huge_pages.h"

namespace arcway::internal {

/// A fixed number of values, each made when it is first asked for and kept until the cache is destroyed. Any number of
/// threads may ask at once, without locks: where two make the same value, one of the two is dropped, so that making it
/// must have no side effects and always the same result.
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

  /// @param make  gives the value of slot i, a unique_ptr<const Value>; called at most once by each caller.
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

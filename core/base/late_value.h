#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "arcway/executor.h"
#include "arcway/stop_clock.h"

namespace arcway::internal {

/// A value that is made when first asked for, then kept. Thread-safe: one thread makes it while the others wait, each
/// until its own clock is over. If making it is canceled, the next caller makes it anew.
template <class Value>
class LateValue {
 public:
  /// The value; null if the clock was over before it was made.
  /// @param make  returns the value, or throws Canceled if the clock is over before.
  template <class Make>
  const Value* get(const StopClock& clock, Make&& make) const {
    if (const Value* known = known_.load(std::memory_order_acquire)) return known;
    std::unique_lock lock(mutex_, std::defer_lock);
    while (!lock.try_lock()) {
      if (clock.is_over()) return nullptr;
      std::this_thread::sleep_for(kWait);
    }
    if (!value_) {
      try {
        value_.emplace(make());
      } catch (const Canceled&) {
        return nullptr;
      }
      known_.store(&*value_, std::memory_order_release);
    }
    return &*value_;
  }

 private:
  static constexpr std::chrono::microseconds kWait{200};  // between two attempts to lock

  mutable std::mutex mutex_;
  mutable std::optional<Value> value_;  // guarded by mutex_ until it is known
  mutable std::atomic<const Value*> known_ = nullptr;
};

}  // namespace arcway::internal

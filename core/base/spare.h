#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace arcway::internal {

/// The arrays of one object that is gone, for the next one that has most of them in common with it. Thread-safe.
template <class Arrays>
class Spare {
 public:
  /// Null if there are none.
  [[nodiscard]] std::unique_ptr<Arrays> take() {
    const std::lock_guard lock(mutex_);
    return std::move(arrays_);
  }
  /// Replaces those that were given before. @param arrays  must not own this.
  void give(std::unique_ptr<Arrays> arrays) noexcept {
    const std::lock_guard lock(mutex_);
    arrays_.swap(arrays);
  }

 private:
  std::mutex mutex_;
  std::unique_ptr<Arrays> arrays_;
};

}  // namespace arcway::internal

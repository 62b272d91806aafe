#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace arcway::internal {

/// The arrays of one or two objects that are gone, for the next ones that have most of them in common with them.
/// Thread-safe.
template <class Arrays>
class Spare {
 public:
  /// Those that were given last. Null if there are none.
  [[nodiscard]] std::unique_ptr<Arrays> take() {
    const std::lock_guard lock(mutex_);
    std::unique_ptr<Arrays> taken = std::move(last_);
    last_ = std::move(other_);
    return taken;
  }
  /// Of three, the first ones are dropped. @param arrays  must not own this.
  void give(std::unique_ptr<Arrays> arrays) noexcept {
    std::unique_ptr<Arrays> dropped;
    const std::lock_guard lock(mutex_);
    dropped = std::move(other_);
    other_ = std::move(last_);
    last_ = std::move(arrays);
  }

 private:
  std::mutex mutex_;
  std::unique_ptr<Arrays> last_, other_;
};

}  // namespace arcway::internal

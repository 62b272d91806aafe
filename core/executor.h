#pragma once

#include <cstddef>
#include <functional>

namespace arcway {

/// Runs loops whose iterations are independent. Every builder of core takes one and writes each
/// iteration's result to a place of its own, so that results do not depend on the executor.
class Executor {
 public:
  virtual ~Executor() = default;
  /// Calls body(begin, end) on disjoint ranges that cover [0, count), perhaps at the same time on
  /// several threads, and returns when all are done. An exception of the body is passed on.
  /// @param grain  smallest sensible range, >= 1.
  virtual void for_ranges(std::size_t count, std::size_t grain,
                          const std::function<void(std::size_t, std::size_t)>& body) const = 0;
};

/// One range, on the calling thread.
class SerialExecutor final : public Executor {
 public:
  void for_ranges(std::size_t count, std::size_t /*grain*/,
                  const std::function<void(std::size_t, std::size_t)>& body) const override {
    if (count > 0) body(0, count);
  }
};

}  // namespace arcway

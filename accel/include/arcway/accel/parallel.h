#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "arcway/executor.h"
#include "arcway/export.h"

namespace arcway {

/// Runs loops in parallel on oneTBB. Nothing global is set: no thread count, no scheduler.
///
///     const TbbExecutor two_threads(2);
///     const Planner planner(world, vehicle, accel_backend(world, two_threads));
///
/// Every builder that takes an executor gives the same bits for any number of threads. Thread-safe.
class ARCWAY_API TbbExecutor final : public Executor {
 public:
  /// Uses the arena of the calling thread, so that the caller's tbb::task_arena and tbb::global_control decide.
  TbbExecutor();
  /// Makes an arena for this many threads, the caller included, but no more than the process is allowed. That is the
  /// number of the machine, unless the application has a tbb::global_control.
  /// @throws std::invalid_argument unless 1 <= threads <= 1024.
  explicit TbbExecutor(std::size_t threads);
  ~TbbExecutor() override;
  TbbExecutor(const TbbExecutor&) = delete;
  TbbExecutor& operator=(const TbbExecutor&) = delete;

  void for_ranges(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) const override;

  /// Number of threads that a loop started here can use.
  [[nodiscard]] std::size_t threads() const;

 private:
  struct Arena;
  std::unique_ptr<Arena> arena_;  ///< null: the caller's
};

}  // namespace arcway

#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <stop_token>
#include <utility>

#include "arcway/export.h"
#include "arcway/stop_clock.h"

namespace arcway {

/// Runs loops whose iterations are independent of each other. Every builder of core takes an executor and writes the
/// result of each iteration to its own place, so that results do not depend on the executor.
class ARCWAY_API Executor {
 public:
  virtual ~Executor() = default;
  /// Calls body(begin, end) on disjoint ranges that cover [0, count), perhaps on several threads at once, and returns
  /// when all are done. An exception of the body is passed on. The body may run loops on the same executor.
  /// @param grain  smallest range worth a call, >= 1.
  virtual void for_ranges(std::size_t count, std::size_t grain,
                          const std::function<void(std::size_t, std::size_t)>& body) const = 0;
  /// Names the loops that follow, for progress displays: "bitangents".
  virtual void begin_stage(const char* /*name*/) const {}
  /// When the work has to end. Long serial parts of builders ask it, see end_if_over.
  [[nodiscard]] virtual StopClock clock() const { return {}; }
};

/// Runs a loop as one range on the calling thread.
class ARCWAY_API SerialExecutor final : public Executor {
 public:
  void for_ranges(std::size_t count, std::size_t /*grain*/,
                  const std::function<void(std::size_t, std::size_t)>& body) const override {
    if (count > 0) body(0, count);
  }
};

/// A serial executor that lives as long as the program.
inline const SerialExecutor kSerialExecutor;

/// Runs loops on threads of the standard library. Each loop starts its threads and joins them, some 50 us: for work of
/// milliseconds, as a batch of queries or the building of a graph. accel's TbbExecutor keeps its threads and balances
/// nested loops; here those run on the thread that meets them. Thread-safe.
class ARCWAY_API ThreadExecutor final : public Executor {
 public:
  /// As many threads as the machine runs at once.
  ThreadExecutor();
  /// @param threads  the caller included.
  /// @throws std::invalid_argument unless 1 <= threads <= 1024.
  explicit ThreadExecutor(std::size_t threads);
  /// An exception of the body ends the loop before its next range, and the first one is thrown here.
  void for_ranges(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) const override;
  /// Number of threads of a loop, the caller included.
  [[nodiscard]] std::size_t threads() const { return threads_; }

 private:
  std::size_t threads_;
};

/// Thrown by work that was canceled.
class ARCWAY_API Canceled : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws if the executor's clock is over: for serial parts of builders.
/// @throws Canceled
inline void end_if_over(const Executor& executor) {
  if (executor.clock().is_over()) throw Canceled("canceled");
}
/// Throws if the ticker's clock is over: for loops of short iterations.
/// @throws Canceled
inline void end_if_over(StopTicker& ticker) {
  if (ticker.is_over()) throw Canceled("canceled");
}

/// Calls two functions that do not depend on each other, at the same time if the executor can.
template <class First, class Second>
void run_both(const Executor& executor, First&& first, Second&& second) {
  executor.for_ranges(2, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t task = begin; task < end; ++task) task == 0 ? first() : second();
  });
}

/// Runs loops on another executor, and ends them at a stop request or a deadline. The other executor's clock ends them
/// too. It asks the clock before each piece of a range; pieces grow and shrink so that each takes about kPieceSeconds.
class ARCWAY_API StoppableExecutor final : public Executor {
 public:
  /// Time of a piece [s]: a stop waits for one on each thread, or for one grain if that takes longer. Each piece asks
  /// the clock twice, some 50 ns, so that much smaller ones cost time.
  static constexpr double kPieceSeconds = 200e-6;

  /// @param executor  must outlive this one.
  StoppableExecutor(const Executor& executor, std::stop_token stop)
      : StoppableExecutor(executor, StopClock(std::numeric_limits<double>::infinity(), std::move(stop))) {}
  StoppableExecutor(const Executor& executor, StopClock clock) : executor_(executor), clock_(std::move(clock)) {}

  void begin_stage(const char* name) const override { executor_.begin_stage(name); }
  [[nodiscard]] StopClock clock() const override { return clock_.first_of(executor_.clock()); }
  /// @throws Canceled once its own clock is over, after all running pieces have ended.
  void for_ranges(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) const override {
    using Clock = StopClock::Clock;
    const std::size_t least = std::max<std::size_t>(grain, 1);
    executor_.for_ranges(count, grain, [&](std::size_t begin, std::size_t end) {
      std::size_t piece = least;
      for (std::size_t first = begin; first < end;) {
        if (clock_.is_over()) throw Canceled("canceled");
        const auto piece_begin = Clock::now();
        const std::size_t last = first + std::min(piece, end - first);
        body(first, last);
        first = last;
        const bool was_short = Clock::now() - piece_begin < std::chrono::duration<double>(0.5 * kPieceSeconds);
        piece = was_short ? 2 * piece : std::max(least, piece / 2);
      }
    });
  }

 private:
  const Executor& executor_;
  StopClock clock_;
};

}  // namespace arcway

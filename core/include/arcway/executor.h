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

/// Runs loops whose iterations are independent. Every builder of core takes one and writes each
/// iteration's result to a place of its own, so that results do not depend on the executor.
class ARCWAY_API Executor {
 public:
  virtual ~Executor() = default;
  /// Calls body(begin, end) on disjoint ranges that cover [0, count), perhaps at the same time on
  /// several threads, and returns when all are done. An exception of the body is passed on. The body may run loops
  /// of its own on the same executor.
  /// @param grain  smallest sensible range, >= 1.
  virtual void for_ranges(std::size_t count, std::size_t grain,
                          const std::function<void(std::size_t, std::size_t)>& body) const = 0;
  /// What the loops that follow are for, for who watches: "bitangents".
  virtual void begin_stage(const char* /*name*/) const {}
  /// Says when the work has to end: for long serial parts of builders, see end_if_over, and long single pieces.
  [[nodiscard]] virtual StopClock clock() const { return {}; }
};

/// One range, on the calling thread.
class ARCWAY_API SerialExecutor final : public Executor {
 public:
  void for_ranges(std::size_t count, std::size_t /*grain*/,
                  const std::function<void(std::size_t, std::size_t)>& body) const override {
    if (count > 0) body(0, count);
  }
};

/// For whoever keeps a reference for longer than a call.
inline const SerialExecutor kSerialExecutor;

/// Thrown by work that was canceled.
class ARCWAY_API Canceled : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Ends a serial part of a build that has to end. @throws Canceled
inline void end_if_over(const Executor& executor) {
  if (executor.clock().is_over()) throw Canceled("canceled");
}
/// The same in a loop of short rounds.
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

/// Another executor's loops, ended by a stop token or a deadline, and by the other executor's clock. Asks before each
/// piece of a range; pieces grow and shrink so that each takes about kPieceSeconds.
class ARCWAY_API StoppableExecutor final : public Executor {
 public:
  /// What a stop waits for on each thread, unless a single grain takes longer [s]. Smaller pieces cost time: each asks
  /// the clock twice, some 50 ns.
  static constexpr double kPieceSeconds = 200e-6;

  /// @param executor  must outlive this one.
  StoppableExecutor(const Executor& executor, std::stop_token stop)
      : StoppableExecutor(executor, StopClock(std::numeric_limits<double>::infinity(), std::move(stop))) {}
  StoppableExecutor(const Executor& executor, StopClock clock) : executor_(executor), clock_(std::move(clock)) {}

  void begin_stage(const char* name) const override { executor_.begin_stage(name); }
  [[nodiscard]] StopClock clock() const override { return clock_.first_of(executor_.clock()); }
  /// @throws Canceled once its own clock is over, when all pieces under way have ended.
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

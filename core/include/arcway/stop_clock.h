#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>

#include "arcway/export.h"

namespace arcway {

/// Says when work has to end: at a deadline, or once a stop is requested. Once over, it stays over. Thread-safe; a copy
/// is a few words. Asking reads the system's clock, some 25 ns. Every loop that can take longer than a millisecond asks
/// once an iteration, or through a StopTicker if its iterations are short.
class ARCWAY_API StopClock {
 public:
  using Clock = std::chrono::steady_clock;

  /// A clock that is never over.
  StopClock() = default;
  /// @param seconds  from now on [s]; infinity: no deadline. Negative numbers count as 0. Precondition: not NaN.
  /// @param stop  may be requested from any thread.
  explicit StopClock(double seconds, std::stop_token stop = {}) : stop_(std::move(stop)) {
    const auto now = Clock::now();
    const std::chrono::duration<double> limit(seconds > 0.0 ? seconds : 0.0);
    if (limit < kNever - now) deadline_ = now + std::chrono::duration_cast<Clock::duration>(limit);
  }

  [[nodiscard]] bool is_over() const {
    return stop_.stop_requested() || (deadline_ != kNever && Clock::now() >= deadline_) ||
           (beside_ && beside_->is_over());
  }
  /// Time until the deadline [s]: negative after it, infinity without one.
  [[nodiscard]] double seconds_left() const {
    if (deadline_ == kNever) return std::numeric_limits<double>::infinity();
    return std::chrono::duration<double>(deadline_ - Clock::now()).count();
  }
  /// A clock with the same deadline and another stop token.
  [[nodiscard]] StopClock with_stop(std::stop_token stop) const {
    StopClock other;
    other.deadline_ = deadline_;
    other.stop_ = std::move(stop);
    return other;
  }
  /// A clock that is over as soon as one of the two is.
  [[nodiscard]] StopClock first_of(const StopClock& other) const {
    StopClock first = *this;
    first.deadline_ = std::min(deadline_, other.deadline_);
    if (!can_be_stopped()) {
      first.stop_ = other.stop_;
      first.beside_ = other.beside_;
    } else if (other.can_be_stopped()) {
      first.beside_ = std::make_shared<const StopClock>(beside_ ? beside_->first_of(other) : other);
    }
    return first;
  }

 private:
  [[nodiscard]] bool can_be_stopped() const { return stop_.stop_possible() || beside_; }

  static constexpr Clock::time_point kNever = Clock::time_point::max();

  std::stop_token stop_;
  Clock::time_point deadline_ = kNever;
  std::shared_ptr<const StopClock> beside_;  // may be null: another stop, where there are two
};

/// Asks a clock once in kEvery iterations, at a cost below a nanosecond an iteration. For loops whose iterations take
/// at most some microseconds. For one thread.
class ARCWAY_API StopTicker {
 public:
  static constexpr int kEvery = 64;

  /// @param clock  must outlive this.
  explicit StopTicker(const StopClock& clock) : clock_(clock) {}

  [[nodiscard]] bool is_over() {
    if (--left_ <= 0) {
      left_ = kEvery;
      over_ = clock_.is_over();
    }
    return over_;
  }

 private:
  const StopClock& clock_;
  int left_ = 1;  // the first round asks
  bool over_ = false;
};

/// The time for work that remains once a clock is over, such as the clearance of the path found. It ends half a
/// millisecond and a small share of the time limit later. For one thread.
class ARCWAY_API Grace {
 public:
  static constexpr double kSeconds = 5e-4;  // [s]; the clearance of a path of 25 segments takes as long
  static constexpr double kShare = 0.05;    // of the time limit

  /// @param clock  must outlive this.
  /// @param limit  of the clock [s]; infinity: none.
  Grace(const StopClock& clock, double limit)
      : clock_(clock), seconds_(kSeconds + (std::isfinite(limit) ? kShare * limit : 0.0)) {}

  [[nodiscard]] bool is_over() {
    if (!end_ && clock_.is_over()) end_.emplace(seconds_);
    return end_ && end_->is_over();
  }

 private:
  const StopClock& clock_;
  double seconds_;
  std::optional<StopClock> end_;  // once the clock is over
};

}  // namespace arcway

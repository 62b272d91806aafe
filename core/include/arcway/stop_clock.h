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

/// Says when work has to end: at a deadline, or once a stop is requested. Once over it stays over. A copy takes a few
/// words; any thread may ask. Asking reads the system's clock, some 25 ns: every loop that can take longer than a
/// millisecond asks once a round, one with shorter rounds by way of a StopTicker.
class ARCWAY_API StopClock {
 public:
  using Clock = std::chrono::steady_clock;

  /// Never over.
  StopClock() = default;
  /// @param seconds  from now on; infinity: no deadline. Negative ones count as 0. Precondition: not NaN.
  /// @param stop     may be asked from any thread.
  explicit StopClock(double seconds, std::stop_token stop = {}) : stop_(std::move(stop)) {
    const auto now = Clock::now();
    const std::chrono::duration<double> limit(seconds > 0.0 ? seconds : 0.0);
    if (limit < kNever - now) deadline_ = now + std::chrono::duration_cast<Clock::duration>(limit);
  }

  [[nodiscard]] bool is_over() const {
    return stop_.stop_requested() || (deadline_ != kNever && Clock::now() >= deadline_) ||
           (beside_ && beside_->is_over());
  }
  /// Until the deadline [s], negative behind it; infinity where there is none.
  [[nodiscard]] double seconds_left() const {
    if (deadline_ == kNever) return std::numeric_limits<double>::infinity();
    return std::chrono::duration<double>(deadline_ - Clock::now()).count();
  }
  /// The same deadline, with another stop.
  [[nodiscard]] StopClock with_stop(std::stop_token stop) const {
    StopClock other;
    other.deadline_ = deadline_;
    other.stop_ = std::move(stop);
    return other;
  }
  /// Over as soon as this one or another one is.
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

/// Asks a clock once in kEvery iterations of a loop: below a nanosecond a round. For rounds of at most some
/// microseconds. For one thread.
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

/// What is left to do about a result once its clock is over: work that ends soon after, within some milliseconds and a
/// small share of the time limit. For one thread.
class ARCWAY_API Grace {
 public:
  static constexpr double kSeconds = 2e-3;  // [s]: the clearance of a path of a hundred segments
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

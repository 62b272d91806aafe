#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <stop_token>
#include <utility>

namespace [[gnu::visibility("default")]] arcway {

/// Runs loops whose iterations are independent. Every builder of core takes one and writes each
/// iteration's result to a place of its own, so that results do not depend on the executor.
class Executor {
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
};

/// One range, on the calling thread.
class SerialExecutor final : public Executor {
 public:
  void for_ranges(std::size_t count, std::size_t /*grain*/,
                  const std::function<void(std::size_t, std::size_t)>& body) const override {
    if (count > 0) body(0, count);
  }
};

/// Calls two functions that do not depend on each other, at the same time if the executor can.
template <class First, class Second>
void run_both(const Executor& executor, First&& first, Second&& second) {
  executor.for_ranges(2, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t task = begin; task < end; ++task) task == 0 ? first() : second();
  });
}

/// Thrown by work that was cancelled.
class Cancelled : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Another executor's loops, ended by a stop token: asked for before each piece of at most 64 grains.
class StoppableExecutor final : public Executor {
 public:
  /// @param executor  must outlive this one.
  StoppableExecutor(const Executor& executor, std::stop_token stop) : executor_(executor), stop_(std::move(stop)) {}

  void begin_stage(const char* name) const override { executor_.begin_stage(name); }
  /// @throws Cancelled once a stop is requested, when all pieces under way have ended.
  void for_ranges(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) const override {
    const std::size_t piece = 64 * std::max<std::size_t>(grain, 1);
    executor_.for_ranges(count, grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t first = begin; first < end; first += std::min(piece, end - first)) {
        if (stop_.stop_requested()) throw Cancelled("cancelled");
        body(first, first + std::min(piece, end - first));
      }
    });
  }

 private:
  const Executor& executor_;
  std::stop_token stop_;
};

}  // namespace arcway

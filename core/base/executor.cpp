#include "arcway/executor.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace arcway {

namespace {

constexpr std::size_t kMaxThreads = 1024;

// Whether this thread runs a loop of a ThreadExecutor.
thread_local bool is_in_loop = false;

// A loop that several threads work on, range by range.
class SharedLoop {
 public:
  SharedLoop(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body)
      : count_(count), grain_(grain), body_(body) {}

  void work() {
    is_in_loop = true;
    try {
      for (std::size_t range = next_++; range <= (count_ - 1) / grain_; range = next_++)
        body_(range * grain_, range * grain_ + std::min(grain_, count_ - range * grain_));
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      next_ = (count_ - 1) / grain_ + 1;
    }
    is_in_loop = false;
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::size_t count_, grain_;
  const std::function<void(std::size_t, std::size_t)>& body_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

ThreadExecutor::ThreadExecutor()
    : ThreadExecutor(std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, kMaxThreads)) {}

ThreadExecutor::ThreadExecutor(std::size_t threads) : threads_(threads) {
  if (threads < 1 || threads > kMaxThreads)
    throw std::invalid_argument("executor: " + std::to_string(threads) + " threads, must be 1 to " +
                                std::to_string(kMaxThreads));
}

void ThreadExecutor::for_ranges(std::size_t count, std::size_t grain,
                                const std::function<void(std::size_t, std::size_t)>& body) const {
  if (count == 0) return;
  const std::size_t least = std::max<std::size_t>(grain, 1), ranges = (count - 1) / least + 1;
  const std::size_t helpers = std::min(threads_, ranges) - 1;
  if (is_in_loop || helpers == 0) return body(0, count);
  SharedLoop loop(count, least, body);
  {
    std::vector<std::jthread> threads;
    threads.reserve(helpers);
    for (std::size_t i = 0; i < helpers; ++i) threads.emplace_back([&loop] { loop.work(); });
    loop.work();
  }
  loop.rethrow();
}

}  // namespace arcway

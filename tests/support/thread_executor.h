#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "arcway/executor.h"

namespace arcway::internal::test {

/// Runs loops on plain threads, which the thread sanitizer understands. Bodies must not throw.
class ThreadExecutor final : public Executor {
 public:
  explicit ThreadExecutor(std::size_t threads) : threads_(threads) {}

  void for_ranges(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) const override {
    std::atomic<std::size_t> next = 0;
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < threads_; ++t) {
      threads.emplace_back([&] {
        for (std::size_t begin = next.fetch_add(grain); begin < count; begin = next.fetch_add(grain))
          body(begin, std::min(begin + grain, count));
      });
    }
    for (std::thread& thread : threads) thread.join();
  }

 private:
  std::size_t threads_;
};

}  // namespace arcway::internal::test

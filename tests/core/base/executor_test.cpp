#include "arcway/executor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <limits>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace arcway::internal {
namespace {

TEST(ThreadExecutor, CallsEachIndexOnce) {
  for (const std::size_t threads : {1u, 2u, 5u}) {
    for (const std::size_t count : {0u, 1u, 7u, 1000u}) {
      for (const std::size_t grain : {0u, 1u, 3u, 2000u}) {
        std::vector<std::atomic<int>> calls(count);
        ThreadExecutor(threads).for_ranges(count, grain, [&](std::size_t begin, std::size_t end) {
          ASSERT_LE(end, count);
          for (std::size_t i = begin; i < end; ++i) ++calls[i];
        });
        for (const std::atomic<int>& call : calls) EXPECT_EQ(call, 1);
      }
    }
  }
  std::size_t covered = 0;
  ThreadExecutor(1).for_ranges(std::numeric_limits<std::size_t>::max(), 1,
                               [&](std::size_t begin, std::size_t end) { covered += end - begin; });
  EXPECT_EQ(covered, std::numeric_limits<std::size_t>::max());
}

TEST(ThreadExecutor, RunsAsManyThreadsAtOnce) {
  std::atomic<int> arrived = 0;
  std::mutex mutex;
  std::set<std::thread::id> threads;
  ThreadExecutor(3).for_ranges(3, 1, [&](std::size_t, std::size_t) {
    ++arrived;
    while (arrived < 3) std::this_thread::yield();  // each waits for the others
    const std::lock_guard lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(threads.size(), 3u);
  EXPECT_GE(ThreadExecutor().threads(), 1u);
}

TEST(ThreadExecutor, RunsNestedLoopsOnTheSameThread) {
  const ThreadExecutor executor(4);
  std::atomic<int> sum = 0;
  executor.for_ranges(8, 1, [&](std::size_t, std::size_t) {
    const std::thread::id outer = std::this_thread::get_id();
    executor.for_ranges(10, 1, [&](std::size_t begin, std::size_t end) {
      EXPECT_EQ(std::this_thread::get_id(), outer);
      sum += static_cast<int>(end - begin);
    });
  });
  EXPECT_EQ(sum, 80);
}

TEST(ThreadExecutor, PassesAnExceptionOnAndCanBeUsedAgain) {
  const ThreadExecutor executor(3);
  constexpr int kCalls = 100'000;
  std::atomic<int> calls = 0;
  const auto fail = [&](std::size_t begin, std::size_t) {
    ++calls;
    if (begin == 5) throw std::runtime_error("five");
    // The thread that fails may be interrupted: the others must not be done before it goes on.
    std::this_thread::sleep_for(std::chrono::microseconds(1));
  };
  EXPECT_THROW(executor.for_ranges(kCalls, 1, fail), std::runtime_error);
  EXPECT_LT(calls, kCalls);
  calls = 0;
  executor.for_ranges(5, 1, fail);
  EXPECT_EQ(calls, 5);
  EXPECT_THROW(ThreadExecutor(0), std::invalid_argument);
  EXPECT_THROW(ThreadExecutor(1025), std::invalid_argument);
}

}  // namespace
}  // namespace arcway::internal

#include "arcway/accel/parallel.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace arcway::internal {
namespace {

std::vector<int> visits_of(const Executor& executor, std::size_t count, std::size_t grain) {
  std::vector<int> visits(count, 0);
  executor.for_ranges(count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) ++visits[i];
  });
  return visits;
}

TEST(TbbExecutor, VisitsEachIndexOnce) {
  const tbb::global_control eight(tbb::global_control::max_allowed_parallelism, 8);
  for (const std::size_t threads : {1u, 2u, 3u, 8u}) {
    const TbbExecutor executor(threads);
    EXPECT_EQ(executor.threads(), threads);
    for (const std::size_t count : {0u, 1u, 7u, 10'000u}) {
      EXPECT_EQ(visits_of(executor, count, 1), std::vector<int>(count, 1));
      EXPECT_EQ(visits_of(executor, count, 64), std::vector<int>(count, 1));
    }
  }
  EXPECT_EQ(visits_of(TbbExecutor(), 1000, 3), std::vector<int>(1000, 1));
}

TEST(TbbExecutor, RunsInTheCallersArenaUnlessToldHowManyThreads) {
  const tbb::global_control eight(tbb::global_control::max_allowed_parallelism, 8);
  const TbbExecutor callers;
  tbb::task_arena arena(3);
  EXPECT_EQ(arena.execute([&] { return callers.threads(); }), 3u);
  EXPECT_EQ(arena.execute([] { return TbbExecutor(5).threads(); }), 5u);
}

TEST(TbbExecutor, PassesExceptionsOn) {
  const auto fail = [](std::size_t, std::size_t) { throw std::runtime_error("from the body"); };
  EXPECT_THROW(TbbExecutor(2).for_ranges(100, 1, fail), std::runtime_error);
}

TEST(RunBoth, CallsEachOnceOnAnyExecutor) {
  const SerialExecutor serial;
  const TbbExecutor one(1), two(2);
  for (const Executor* executor : std::initializer_list<const Executor*>{&serial, &one, &two}) {
    std::atomic<int> first = 0, second = 0;
    run_both(
        *executor, [&] { ++first; },
        [&] {
          run_both(
              *executor, [&] { ++first; }, [&] { ++second; });
        });
    EXPECT_EQ(first, 2);
    EXPECT_EQ(second, 1);
    EXPECT_THROW(run_both(
                     *executor, [] { throw std::runtime_error("from the first"); }, [] {}),
                 std::runtime_error);
    EXPECT_THROW(run_both(
                     *executor, [] {}, [] { throw std::runtime_error("from the second"); }),
                 std::runtime_error);
  }
}

TEST(TbbExecutor, RefusesThreadCountsOutOfRange) {
  EXPECT_THROW(TbbExecutor(0), std::invalid_argument);
  EXPECT_THROW(TbbExecutor(1025), std::invalid_argument);
}

TEST(TbbExecutor, ChangesNoGlobalThreadCount) {
  const auto allowed = [] { return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism); };
  const std::size_t before = allowed();
  const TbbExecutor executor(1);
  EXPECT_EQ(visits_of(executor, 100, 1), std::vector<int>(100, 1));
  EXPECT_EQ(allowed(), before);
}

}  // namespace
}  // namespace arcway::internal

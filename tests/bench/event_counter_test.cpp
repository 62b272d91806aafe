#include "bench/event_counter.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <thread>

#include "bench/cpu_clock.h"

namespace arcway::internal::bench {
namespace {

TEST(EventCounter, CountsThreadsThatStartLater) {
  // The clock of a task is counted by the kernel itself, also where the processor's events are not.
  const EventCounter clock(PERF_TYPE_SOFTWARE, PERF_COUNT_SW_TASK_CLOCK);
  const std::optional<std::uint64_t> before = clock.value();
  if (!before) GTEST_SKIP() << "the kernel lets nobody count";
  double used = 0.0;  // [s]
  std::thread thread([&used] {
    const CpuClock own(CpuClock::Of::kThread);
    volatile unsigned sum = 0;
    for (unsigned i = 0; i < 50'000'000; ++i) sum = sum + i;
    used = own.seconds();
  });
  thread.join();
  const std::optional<std::uint64_t> after = clock.value();
  ASSERT_TRUE(after);
  ASSERT_GT(used, 0.0);
  EXPECT_GE(static_cast<double>(*after - *before), 0.5e9 * used);
}

TEST(EventCounter, HasNoValueOfWhatIsNotCounted) {
  const EventCounter none(PERF_TYPE_SOFTWARE, 123'456);
  EXPECT_EQ(none.value(), std::nullopt);
}

}  // namespace
}  // namespace arcway::internal::bench

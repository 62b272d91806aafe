#include "bench/event_counter.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <thread>

namespace arcway::internal::bench {
namespace {

// The clock of a task is counted by the kernel itself, also where the processor's events are not.
std::optional<std::uint64_t> nanoseconds_of(const EventCounter& clock, int rounds) {
  const std::optional<std::uint64_t> before = clock.value();
  std::thread thread([rounds] {
    volatile int sum = 0;
    for (int i = 0; i < rounds; ++i) sum = sum + i;
  });
  thread.join();
  const std::optional<std::uint64_t> after = clock.value();
  return before && after ? std::optional(*after - *before) : std::nullopt;
}

TEST(EventCounter, CountsThreadsThatStartLater) {
  const EventCounter clock(PERF_TYPE_SOFTWARE, PERF_COUNT_SW_TASK_CLOCK);
  if (!clock.value()) GTEST_SKIP() << "the kernel lets nobody count";
  const std::optional<std::uint64_t> few = nanoseconds_of(clock, 1'000), many = nanoseconds_of(clock, 50'000'000);
  ASSERT_TRUE(few && many);
  EXPECT_GT(*few, 0u);
  EXPECT_GT(*many, 10 * *few);
}

TEST(EventCounter, HasNoValueOfWhatIsNotCounted) {
  const EventCounter none(PERF_TYPE_SOFTWARE, 123'456);
  EXPECT_EQ(none.value(), std::nullopt);
}

}  // namespace
}  // namespace arcway::internal::bench

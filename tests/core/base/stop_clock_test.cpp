#include "arcway/stop_clock.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <limits>
#include <stop_token>
#include <thread>

#include "arcway/executor.h"
#include "core/base/late_value.h"

namespace arcway::internal {
namespace {

TEST(StopClock, IsOverAtItsDeadlineOrWhenStopped) {
  EXPECT_FALSE(StopClock().is_over());
  EXPECT_EQ(StopClock().seconds_left(), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(StopClock(0.0).is_over());
  EXPECT_TRUE(StopClock(-1.0).is_over());
  EXPECT_LE(StopClock(0.0).seconds_left(), 0.0);
  EXPECT_FALSE(StopClock(1e300).is_over());
  std::stop_source stop;
  const StopClock clock(1e300, stop.get_token());
  EXPECT_FALSE(clock.is_over());
  stop.request_stop();
  EXPECT_TRUE(clock.is_over());
  EXPECT_FALSE(clock.with_stop({}).is_over());
}

TEST(StopClock, OfSeveralIsOverWithTheFirstOfThem) {
  EXPECT_FALSE(StopClock().first_of({}).is_over());
  EXPECT_TRUE(StopClock(0.0).first_of({}).is_over());
  EXPECT_TRUE(StopClock().first_of(StopClock(0.0)).is_over());
  EXPECT_LE(StopClock(1e9).first_of(StopClock(0.0)).seconds_left(), 0.0);
  EXPECT_LE(StopClock(0.0).first_of(StopClock(1e9)).seconds_left(), 0.0);
  constexpr std::size_t kCount = 3;
  for (std::size_t stopped = 0; stopped < kCount; ++stopped)
    for (const bool nested : {false, true}) {
      std::array<std::stop_source, kCount> stops;
      std::array<StopClock, kCount> clocks;
      for (std::size_t i = 0; i < kCount; ++i) clocks[i] = StopClock(1e300, stops[i].get_token());
      const StopClock first = nested ? clocks[0].first_of(clocks[1].first_of(clocks[2]))
                                     : clocks[0].first_of(clocks[1]).first_of(clocks[2]);
      EXPECT_FALSE(first.is_over());
      stops[stopped].request_stop();
      EXPECT_TRUE(first.is_over()) << stopped;
      EXPECT_TRUE(StopClock().first_of(first).is_over()) << stopped;
      EXPECT_FALSE(first.with_stop({}).is_over());
    }
}

TEST(StopTicker, AsksAtOnceAndThenOnceInAWhile) {
  std::stop_source stop;
  const StopClock clock(1e300, stop.get_token());
  StopTicker ticker(clock);
  EXPECT_FALSE(ticker.is_over());
  stop.request_stop();
  int rounds = 1;
  while (!ticker.is_over()) ++rounds;
  EXPECT_EQ(rounds, StopTicker::kEvery);
  EXPECT_TRUE(StopTicker(clock).is_over());
}

TEST(Grace, BeginsWhenTheClockIsOver) {
  std::stop_source stop;
  const StopClock clock(std::numeric_limits<double>::infinity(), stop.get_token());
  Grace grace(clock, 1e9);
  EXPECT_FALSE(grace.is_over());
  stop.request_stop();
  EXPECT_FALSE(grace.is_over());  // a share of the limit is left
}

TEST(StoppableExecutor, EndsAtItsClock) {
  const SerialExecutor serial;
  std::stop_source stop;
  const StoppableExecutor executor(serial, StopClock(1e300, stop.get_token()));
  EXPECT_FALSE(executor.clock().is_over());
  std::size_t done = 0;
  const auto stop_at_once = [&](std::size_t begin, std::size_t end) {
    done += end - begin;
    stop.request_stop();
  };
  EXPECT_THROW(executor.for_ranges(1000000, 16, stop_at_once), Canceled);
  EXPECT_EQ(done, 16u);  // a single piece of one grain
  EXPECT_TRUE(executor.clock().is_over());
  EXPECT_THROW(end_if_over(executor), Canceled);
}

TEST(StoppableExecutor, HearsTheClockOfTheOneInside) {
  const SerialExecutor serial;
  std::stop_source inner_stop, outer_stop;
  const StoppableExecutor inner(serial, inner_stop.get_token());
  const StoppableExecutor outer(inner, outer_stop.get_token());
  EXPECT_FALSE(outer.clock().is_over());
  inner_stop.request_stop();
  EXPECT_TRUE(outer.clock().is_over());
  EXPECT_THROW(end_if_over(outer), Canceled);
  const StoppableExecutor late(serial, StopClock(0.0));
  EXPECT_LE(StoppableExecutor(late, StopClock(1e9)).clock().seconds_left(), 0.0);
}

TEST(StoppableExecutor, CoversAllOnceInGrowingPieces) {
  const SerialExecutor serial;
  const StoppableExecutor executor(serial, StopClock());
  std::size_t next = 0, pieces = 0;
  executor.for_ranges(100000, 1, [&](std::size_t begin, std::size_t end) {
    EXPECT_EQ(begin, next);
    next = end;
    ++pieces;
  });
  EXPECT_EQ(next, 100000u);
  EXPECT_LT(pieces, 10000u);
}

TEST(LateValue, IsMadeOnceAndNotAtAllWhereThatWasEnded) {
  const LateValue<int> value;
  EXPECT_EQ(value.get(StopClock(), []() -> int { throw Canceled("canceled"); }), nullptr);
  int made = 0;
  const auto make = [&] { return ++made; };
  const int* first = value.get(StopClock(), make);
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(*first, 1);
  EXPECT_EQ(value.get(StopClock(0.0), make), first);
  EXPECT_EQ(made, 1);
}

TEST(LateValue, IsNotWaitedForBeyondTheClock) {
  const LateValue<int> value;
  std::atomic<bool> under_way = false, go_on = false;
  std::thread maker([&] {
    EXPECT_EQ(*value.get(StopClock(),
                         [&] {
                           under_way = true;
                           while (!go_on) std::this_thread::yield();
                           return 7;
                         }),
              7);
  });
  while (!under_way) std::this_thread::yield();
  EXPECT_EQ(value.get(StopClock(0.0), [] { return 8; }), nullptr);
  go_on = true;
  EXPECT_EQ(*value.get(StopClock(), [] { return 8; }), 7);
  maker.join();
}

}  // namespace
}  // namespace arcway::internal

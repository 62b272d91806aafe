#include "arcway/progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "arcway/datasets/clutter.h"
#include "arcway/planner.h"

namespace arcway::internal {
namespace {

TEST(Progress, RisesToTheTotalAndIsReportedByOneThreadAtATime) {
  const ThreadExecutor threads(4);
  for (const std::size_t count : {1u, 7u, 250u, 100000u}) {
    std::atomic<int> inside = 0;
    std::vector<std::uint64_t> reports;
    std::vector<int> visits(count, 0);
    const ReportingExecutor executor(threads, [&](const Progress& progress) {
      EXPECT_EQ(++inside, 1);
      EXPECT_EQ(std::string(progress.stage), "counting");
      EXPECT_EQ(progress.total, count);
      reports.push_back(progress.done);
      --inside;
    });
    executor.begin_stage("counting");
    executor.for_ranges(count, 3, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
    EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), 0), static_cast<int>(count));
    EXPECT_EQ(*std::min_element(visits.begin(), visits.end()), 1);
    ASSERT_FALSE(reports.empty());
    EXPECT_EQ(reports.back(), count);
    EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
    EXPECT_LE(reports.size(), 253u);
  }
}

TEST(Progress, LoopsWithinLoopsAreReportedByOneThreadAtATime) {
  const ThreadExecutor threads(4);
  std::atomic<int> inside = 0;
  const ReportingExecutor executor(threads, [&](const Progress&) {
    EXPECT_EQ(++inside, 1);
    std::this_thread::yield();
    --inside;
  });
  executor.for_ranges(8, 1, [&](std::size_t, std::size_t) {
    for (int i = 0; i < 20; ++i) executor.for_ranges(40, 1, [](std::size_t, std::size_t) {});
  });
}

TEST(Progress, ALoopOnOneThreadIsReportedInPieces) {
  const SerialExecutor serial;
  std::size_t reports = 0;
  const ReportingExecutor executor(serial, [&](const Progress&) { ++reports; });
  executor.for_ranges(100000, 1, [](std::size_t, std::size_t) {});
  EXPECT_GT(reports, 200u);
  executor.for_ranges(0, 1, [](std::size_t, std::size_t) { FAIL(); });
}

TEST(Progress, BuildersNameTheirStages) {
  const World world = random_world({.obstacles = 20, .vertices = 6, .fill = 0.2, .seed = 3});
  const SerialExecutor serial;
  std::vector<std::string> stages;
  const ReportingExecutor executor(serial, [&](const Progress& progress) {
    if (stages.empty() || stages.back() != progress.stage) stages.emplace_back(progress.stage);
  });
  const Planner planner(world, Vehicle{}, backend_of(world, make_reference_queries(world), executor));
  EXPECT_EQ(stages, (std::vector<std::string>{"lines of sight", "turn circles", "free headings", "bitangents",
                                              "feasible graph"}));
}

TEST(Progress, AReporterCanStopTheBuildThatItWatches) {
  const World world = random_world({.obstacles = 20, .vertices = 6, .fill = 0.2, .seed = 3});
  const SerialExecutor serial;
  std::stop_source stop;
  const StoppableExecutor stoppable(serial, stop.get_token());
  std::string last;
  const ReportingExecutor executor(stoppable, [&](const Progress& progress) {
    last = progress.stage;
    if (last == "turn circles") stop.request_stop();
  });
  EXPECT_THROW(Planner(world, Vehicle{}, backend_of(world, make_reference_queries(world), executor)), Canceled);
  EXPECT_EQ(last, "turn circles");
}

}  // namespace
}  // namespace arcway::internal

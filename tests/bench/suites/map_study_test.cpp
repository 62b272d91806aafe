#include "bench/suites/map_study.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <stop_token>
#include <string>
#include <vector>

#include "bench/report/results.h"
#include "bench/suites/corruption.h"

namespace arcway::internal::bench {
namespace {

MapStudy study_of_a_box() {
  const World world({Polygon::rectangle({20, 20}, {40, 40})});
  return {.maps = {{"box", world}},
          .robots = {{"car", Vehicle()}},
          .cases = {{0, 0, {{.start = {0, 0, 0}, .goal = {60, 60, 0}}, {.start = {0, 0, 0}, .goal = {60, 0, 0}}}}},
          .repetitions = 2};
}

MapStudyProgress nobody_watches(const std::stop_token& stop = {}) {
  return {.stop = stop, .show = [](const std::string&, std::size_t, std::size_t) {}};
}

TEST(MapStudy, FailsBenchmarksWhosePathsTheValidatorRefuses) {
  EXPECT_EQ(run_map_study(study_of_a_box(), nobody_watches()).failures, 0);
  set_corrupting(true);
  const MapStudyRun run = run_map_study(study_of_a_box(), nobody_watches());
  set_corrupting(false);
  EXPECT_EQ(run.failures, 2);
  const report::Results results = report::read_results(run.json, "r.json");
  ASSERT_EQ(results.measurements.size(), 4u);
  EXPECT_EQ(results.measurements[1].error, "");
  EXPECT_EQ(results.measurements[2].name, "PlanFirst/car/box");
  for (const std::size_t i : {2u, 3u})
    EXPECT_EQ(results.measurements[i].error.rfind("query 0: the validator refuses the path: ", 0), 0u)
        << results.measurements[i].error;
}

TEST(MapStudy, ShowsWhatItDoesAndEndsAtAStop) {
  std::vector<std::string> shown;
  std::stop_source stop;
  const MapStudyProgress progress{.stop = stop.get_token(),
                                  .show = [&](const std::string& benchmark, std::size_t done, std::size_t total) {
                                    EXPECT_LT(done, total);
                                    if (shown.empty() || shown.back() != benchmark) shown.push_back(benchmark);
                                    if (benchmark == "RealMap/car/box/prepared" && done == 1) stop.request_stop();
                                  }};
  const MapStudyRun run = run_map_study(study_of_a_box(), progress);
  EXPECT_EQ(shown, (std::vector<std::string>{"ReducedGraph/box", "FeasibleGraph/car/box", "PlanFirst/car/box",
                                             "RealMap/car/box/prepared"}));
  EXPECT_EQ(run.failures, 0);
  EXPECT_EQ(report::read_results(run.json, "r.json").measurements.size(), 3u);
}

TEST(MapStudy, HasNoResultsIfStoppedAtOnce) {
  std::stop_source stop;
  stop.request_stop();
  const MapStudyRun run = run_map_study(study_of_a_box(), nobody_watches(stop.get_token()));
  EXPECT_TRUE(report::read_results(run.json, "r.json").measurements.empty());
}

}  // namespace
}  // namespace arcway::internal::bench

#include "bench/report/noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bench/report/document.h"
#include "bench/report/study.h"
#include "tests/support/benchmark_runs.h"

namespace arcway::internal::report {
namespace {

Results results_of(const std::string& runs) { return read_results(file_of(runs), "r.json"); }

std::string noise_of_runs(const std::string& runs) { return noise_of(results_of(runs).measurements.front()); }

TEST(Noise, IsAWallTimeFarAboveTheProcessorTime) {
  EXPECT_EQ(noise_of_runs(run_of_clocks("Build/n:10", 1.09, 1.0)), "");
  EXPECT_EQ(noise_of_runs(run_of_clocks("Build/n:10", 1.25, 1.0)), "wall time 25 % above processor time");
  EXPECT_EQ(noise_of_runs(run_of_clocks("Build/n:10", 0.5, 1.0)), "") << "helpers cost more processor time";
}

TEST(Noise, OfSeveralThreadsIsThatOfTheWallClockAlone) {
  EXPECT_EQ(noise_of_runs(run_of_clocks("Build/threads:2/n:10", 3.0, 1.0)), "");
  EXPECT_EQ(noise_of_runs(run_of_clocks("Batch/threads:1", 3.0, 1.0)), "");
  EXPECT_EQ(noise_of_runs(run_of_clocks("Build/threads:2/n:10", 1.0, 1.0) + "," +
                          run_of_clocks("Build/threads:2/n:10", 1.3, 1.0)),
            "repetitions differ by 30 %");
}

TEST(Noise, IsASpreadOfTheRepetitions) {
  EXPECT_EQ(noise_of_runs(run("Build/n:10", 1.0) + "," + run("Build/n:10", 1.09)), "");
  EXPECT_EQ(noise_of_runs(run("Build/n:10", 1.0) + "," + run("Build/n:10", 1.101)), "repetitions differ by 10.1 %");
  EXPECT_EQ(noise_of_runs(run_of_clocks("Build/n:10", 2.0, 1.0) + "," + run_of_clocks("Build/n:10", 3.0, 1.5)),
            "wall time 100 % above processor time, repetitions differ by 50 %");
}

TEST(Noise, OfTimesTooShortForTheClockIsNotKnown) {
  EXPECT_EQ(noise_of_runs(run("Build/n:10", 0.0) + "," + run("Build/n:10", 0.0)), "");
}

TEST(Times, AreTheProcessorsButForThreads) {
  const Results results =
      results_of(run_of_clocks("Build/n:10", 3.0, 1.0) + "," + run_of_clocks("Build/threads:2/n:10", 3.0, 1.0) + "," +
                 run_of_clocks("Batch/threads:1", 3.0, 1.0));
  EXPECT_EQ(times_of(results.measurements[0]), std::vector<double>{1.0});
  EXPECT_EQ(times_of(results.measurements[1]), std::vector<double>{3.0});
  EXPECT_EQ(times_of(results.measurements[2]), std::vector<double>{3.0});
}

/// A series that grows like n over `sizes` sizes; the second is three times as long by the wall clock, and slower.
std::string with_a_disturbed_size(int sizes) {
  std::string runs;
  for (int i = 0; i < sizes; ++i) {
    const int n = 10 << i;
    const double seconds = 1e-6 * n * (i == 1 ? 2.0 : 1.0);
    runs += (i == 0 ? "" : ",") + run_of_clocks("ReducedGraph/tangent-cones/obstacles:" + std::to_string(n),
                                                i == 1 ? 3.0 * seconds : seconds, seconds);
  }
  return runs;
}

TEST(Noise, IsLeftOutOfFits) {
  const Results results = results_of(with_a_disturbed_size(6));
  const Study::Line line = studies_of(results).front().lines.front();
  ASSERT_TRUE(line.curve.fit);
  EXPECT_NEAR(line.curve.fit->exponent, 1.0, 1e-9);
  EXPECT_EQ(fitted_points(line.curve).size(), 5u);
}

TEST(Noise, LeavesTooFewSizesForAFit) {
  const Results results = results_of(with_a_disturbed_size(5));
  EXPECT_FALSE(studies_of(results).front().lines.front().curve.fit);
}

TEST(Noise, IsMarkedInEveryFormatAndExplained) {
  const Results results = results_of(with_a_disturbed_size(6));
  const Document document = make_document({.results = results, .before = {}, .peers = {}});
  EXPECT_EQ(document.summary.back(),
            "Noise: 1 of 6 benchmarks are marked † and left out of fits: of 1 the wall time exceeds the processor time "
            "by more than 10 %. \"Noisy benchmarks\" below names them.");
  const std::string markdown = to_markdown(document), html = to_html(document), csv = to_csv(results);
  const std::string why = "wall time 200 % above processor time";
  EXPECT_NE(markdown.find("| ReducedGraph/tangent-cones/obstacles:20 | " + why + " |"), std::string::npos);
  EXPECT_NE(markdown.find("| ReducedGraph/tangent-cones/obstacles:20 | 40 µs † |"), std::string::npos) << markdown;
  EXPECT_NE(html.find("40\u00a0µs\u00a0†"), std::string::npos);
  EXPECT_NE(html.find("class=\"noisy\" stroke=\"#0072b2\""), std::string::npos);
  EXPECT_NE(html.find("; noisy: " + why + "\""), std::string::npos);
  EXPECT_NE(html.find("hollow: noisy"), std::string::npos);
  EXPECT_NE(csv.find("ReducedGraph/tangent-cones/obstacles:20,1,0.00012,0.00012,0.00012,4e-05,\"" + why + "\",\n"),
            std::string::npos)
      << csv;
  EXPECT_NE(csv.find("ReducedGraph/tangent-cones/obstacles:10,1,1e-05,1e-05,1e-05,1e-05,,\n"), std::string::npos);
}

TEST(Noise, IsMarkedOnBothSidesOfAComparison) {
  const Results before = results_of(with_a_disturbed_size(2)),
                after = results_of(run("ReducedGraph/tangent-cones/obstacles:20", 1e-5));
  const Document document = make_document({.results = after, .before = before, .peers = {}});
  const auto section = std::ranges::find(document.sections, "Changes", &Section::title);
  ASSERT_NE(section, document.sections.end());
  EXPECT_EQ(section->table.rows.front()[1], "0.250 †");
  EXPECT_EQ(section->table.rows.front()[2], "40 µs †");
  EXPECT_EQ(section->table.rows.front()[3], "10 µs");
}

TEST(Noise, OfADuelIsMarked) {
  PeerResults peers;
  peers.duels.push_back({.task = "reduced graph",
                         .world = "w",
                         .vertices = 100,
                         .ours = "a",
                         .peer = "CGAL",
                         .our_seconds = {1.0, 1.5},
                         .peer_seconds = {2.0, 2.1},
                         .error = {}});
  const Document document =
      make_document({.results = results_of(run("Build/n:10", 1.0)), .before = {}, .peers = peers});
  const std::string markdown = to_markdown(document);
  EXPECT_NE(markdown.find("| 1.25 s † | 2.05 s |"), std::string::npos) << markdown;
  EXPECT_NE(to_html(document).find("noisy: arcway: repetitions differ by 50 %"), std::string::npos);
}

}  // namespace
}  // namespace arcway::internal::report

#include "bench/report/gate.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace arcway::internal::report {
namespace {

Measurement measured(const std::string& name, const std::vector<double>& seconds,
                     const std::map<std::string, double>& counters = {}) {
  return {
      .name = name, .wall_seconds = seconds, .cpu_seconds = seconds, .counters = counters, .label = {}, .error = {}};
}

Measurement without_times(const std::string& name, const std::string& error) {
  return {.name = name, .wall_seconds = {}, .cpu_seconds = {}, .counters = {}, .label = {}, .error = error};
}

Results run_of(const std::string& name, std::vector<Measurement> measurements, const std::string& processor = "P") {
  return {.name = name,
          .context = {{"processor", processor}, {"commit", "commit-of-" + name}},
          .measurements = std::move(measurements)};
}

const std::vector<double> kFive = {1.0, 1.01, 1.02, 1.03, 1.04};

std::vector<double> times(const std::vector<double>& seconds, double factor) {
  std::vector<double> longer;
  for (const double s : seconds) longer.push_back(factor * s);
  return longer;
}

TEST(Gate, PassesTheSameRun) {
  const Results run =
      run_of("a.json", {measured("Plan/n:10", kFive, {{"edges", 100.0}, {"allocations_per_query", 0.0}})});
  const GateFindings findings = compare_for_gate(run, run, {});
  EXPECT_TRUE(findings.passed());
  EXPECT_EQ(findings.counts, 2u);
  EXPECT_EQ(findings.times, 1u);
  EXPECT_EQ(findings.too_few, 0u);
  EXPECT_EQ(
      gate_text(findings, run, run, {}),
      "Old: a.json, commit commit-of-a.json, on P\nNew: a.json, commit commit-of-a.json, on P\n"
      "Compared: 2 counts, which may rise by 5 %; 1 processor times, whose fastest repetition may take 1.3 times as "
      "long, or longer if that may be chance (p >= 0.01).\nNothing rose beyond its limit.\n");
}

TEST(Gate, FailsCountsAboveTheirLimitAlone) {
  const auto with = [](double edges, double allocations, double vertices) {
    return run_of("r.json", {measured("Plan/n:10", kFive,
                                      {{"edges_per_vertex", edges},
                                       {"allocations_per_query", allocations},
                                       {"vertices", vertices},
                                       {"steps_per_edge", edges}})});
  };
  EXPECT_TRUE(compare_for_gate(with(100, 0, 1), with(105, 0, 9), {}).passed());
  EXPECT_TRUE(compare_for_gate(with(100, 5, 1), with(50, 0, 1), {}).passed());
  const GateFindings edges = compare_for_gate(with(100, 0, 1), with(106, 0, 1), {});
  ASSERT_EQ(edges.rises.size(), 2u);
  EXPECT_EQ(edges.rises[0].what, "edges_per_vertex");
  EXPECT_EQ(edges.rises[1].what, "steps_per_edge");
  EXPECT_TRUE(compare_for_gate(with(100, 0, 1), with(106, 0, 1), {.counts = 0.1}).passed());
  const GateFindings from_none = compare_for_gate(with(100, 0, 1), with(100, 1, 1), {});
  ASSERT_EQ(from_none.rises.size(), 1u);
  EXPECT_NE(gate_text(from_none, with(100, 0, 1), with(100, 1, 1), {})
                .find("| Plan/n:10 | allocations_per_query | 0 | 1 | from none | count, at most +5 % |"),
            std::string::npos);
}

TEST(Gate, FailsTimesThatAreLongerAndSignificant) {
  const auto gate = [](const std::vector<double>& before, const std::vector<double>& after, double factor = 1.3) {
    return compare_for_gate(run_of("a", {measured("Plan/n:10", before)}), run_of("b", {measured("Plan/n:10", after)}),
                            {.times = factor});
  };
  EXPECT_TRUE(gate(kFive, times(kFive, 1.25)).passed());
  const GateFindings slower = gate(kFive, times(kFive, 1.4));
  ASSERT_EQ(slower.rises.size(), 1u);
  EXPECT_TRUE(slower.rises[0].is_time);
  EXPECT_NEAR(slower.rises[0].p, 2.0 / 252.0, 1e-12);
  EXPECT_TRUE(gate(kFive, times(kFive, 1.4), 1.5).passed());
  // The fastest repetition is longer, but not significantly so; and the other way round.
  EXPECT_TRUE(gate({1.0, 2.0, 3.0, 4.0, 5.0}, {1.5, 2.5, 3.5, 4.5, 5.5}).passed());
  EXPECT_TRUE(gate(kFive, {1.2, 9.0, 9.0, 9.0, 9.0}).passed());
  const GateFindings four = gate({1.0, 1.0, 1.0, 1.0}, {9.0, 9.0, 9.0, 9.0});
  EXPECT_TRUE(four.passed());
  EXPECT_EQ(four.too_few, 1u);
  EXPECT_EQ(gate({0.0, 0.0, 0.0, 0.0, 0.0}, kFive).times, 0u);
}

TEST(Gate, ComparesCountsAloneBetweenProcessors) {
  const Results before =
      run_of("a", {measured("Plan/n:10", kFive, {{"edges", 10.0}, {"instructions_per_query", 1.0}})});
  const Results after =
      run_of("b", {measured("Plan/n:10", times(kFive, 9.0), {{"edges", 11.0}, {"instructions_per_query", 9.0}})}, "Q");
  const GateFindings findings = compare_for_gate(before, after, {});
  ASSERT_EQ(findings.rises.size(), 1u);
  EXPECT_EQ(findings.rises[0].what, "edges");
  EXPECT_NE(gate_text(findings, before, after, {})
                .find("no times and no instructions, because the runs are of different processors"),
            std::string::npos);
  EXPECT_EQ(compare_for_gate(before, run_of("b", after.measurements), {}).rises.size(), 3u);
}

TEST(Gate, NamesWhatVanishedAndFailsWhatFailsNow) {
  const Results before = run_of("a", {measured("A", kFive, {{"trials_per_query", 3.0}}), measured("B", kFive),
                                      measured("C", kFive), measured("D", kFive), without_times("E", "edges differ")});
  const Results after = run_of("b", {measured("A", kFive), without_times("C", "left out: about 9 s expected"),
                                     without_times("D", "edges differ"), without_times("E", "edges differ")});
  const GateFindings findings = compare_for_gate(before, after, {});
  EXPECT_FALSE(findings.passed());
  const std::string text = gate_text(findings, before, after, {});
  EXPECT_NE(text.find("\nFail now, and did not:\n- D: edges differ\n\n"), std::string::npos) << text;
  EXPECT_NE(
      text.find("- A: no count of trials_per_query\n- B: not in the new run\n- C: left out: about 9 s expected\n"),
      std::string::npos)
      << text;
  Results fewer = after;
  fewer.measurements.erase(fewer.measurements.begin() + 2);
  EXPECT_TRUE(compare_for_gate(before, fewer, {}).passed());
}

TEST(Gate, PutsTheLargestFactorsFirst) {
  const Results before = run_of("a", {measured("A", kFive, {{"edges", 10.0}}), measured("B", kFive, {{"edges", 10.0}}),
                                      measured("C", kFive, {{"edges", 0.0}})});
  const Results after = run_of("b", {measured("A", times(kFive, 99.0), {{"edges", 20.0}}),
                                     measured("B", kFive, {{"edges", 30.0}}), measured("C", kFive, {{"edges", 1.0}})});
  std::string order;
  for (const Rise& rise : compare_for_gate(before, after, {}).rises) order += rise.benchmark + rise.what[0];
  EXPECT_EQ(order, "CeBeAeAp");
}

}  // namespace
}  // namespace arcway::internal::report

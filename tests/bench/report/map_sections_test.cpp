#include "bench/report/map_sections.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace arcway::internal::report {
namespace {

Measurement measured(const std::string& name, double seconds, const std::map<std::string, double>& counters) {
  return {.name = name,
          .wall_seconds = {seconds, seconds},
          .cpu_seconds = {seconds, seconds},
          .counters = counters,
          .label = {},
          .error = {}};
}

Results own_results(double solved_share) {
  std::map<std::string, double> plans{{"vertices", 1800},
                                      {"queries", 20},
                                      {"solved_share", solved_share},
                                      {"start_blocked", 1},
                                      {"goal_blocked", 2},
                                      {"no_path", 0},
                                      {"time_limit", 4},
                                      {"prepare_seconds", 0.5},
                                      {"plan_seconds_median", 0.02},
                                      {"plan_seconds_p99", 0.3},
                                      {"expansions_per_query", 1234}};
  if (solved_share > 0.0)
    plans.insert({{"first_over_bound_median", 1.5},
                  {"first_path_seconds_median", 0.001},
                  {"time_over_bound_median", 1.25},
                  {"search_seconds_median", 0.004},
                  {"refine_seconds_median", 0.015},
                  {"min_clearance_m", 0.25}});
  return {.name = "r.json",
          .context = {{"study", "maps"}},
          .measurements = {measured("ReducedGraph/a/b", 0.003, {{"edges", 12000}}),
                           measured("FeasibleGraph/car/a/b", 0.1, {{"links", 345}}),
                           measured("PlanFirst/car/a/b", 0.2, {}), measured("RealMap/car/a/b/prepared", 0.05, plans)}};
}

TEST(OwnMaps, AreToldByTheStudy) {
  EXPECT_TRUE(is_of_own_maps(own_results(1.0)));
  EXPECT_FALSE(is_of_own_maps({.name = "r", .context = {{"study", "full"}}, .measurements = {}}));
}

TEST(OwnMaps, HaveTheCostOfEachStageAndTheQuality) {
  const Results results = own_results(0.65);
  EXPECT_EQ(own_cost_section(results).table.rows,
            (std::vector<std::vector<std::string>>{{"car", "a/b", "1,800", "3 ms", "12,000", "100 ms", "345", "500 ms",
                                                    "200 ms", "50 ms", "4 ms", "15 ms"}}));
  EXPECT_EQ(own_quality_section(results).table.rows,
            (std::vector<std::vector<std::string>>{{"car", "a/b", "13 of 20", "3", "0", "4", "50.0 %", "1 ms", "25.0 %",
                                                    "20 ms", "300 ms", "0.2500 m", "1,234"}}));
  EXPECT_EQ(own_map_findings(results),
            (std::vector<std::string>{
                "car on a/b: 13 of 20 queries are solved, and the validator takes every path. On the prepared map a "
                "plan takes 20 ms in the median, from the bare map 200 ms in the mean. Travel times are 25.0 % above a "
                "lower bound that no path can beat, in the median."}));
  EXPECT_EQ(own_map_figures(results).size(), 1u);
}

TEST(OwnMaps, MarkWhatIsNoisy) {
  Results results = own_results(1.0);
  for (Measurement& m : results.measurements)
    if (m.name != "ReducedGraph/a/b") m.wall_seconds.assign(2, 1.2 * m.cpu_seconds.front());
  const std::vector<std::string> cost = own_cost_section(results).table.rows[0];
  EXPECT_EQ(cost[3], "3 ms");
  EXPECT_EQ(cost[5], "100 ms †");
  EXPECT_EQ(cost[9], "50 ms †");
  EXPECT_EQ(own_quality_section(results).table.rows[0][9], "20 ms †");
}

TEST(OwnMaps, WithoutAPlanHaveNoQuality) {
  const Results results = own_results(0.0);
  EXPECT_EQ(own_quality_section(results).table.rows[0][8], "–");
  EXPECT_EQ(
      own_map_findings(results),
      (std::vector<std::string>{"car on a/b: 0 of 20 queries are solved. On the prepared map a plan takes 20 ms in "
                                "the median, from the bare map 200 ms in the mean."}));
  EXPECT_TRUE(own_map_figures(results).empty());
}

TEST(OwnMaps, AreCalledByNoStudyOfOurs) {
  PeerResults peers;
  for (std::size_t query = 0; query < 10; ++query)
    peers.queries.push_back(
        {own_setting("car", "yard"),
         "yard",
         query,
         5.0,
         {{"arcway", "solved", 0.1, 6.0, true}, {"ompl_rrtconnect 1 s", "solved", 1.0, 7.0, true}}});
  const Document document = make_document({.results = own_results(1.0), .before = {}, .peers = peers});
  std::string text = to_markdown(document);
  const std::size_t cited = text.find("## How to cite");
  text.erase(cited, text.find("\n## ", cited) - cited);
  EXPECT_NE(text.find("solved 20 of 20 tasks (100 %) for car; an independent check"), std::string::npos) << text;
  for (const char* wrong : {"100 obstacles", "clutter", "paper", "not compared", "not measured", "reference's"})
    EXPECT_EQ(text.find(wrong), std::string::npos) << wrong << "\n" << text;
  EXPECT_NE(text.find("these maps: not slower in 100 % of 10 comparisons"), std::string::npos) << text;
  EXPECT_NE(text.find("| car on yard | OMPL's RRTConnect, 1 s | 10 of 10 |"), std::string::npos) << text;
}

}  // namespace
}  // namespace arcway::internal::report

#include "bench/report/first_page.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "bench/slowest_query.h"
#include "tests/support/benchmark_runs.h"

namespace arcway::internal::report {
namespace {

std::string quality(const std::string& name, double seconds, double over_bound, const std::string& label = {}) {
  return run("Quality/" + name, seconds,
             R"(,"queries":50,"solved_share":0.9,"plan_seconds_median":)" + std::to_string(seconds) +
                 R"(,"time_over_bound_median":)" + std::to_string(over_bound) + R"(,"label":")" + label + "\"");
}

Inputs inputs_with(const std::string& runs) { return {read_results(file_of(runs), "r.json"), {}, {}}; }

std::string lead_of(const Inputs& inputs) { return lead_paragraph(inputs, studies_of(inputs.results)); }

std::string growing_plans() {
  std::string runs;
  for (const int n : {10, 100, 1000, 10000, 100000})
    runs += (runs.empty() ? "" : ",") + run("Plan/lazy/obstacles:" + std::to_string(n), 1e-5 * n);
  return runs;
}

TEST(Lead, LeavesOutWhatIsNotMeasured) {
  const std::string what = lead_of(inputs_with(run("Build/n:10", 1.0)));
  EXPECT_EQ(what,
            "arcway plans how a car-like vehicle gets from one position and heading to another in the shortest time "
            "without touching an obstacle.");
}

TEST(Lead, SaysWhatWasPlannedAndHowTheCostGrows) {
  const std::string lead = lead_of(inputs_with(quality("car/convex_f30", 0.004, 1.05) + "," +
                                               quality("convex_f30", 0.002, 1.02) + "," + growing_plans()));
  EXPECT_NE(
      lead.find(
          " Here it solved 90 of 100 random tasks (90 %) for a real vehicle and the robot of the paper behind "
          "the method; an independent check accepted every path. Once a map is prepared, a plan takes 2 ms – 4 ms "
          "of processor time, and the drive lasts 2.0 – 5.0 % longer than a bound that nothing can beat"),
      std::string::npos)
      << lead;
  EXPECT_TRUE(
      lead.ends_with("With ten times as many obstacles, the first plan on a new map takes 10 times as long (it "
                     "grows like n^1.00 with n obstacles): 1 s among 100,000."))
      << lead;
}

TEST(Lead, SaysNothingByAFitOfAWideInterval) {
  std::string runs;
  for (const auto& [n, seconds] : {std::pair(10, 0.03), {32, 0.01}, {100, 0.03}, {316, 0.01}, {1000, 0.1}})
    runs += (runs.empty() ? "" : ",") + run("Plan/lazy/obstacles:" + std::to_string(n), seconds);
  const std::string lead = lead_of(inputs_with(runs));
  EXPECT_EQ(lead.find("With ten times"), std::string::npos) << lead;
}

TEST(Lead, NamesOtherVehicles) {
  const std::string lead = lead_of(inputs_with(quality("shuttle/campus", 0.004, 1.05)));
  EXPECT_NE(lead.find("45 of 50 random tasks (90 %) for shuttle;"), std::string::npos) << lead;
}

TEST(Lead, SaysHowOthersCompare) {
  Inputs inputs = inputs_with(run("Build/n:10", 1.0));
  inputs.peers.emplace();
  inputs.peers->queries.push_back(
      {"n100",
       "w",
       0,
       9.0,
       {{"arcway", "solved", 0.1, 10.0, true}, {"ompl_rrtconnect 10 s", "solved", 1.0, 20.0, true}}});
  EXPECT_TRUE(
      lead_of(inputs).ends_with(" OMPL's RRTConnect, which had up to 10 s for each task, found a faster drive in 0 "
                                "of 1 comparisons; 0 times arcway alone found one, 0 times another alone."))
      << lead_of(inputs);
}

TEST(SlowestQuery, IsReadFromItsLabel) {
  const bench::SlowestQuery slowest{.world = "clutter/convex/n100/m10/f30/s1", .query = 17, .seconds = 0.213};
  const std::string label = bench::label_of(slowest);
  EXPECT_EQ(label, "slowest: query 17 of clutter/convex/n100/m10/f30/s1, 0.213 s");
  const auto read = bench::slowest_query_of(label);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->world, slowest.world);
  EXPECT_EQ(read->query, 17u);
  EXPECT_EQ(read->seconds, 0.213);
  for (const char* other :
       {"", "O(n log n)", "slowest: query x of w, 1 s", "slowest: query 1 of w", "slowest: query 1, 2 s"})
    EXPECT_FALSE(bench::slowest_query_of(other)) << other;
}

TEST(PicturedQueries, AreAPlanAndTheSlowestOne) {
  const auto label = [](std::size_t query, double seconds) {
    return bench::label_of({.world = "clutter/star/n30/m10/f15/s1", .query = query, .seconds = seconds});
  };
  Inputs inputs = inputs_with(quality("convex_f30", 0.002, 1.02, label(3, 0.5)) + "," +
                              quality("forklift/star_f15", 0.004, 1.05, label(4, 0.75)) + "," +
                              quality("car/convex_f30", 0.004, 1.05));
  std::vector<PicturedQuery> pictured = pictured_queries(inputs);
  ASSERT_EQ(pictured.size(), 2u);
  EXPECT_EQ(pictured[0].vehicle, "car");
  EXPECT_EQ(pictured[0].world, "clutter/convex/n100/m10/f30/s1");
  EXPECT_TRUE(pictured[0].any);
  EXPECT_EQ(pictured[1].vehicle, "forklift");
  EXPECT_EQ(pictured[1].world, "clutter/star/n30/m10/f15/s1");
  EXPECT_EQ(pictured[1].query, 4u);
  EXPECT_EQ(pictured[1].seconds, 0.75);
  inputs.peers.emplace();
  inputs.peers->queries.push_back(
      {"n1000", "clutter/star/n1000/m10/f45", 7, 9.0, {{"arcway", "no path", 0.8, 0.0, false}}});
  pictured = pictured_queries(inputs);
  ASSERT_EQ(pictured.size(), 2u);
  EXPECT_EQ(pictured[1].world, "clutter/star/n1000/m10/f45");
  EXPECT_EQ(pictured[1].query, 7u);
  EXPECT_TRUE(pictured_queries(inputs_with(run("Build/n:10", 1.0))).empty());
  EXPECT_TRUE(pictured_queries(inputs_with(quality("shuttle/campus_front", 0.004, 1.05))).empty());
}

}  // namespace
}  // namespace arcway::internal::report

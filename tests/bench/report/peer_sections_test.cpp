#include "bench/report/peer_sections.h"

#include <gtest/gtest.h>

#include "arcway/datasets/file_io.h"

namespace arcway::internal::report {
namespace {

constexpr std::size_t kTimes = 10;  // of each query: fewer have no medians

PeerResults example() {
  PeerResults peers{.name = "p.json", .context = {{"ompl", "1.5.2"}}, .duels = {}, .queries = {}};
  peers.duels.push_back({"graph", "w1", 100.0, "tangent-cones", "slow", {1.0, 2.0, 1.0}, {10.0, 20.0, 12.0}, ""});
  peers.duels.push_back({"graph", "w2", 1000.0, "tangent-cones", "slow", {1.0}, {100.0}, ""});
  peers.duels.push_back({"graph", "w3", 10000.0, "tangent-cones", "slow", {}, {}, "left out: too long"});
  peers.duels.push_back({"sight", "w2", 1000.0, "embree", "quick", {4.0}, {1.0}, "", {4.0}, {1.0}, 1});
  const PlannerAnswer fast{"arcway", "solved", 0.001, 10.0, true}, slow{"peer 1 s", "solved", 0.5, 15.0, true};
  const PlannerAnswer no_fast{"arcway", "no path", 0.001, 0.0, false},
      no_slow{"peer 1 s", "no path in 1 s", 1.0, 0.0, false};
  for (std::size_t i = 0; i < kTimes; ++i) {
    peers.queries.push_back({"n1", "w", 2 * i, 9.0, {fast, slow}});
    peers.queries.push_back({"n1", "w", 2 * i + 1, 9.0, {fast, no_slow}});
    peers.queries.push_back({"n1", "v", i, 9.0, {no_fast, slow}});
  }
  return peers;
}

TEST(PeerResults, AreReadAsTheyWereWritten) {
  const std::string json = peer_results_json(example());
  EXPECT_TRUE(is_peer_results(json));
  EXPECT_FALSE(is_peer_results(R"({"context":{},"benchmarks":[]})"));
  const PeerResults read = read_peer_results(json, "p.json");
  EXPECT_EQ(peer_results_json(read), json);
  ASSERT_EQ(read.duels.size(), 4u);
  EXPECT_EQ(read.duels[0].peer_seconds, (std::vector<double>{10.0, 20.0, 12.0}));
  ASSERT_EQ(read.queries.size(), 30u);
  EXPECT_EQ(read.queries[1].answers[1].status, "no path in 1 s");
}

TEST(PeerResults, NameFileAndPlaceOfAnError) {
  try {
    (void)read_peer_results(R"({"format":"arcway-peers","context":{},"duels":[{"task":"t"}]})", "p.json");
    FAIL();
  } catch (const FormatError& error) {
    EXPECT_EQ(std::string(error.what()), "p.json: duels[0]: key 'world' not found");
  }
}

TEST(Duels, KeepWhatAPeerWinsAndWhatIsLeftOut) {
  const Table table = duels_section(example()).table;
  ASSERT_EQ(table.rows.size(), 4u);
  EXPECT_EQ(table.rows[0],
            (std::vector<std::string>{"graph", "slow", "100", "1 s †", "12 s †", "10", "10 – 12", "arcway"}));
  EXPECT_EQ(table.rows[2][3], "left out: too long");
  EXPECT_EQ(table.rows[3].back(), "quick");
  EXPECT_EQ(peer_findings(example()).front(),
            "Visibility: a peer's time over arcway's, for equal answers on the largest map that both did: quick 0.25 "
            "(sight); slow 100 (graph); a peer wins sight (quick).");
}

TEST(Duels, OfSeveralThreadsGoByTheWallClock) {
  PeerResults peers = example();
  peers.duels = {{"graph", "w", 100.0, "tangent-cones", "one", {2.0}, {3.0}, "", {1.0}, {4.0}, 2}};
  const PeerResults read = read_peer_results(peer_results_json(peers), "p.json");
  EXPECT_EQ(duels_section(read).table.rows.front(),
            (std::vector<std::string>{"graph", "one", "100", "wall 1 s, processor 2 s", "wall 4 s, processor 3 s", "4",
                                      "4 – 4", "arcway"}));
  peers.duels.front().peer_wall_seconds.clear();
  EXPECT_THROW((void)read_peer_results(peer_results_json(peers), "p.json"), FormatError);
}

TEST(Planners, AreCountedByWhatOneOfTwoSolves) {
  const Table table = planners_section(example()).table;
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0][2], "20 of 30");
  EXPECT_EQ(table.rows[1],
            (std::vector<std::string>{"n1", "peer 1 s", "20 of 30", "20", "500 ms", "1.667 / 1.667 / 1.667",
                                      "1.250 / 1.500 / 1.500", "1.500 / 1.500 / 1.500", "0 / 10", "10 / 10"}));
  const Section by_world = planners_by_world_section(example());
  ASSERT_EQ(by_world.table.rows.size(), 3u) << "arcway solves nothing in the other world";
  EXPECT_EQ(by_world.table.rows[1].back(), "10 no path in 1 s");
  ASSERT_EQ(by_world.paragraphs.size(), 1u);
  EXPECT_EQ(by_world.paragraphs[0],
            "1 row is not shown: fewer than 10 queries are solved in it, too few for a median.");
}

TEST(Planners, HaveAPlotOfEachSettingWithItsName) {
  PeerResults peers = example();
  for (std::size_t i = 0; i < kTimes; ++i) peers.queries.push_back({"n2", "w", i, 9.0, peers.queries[0].answers});
  const std::vector<std::string> figures = planner_figures(peers);
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_NE(figures[0].find("<figcaption>Planners, n1: "), std::string::npos) << figures[0];
  EXPECT_NE(figures[1].find("<figcaption>Planners, n2: "), std::string::npos) << figures[1];
  EXPECT_EQ(duel_figures(peers).size(), 1u);
}

TEST(Planners, AreComparedWithinASetting) {
  PeerResults peers = example();
  for (PlannerQuery& q : peers.queries)
    if (q.world == "v") q.setting = "n2";
  const Table table = planners_section(peers).table;
  ASSERT_EQ(table.rows.size(), 3u) << "arcway solves nothing in the second setting";
  EXPECT_EQ(table.rows[1][0], "n1");
  EXPECT_EQ(table.rows[1][2], "10 of 20");
  EXPECT_EQ(table.rows[2][0], "n2");
  EXPECT_EQ(table.rows[2][2], "10 of 10");
}

/// A car whose path is longer than a peer's by these shares.
PeerResults losing_by(const std::vector<double>& shares, std::size_t times = kTimes) {
  PeerResults peers = example();
  for (std::size_t i = 0; i < shares.size() * times; ++i)
    peers.queries.push_back({"car",
                             "w",
                             i,
                             9.0,
                             {{"arcway", "solved", 0.01, 10.0 * (1.0 + shares[i / times]), true},
                              {"peer first", "solved", 0.1, 20.0, true},
                              {"peer 1 s", "solved", 1.0, 10.0, true}}});
  return peers;
}

TEST(Claims, StateTheirToleranceAndTheirLosses) {
  const PeerResults peers = losing_by({0.0, 0.0009, 0.0011, -0.2});
  const Table table = claims_section(peers).table;
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.header[3], "not slower, 0.1 %");
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"car", "peer 1 s", "40", "75.0 %", "50.0 %", "0.11 %",
                                                     "0.00 %, 25.00 %", "0", "0"}));
  EXPECT_EQ(table.rows[1][0], "n1") << "real vehicles come first";
  const Table losses = losses_section(peers).table;
  ASSERT_EQ(losses.rows.size(), 20u);
  EXPECT_EQ(losses.rows[0], (std::vector<std::string>{"n1", "v", "0", "peer 1 s", "15.000 s", "no path", "–"}));
  EXPECT_EQ(losses.rows[10],
            (std::vector<std::string>{"car", "w", "20", "peer 1 s", "10.000 s", "10.011 s", "0.11 %"}));
}

TEST(Claims, CountNoInvalidPath) {
  PeerResults peers = losing_by({0.5});
  for (PlannerQuery& q : peers.queries)
    if (q.setting == "car") q.answers.back().valid = false;
  const Section claims = claims_section(peers);
  ASSERT_EQ(claims.table.rows.size(), 1u);
  EXPECT_EQ(claims.table.rows[0][0], "n1");
  EXPECT_EQ(claims.paragraphs.back(), "Real vehicles were not compared in these results.");
  EXPECT_EQ(losses_section(peers).table.rows.size(), 10u);
  const auto planners = planners_section(peers).table.rows;
  EXPECT_EQ(planners[2][3], "0");
  EXPECT_EQ(planners[2].back(), "0 / 10");
}

TEST(Claims, AreMadeForRealVehiclesFirst) {
  const std::vector<std::string> findings = peer_findings(losing_by({0.0, 0.0011}));
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(
      findings[1],
      "Not slower than a peer's improved path, where a travel time at most 0.1 % longer counts as not slower: real "
      "vehicles: not slower in 50.0 % of 20 comparisons, at worst by 0.11 %, and 0 answers of peers where arcway has "
      "none; the paper's robot with limits on its acceleration: not compared in these results; the paper's robot: "
      "not slower in 100 % of 10 comparisons, at worst by 0.00 %, and 10 answers of peers where arcway has none.");
  EXPECT_NE(peer_findings(example())[1].find("real vehicles: not compared in these results"), std::string::npos);
}

TEST(Claims, OfFewQueriesAreNotShown) {
  const Section section = claims_section(losing_by({0.0}, 9));
  ASSERT_EQ(section.table.rows.size(), 1u);
  EXPECT_EQ(section.table.rows[0][0], "n1");
  EXPECT_EQ(section.paragraphs[1], "1 row is not shown: fewer than 10 queries are solved in it, too few for a median.");
}

TEST(Comparison, TellsAStrangerWhoWins) {
  EXPECT_EQ(
      planner_comparison(losing_by({0.0, 0.0011})),
      "peer, which had up to 1 s for each task, found a faster drive in 10 of 30 comparisons, by at most 0.1 %; 10 "
      "times arcway alone found one, 10 times another alone.");
  EXPECT_EQ(planner_comparison({}), "");
  EXPECT_EQ(duel_comparison(example()), "") << "no peer built the reduced graph";
  PeerResults peers = example();
  for (Duel& d : peers.duels) d.task = "reduced graph";
  EXPECT_EQ(duel_comparison(peers),
            "Finding which corners of the obstacles see each other takes with slow 100 times and with quick 0.25 times "
            "as long as with arcway, on the largest map that both did.");
}

TEST(Claims, AreNotRoundedUpToAll) {
  std::vector<double> shares(3000, 0.0);
  shares.front() = 0.01;
  EXPECT_EQ(claims_section(losing_by(shares, 1)).table.rows[0][3], "99.9 %");
}

}  // namespace
}  // namespace arcway::internal::report

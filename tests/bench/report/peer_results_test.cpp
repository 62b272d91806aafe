#include "bench/report/peer_results.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace arcway::internal::report {
namespace {

using Context = std::vector<std::pair<std::string, std::string>>;

const std::vector<std::string> kOrder{"n1", "n2", "n3"};

Duel duel(const std::string& peer, double seconds) {
  return {"graph", "w", 100.0, "embree", peer, {1.0}, {seconds}, ""};
}

PlannerQuery query(const std::string& setting, double seconds) {
  return {setting, "w", 0, 9.0, {{"arcway", "no path", seconds}, {"ompl_x 1 s", "no path", seconds}}};
}

PeerResults earlier_results() {
  return {.name = "p.json",
          .context = {{"commit", "a"}, {"cgal", "5"}, {"embree", "3"}, {"onetbb", "2021"}, {"ompl", "1"}},
          .duels = {duel("CGAL expansion", 1.0), duel("brute force", 1.0)},
          .queries = {query("n1", 1.0), query("n2", 1.0), query("own", 1.0), query("n3", 1.0)}};
}

std::vector<std::pair<std::string, double>> queries_of(const PeerResults& results) {
  std::vector<std::pair<std::string, double>> queries;
  for (const PlannerQuery& q : results.queries) queries.emplace_back(q.setting, q.answers[0].seconds);
  return queries;
}

TEST(RenewedPeerResults, HaveNewSettingsInTheirPlaces) {
  const PeerResults run{.name = {}, .context = {}, .duels = {}, .queries = {query("n2", 2.0), query("n2", 3.0)}};
  const PeerResults results = renewed(earlier_results(), run, kOrder);
  EXPECT_EQ(queries_of(results), (std::vector<std::pair<std::string, double>>{
                                     {"n1", 1.0}, {"n2", 2.0}, {"n2", 3.0}, {"n3", 1.0}, {"own", 1.0}}));
  EXPECT_EQ(results.duels.size(), 2u);
}

TEST(RenewedPeerResults, KeepVersionsOfPeersThatTheRunDoesNotHave) {
  const PeerResults run{
      .name = {}, .context = {{"commit", "b"}, {"ompl", "2"}}, .duels = {}, .queries = {query("n1", 2.0)}};
  EXPECT_EQ(renewed(earlier_results(), run, kOrder).context,
            (Context{{"commit", "b"}, {"ompl", "2"}, {"cgal", "5"}, {"embree", "3"}, {"onetbb", "2021"}}));
}

TEST(RenewedPeerResults, ForgetVersionsOfPeersWhoseResultsAreGone) {
  const PeerResults run{.name = {}, .context = {{"commit", "b"}}, .duels = {duel("brute force", 2.0)}, .queries = {}};
  const PeerResults results = renewed(earlier_results(), run, kOrder);
  EXPECT_EQ(results.context, (Context{{"commit", "b"}, {"onetbb", "2021"}, {"ompl", "1"}}));
  ASSERT_EQ(results.duels.size(), 1u);
  EXPECT_EQ(results.duels[0].peer_seconds, std::vector<double>{2.0});
  EXPECT_EQ(results.queries.size(), 4u);
}

TEST(RenewedPeerResults, AreTheRunsWhereNothingElseIsKept) {
  PeerResults run{.name = {}, .context = {{"commit", "b"}}, .duels = {duel("brute force", 2.0)}, .queries = {}};
  for (const char* setting : {"n1", "n2", "n3", "own"}) run.queries.push_back(query(setting, 2.0));
  EXPECT_EQ(peer_results_json(renewed(earlier_results(), run, kOrder)), peer_results_json(run));
  EXPECT_EQ(peer_results_json(renewed({}, run, kOrder)), peer_results_json(run));
}

TEST(AnsweredAnew, KeepsTheAnswersOfOthers) {
  const std::vector<PlannerQuery> earlier{query("n1", 1.0), query("n2", 1.0)};
  PlannerQuery ours{"n2", "w", 0, 8.0, {{"arcway", "solved", 2.0, 7.0, true}, {"arcway first", "solved", 1.5}}};
  PlannerQuery another{"n2", "w", 1, 5.0, {{"arcway", "solved", 3.0}}};
  PeerResults run{.name = {}, .context = {}, .duels = {}, .queries = {ours, another}};
  run.queries = answered_anew(earlier, run.queries);
  ASSERT_EQ(run.queries.size(), 2u);
  const PlannerQuery& known = run.queries[0];
  EXPECT_EQ(known.lower_bound, 8.0);
  ASSERT_EQ(known.answers.size(), 3u);
  EXPECT_EQ(known.answers[0].planner, "arcway");
  EXPECT_EQ(known.answers[0].travel_time, 7.0);
  EXPECT_TRUE(known.answers[0].valid);
  EXPECT_EQ(known.answers[1].planner, "arcway first");
  EXPECT_EQ(known.answers[2].planner, "ompl_x 1 s");
  EXPECT_EQ(known.answers[2].seconds, 1.0);
  EXPECT_EQ(run.queries[1].query, 1u);
  EXPECT_EQ(queries_of(renewed({.name = {}, .context = {}, .duels = {}, .queries = earlier}, run, kOrder)),
            (std::vector<std::pair<std::string, double>>{{"n1", 1.0}, {"n2", 2.0}, {"n2", 3.0}}));
}

}  // namespace
}  // namespace arcway::internal::report

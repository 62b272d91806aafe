#include "core/roadmap/lazy_feasible_graph.h"

#include <gtest/gtest.h>

#include <thread>
#include <utility>
#include <vector>

#include "core/roadmap/finished_feasible_graph.h"
#include "tests/support/graph_case.h"

namespace arcway::internal {
namespace {

TEST(LazyFeasibleGraph, IsTheFinishedGraphOnceAllHasBeenAskedFor) {
  const test::GraphCase c;
  const auto finished = c.finished();
  const auto lazy = c.lazy();
  EXPECT_EQ(lazy->finished(), nullptr);
  EXPECT_EQ(lazy->counts().kept, 0u);
  EXPECT_EQ(lazy->counts().candidates, 0u);
  EXPECT_EQ(lazy->counts().circles, finished->circles().size());
  test::expect_same(test::kept_links(*lazy), finished->links());
  for (std::uint32_t circle = 0; circle < finished->circles().size(); ++circle) {
    const auto a = finished->free_headings(circle).intervals();
    const auto b = lazy->free_headings(circle).intervals();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].low, b[i].low);
  }
  test::expect_same(lazy->counts(), finished->counts());
}

TEST(LazyFeasibleGraph, AnswersManyThreadsAtOnce) {
  const test::GraphCase c;
  const auto lazy = c.lazy();
  std::vector<std::vector<FeasibleLink>> kept(4);
  std::vector<std::thread> threads;
  for (auto& links : kept) threads.emplace_back([&lazy, &links] { links = test::kept_links(*lazy); });
  for (std::thread& thread : threads) thread.join();
  const auto finished = c.finished();
  for (const auto& links : kept) test::expect_same(links, finished->links());
}

TEST(LazyFeasibleGraph, KnowsWhatItHasFoundAndNoMore) {
  const test::GraphCase c;
  const auto finished = c.finished();
  const auto lazy = c.lazy();
  const std::uint32_t circle = finished->links()[0].from, other = finished->links().back().from;
  ASSERT_NE(circle, other);
  EXPECT_EQ(lazy->known_headings(circle), nullptr);
  EXPECT_FALSE(lazy->known_row(circle));
  const auto links = lazy->links_from(circle);
  const HeadingSet* headings = lazy->known_headings(circle);
  EXPECT_EQ(headings, &lazy->free_headings(circle));
  EXPECT_EQ(lazy->known_headings(other), nullptr);

  const bool kept = lazy->is_kept(circle, 0);
  const std::optional<CheckedRow> row = lazy->known_row(circle);
  ASSERT_TRUE(row);
  test::expect_same(row->row.links, links);
  ASSERT_EQ(row->verdicts.size(), links.size());
  EXPECT_EQ(row->verdicts[0] == LinkVerdict::kKept, kept);
  EXPECT_NE(row->verdicts[0], LinkVerdict::kUnknown);
  for (std::size_t i = 1; i < links.size(); ++i) EXPECT_EQ(row->verdicts[i], LinkVerdict::kUnknown);
}

TEST(LazyFeasibleGraph, TakesWhatItLearnsForWhatItWouldFind) {
  const test::GraphCase c;
  const auto finished = c.finished();
  LazyFeasibleGraph lazy(c.inputs(), SerialExecutor());
  const std::uint32_t circle = finished->links()[0].from;
  lazy.learn_headings(circle, HeadingSet::full());
  EXPECT_TRUE(lazy.free_headings(circle).is_full());
  CheckedRow row = *finished->known_row(circle);
  row.verdicts[0] = LinkVerdict::kStraight;
  lazy.learn_row(circle, std::move(row));
  test::expect_same(lazy.links_from(circle), finished->links_from(circle));
  EXPECT_FALSE(lazy.is_kept(circle, 0));
  lazy.learn_row(circle, *finished->known_row(circle));  // too late
  EXPECT_FALSE(lazy.is_kept(circle, 0));
}

}  // namespace
}  // namespace arcway::internal

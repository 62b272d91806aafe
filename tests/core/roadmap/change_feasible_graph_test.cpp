#include "core/roadmap/change_feasible_graph.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "tests/support/graph_case.h"
#include "tests/support/same_graphs.h"

namespace arcway::internal {
namespace {

// A world, and the same without one of its obstacles.
struct ChangeCase {
  test::GraphCase before{{.kind = ClutterKind::kStar, .obstacles = 40, .vertices = 6, .fill = 0.25, .seed = 5}};
  std::vector<ObstacleId> removed{17};
  test::GraphCase after{before.world.changed(removed, {})};
  WorldChange change{before.world, after.world, removed};
  ThreadExecutor threads{2};
};

TEST(ChangeFeasibleGraph, IsTheGraphBuiltAnewWhateverWasKnownBefore) {
  const ChangeCase c;
  const auto finished = c.before.finished();
  const auto untouched = c.before.lazy(), known = c.before.lazy(), half = c.before.lazy();
  (void)test::kept_links(*known);
  for (std::uint32_t circle = 0; circle < half->circles().size(); circle += 2)
    for (std::size_t i = 0; i < half->links_from(circle).size(); i += 1 + circle % 3) (void)half->is_kept(circle, i);
  const auto anew = c.after.finished();
  const std::vector<const FeasibleGraph*> all{finished.get(), untouched.get(), known.get(), half.get()};
  for (const FeasibleGraph* before : all) {
    const auto changed = change_feasible_graph(*before, c.after.inputs(), c.change, c.threads);
    test::expect_same(*changed, *anew);
    const auto lazy = change_lazy_feasible_graph(*before, c.after.inputs(), c.change, c.threads);
    test::expect_same(test::kept_links(*lazy), anew->links());
    test::expect_same(lazy->counts(), anew->counts());
  }
}

TEST(ChangeFeasibleGraph, ALazyGraphKnowsWhatIsFarFromTheChange) {
  const ChangeCase c;
  const auto anew = c.after.finished();
  const auto untouched = c.before.lazy(), known = c.before.lazy();
  (void)test::kept_links(*known);
  const auto change = [&](const FeasibleGraph& before) {
    return change_lazy_feasible_graph(before, c.after.inputs(), c.change, c.threads);
  };
  EXPECT_EQ(change(*untouched)->counts().candidates, 0u);
  const auto finished = c.before.finished();
  const std::vector<const FeasibleGraph*> all{known.get(), finished.get()};
  for (const FeasibleGraph* before : all) {
    const auto changed = change(*before);
    EXPECT_GT(changed->counts().kept, anew->counts().kept / 4);
    EXPECT_LT(changed->counts().kept, anew->counts().kept);
    std::size_t headings = 0;
    for (std::uint32_t circle = 0; circle < changed->circles().size(); ++circle)
      headings += changed->known_headings(circle) ? 1 : 0;
    EXPECT_GT(headings, changed->circles().size() / 2);
    EXPECT_LT(headings, changed->circles().size());
  }
}

}  // namespace
}  // namespace arcway::internal

#include "accel/graphs/lazy_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "accel/backend/make_queries.h"
#include "arcway/accel/parallel.h"
#include "arcway/accel/tangent_cone_graph.h"
#include "arcway/datasets/catalog.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/planner.h"
#include "tests/support/nasty_worlds.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

std::vector<VertexId> copy(std::span<const VertexId> row) { return {row.begin(), row.end()}; }

TEST(LazyRows, AreThoseOfTheGraph) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const World world = test::nasty_world(seed + 9000, 14);
    const auto all = rows_of(world, build_reduced_visibility_graph_by_tangent_cones(world));
    const auto lazy = make_lazy_rows(world);
    for (int round = 0; round < 2; ++round)
      for (VertexId v = 0; v < world.vertices().size(); ++v) ASSERT_EQ(copy(lazy->of(v)), copy(all->of(v))) << seed;
  }
}

TEST(LazyRows, FindTheShortEdgesOfTheGraph) {
  std::size_t found = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const World world = test::nasty_world(seed + 9500, 14);
    const auto all = rows_of(world, build_reduced_visibility_graph_by_tangent_cones(world));
    const auto lazy = make_lazy_rows(world);
    for (const double length : {0.0, 1.0, 2.5, 1e3}) {
      const auto wanted = [](VertexId u, VertexId v) { return (u + v) % 3 != 0; };
      const auto pairs = lazy->pairs_within(length, wanted, TbbExecutor(2));
      ASSERT_EQ(pairs, all->pairs_within(length, wanted, SerialExecutor())) << seed << " " << length;
      found += pairs.size();
    }
  }
  EXPECT_GT(found, 5000u);
}

// One end is the last double before a multiple of the length, the other lies two multiples further.
TEST(LazyRows, FindAnEdgeWhoseLengthIsRoundedToTheLimit) {
  const World world({{{{0, 0}, {0.5, -1}, {1.0 - 0x1p-53, 0}}, {}}, {{{2, 0}, {2.5, -1}, {3, 0}}, {}}});
  const auto all = rows_of(world, build_reduced_visibility_graph_by_tangent_cones(world));
  const auto wanted = [](VertexId u, VertexId v) { return u + v == 5 && (u == 2 || v == 2); };
  ASSERT_EQ(all->pairs_within(1.0, wanted, SerialExecutor()).size(), 1u);
  EXPECT_EQ(make_lazy_rows(world)->pairs_within(1.0, wanted, SerialExecutor()),
            all->pairs_within(1.0, wanted, SerialExecutor()));
}

TEST(LazyRows, AnswerManyThreadsAtOnce) {
  const World world = catalog_world("clutter/star/n200/m9/f30/s3");
  const auto all = rows_of(world, build_reduced_visibility_graph_by_tangent_cones(world));
  const auto lazy = make_lazy_rows(world, TbbExecutor(2));
  std::vector<std::vector<std::vector<VertexId>>> found(4);
  std::vector<std::thread> threads;
  for (auto& rows : found)
    threads.emplace_back([&] {
      for (VertexId v = 0; v < world.vertices().size(); ++v) rows.push_back(copy(lazy->of(v)));
    });
  for (std::thread& thread : threads) thread.join();
  for (const auto& rows : found)
    for (VertexId v = 0; v < world.vertices().size(); ++v) ASSERT_EQ(rows[v], copy(all->of(v))) << v;
}

// Counts the rows asked for so far.
class CountedRows final : public VisibilityRows {
 public:
  CountedRows(std::shared_ptr<const VisibilityRows> rows, std::size_t vertices)
      : rows_(std::move(rows)), asked_(vertices) {}
  [[nodiscard]] std::span<const VertexId> of(VertexId v) const override {
    asked_[v] = true;
    return rows_->of(v);
  }
  [[nodiscard]] std::vector<Pair> pairs_within(double length, const std::function<bool(VertexId, VertexId)>& wanted,
                                               const Executor& executor) const override {
    return rows_->pairs_within(length, wanted, executor);
  }
  [[nodiscard]] std::size_t asked() const { return static_cast<std::size_t>(std::ranges::count(asked_, true)); }

 private:
  std::shared_ptr<const VisibilityRows> rows_;
  mutable std::vector<bool> asked_;
};

TEST(LazyRows, GiveThePlansOfTheWholeGraph) {
  for (const char* name : {"clutter/convex/n300/m10/f30/s1", "clutter/star/n100/m8/f30/s2", "city/v1500/s1",
                           "maze/v600/s1", "warehouse/v800/s1", "adversarial/overlapping/v500/s1"}) {
    SCOPED_TRACE(name);
    const World world = catalog_world(name);
    const Vehicle vehicle;
    const QuerySet queries = make_embree_queries(world);
    const auto rows = std::make_shared<const CountedRows>(make_lazy_rows(world), world.vertices().size());
    const Planner lazy(world, vehicle, backend_of(world, queries, rows), {.graph_mode = GraphMode::kLazy});
    EXPECT_EQ(rows->asked(), 0u);
    const Planner whole(world, vehicle,
                        backend_of(world, queries, build_reduced_visibility_graph_by_tangent_cones(world)));
    EXPECT_EQ(lazy.visibility_graph().vertex_count(), 0u);
    const bool large = world.convex_vertices().size() > 2500;
    std::size_t queries_done = 0;
    for (const PlanRequest& request : random_queries(world, queries, vehicle, {.count = 6, .min_distance = 0.1})) {
      const PlanResult plan = lazy.plan(request);
      test::expect_same_plan(plan, whole.plan(request));
      test::expect_same_plan(lazy.plan(request), plan);
      if (plan.solved()) test::expect_valid(lazy, plan);
      if (large && ++queries_done == 1) {
        EXPECT_LT(rows->asked(), world.convex_vertices().size());
      }
    }
  }
}

}  // namespace
}  // namespace arcway::internal

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <thread>
#include <utility>

#include "accel/backend/make_queries.h"
#include "accel/graphs/lazy_rows.h"
#include "arcway/datasets/catalog.h"
#include "arcway/planner.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

// Rows that record which threads ask for them. After a number of calls the first thread waits for another one to ask.
class WatchedRows final : public VisibilityRows {
 public:
  explicit WatchedRows(std::shared_ptr<const VisibilityRows> rows) : rows_(std::move(rows)) {}

  void wait_after(std::size_t calls) { wait_after_ = calls; }
  [[nodiscard]] std::size_t calls() const { return calls_; }
  [[nodiscard]] bool others_asked() const { return others_asked_; }

  [[nodiscard]] std::span<const VertexId> of(VertexId v) const override {
    {
      std::unique_lock lock(mutex_);
      if (std::this_thread::get_id() != first_) {
        others_asked_ = true;
        changed_.notify_one();
      } else if (++calls_ > wait_after_) {
        changed_.wait_for(lock, std::chrono::seconds(20), [&] { return others_asked_; });
      }
    }
    return rows_->of(v);
  }
  [[nodiscard]] std::vector<Pair> pairs_within(double length, const std::function<bool(VertexId, VertexId)>& wanted,
                                               const Executor& executor) const override {
    return rows_->pairs_within(length, wanted, executor);
  }

 private:
  std::shared_ptr<const VisibilityRows> rows_;
  std::thread::id first_ = std::this_thread::get_id();
  std::size_t wait_after_ = std::numeric_limits<std::size_t>::max();
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  mutable std::size_t calls_ = 0;
  mutable bool others_asked_ = false;
};

TEST(Prefetch, FindsWhatALongSearchWillAskForAndNothingElseChanges) {
  const World world = catalog_world("clutter/convex/n1000/m10/f15/s1");
  const Vehicle vehicle;
  const QuerySet queries = make_embree_queries(world);
  const PlanRequest request{.start = {5, 5, 0.3}, .goal = {world.box().max.x() - 5.0, world.box().max.y() - 5.0, 1.2}};
  const PlannerOptions options{.heuristic = Heuristic::kDijkstra, .graph_mode = GraphMode::kLazy};
  const auto alone = std::make_shared<WatchedRows>(make_lazy_rows(world));
  const PlanResult expected = Planner(world, vehicle, backend_of(world, queries, alone), options).plan(request);
  ASSERT_TRUE(expected.solved()) << expected.reason;
  EXPECT_FALSE(alone->others_asked());

  const auto rows = std::make_shared<WatchedRows>(make_lazy_rows(world));
  rows->wait_after(alone->calls() / 2);
  const Planner planner(world, vehicle, backend_of(world, queries, rows), options);
  const PlanResult found = planner.plan(request, {.prefetch = true});
  EXPECT_TRUE(rows->others_asked());
  test::expect_same_plan(found, expected);
  test::expect_valid(planner, found);
}

TEST(Prefetch, StaysWhereItIsOnAnEagerGraph) {
  const World world = catalog_world("clutter/convex/n1000/m10/f15/s1");
  const PlanRequest request{.start = {5, 5, 0.3}, .goal = {world.box().max.x() - 5.0, world.box().max.y() - 5.0, 1.2}};
  const auto rows = std::make_shared<WatchedRows>(make_lazy_rows(world));
  const Planner planner(world, Vehicle{}, backend_of(world, make_embree_queries(world), rows),
                        {.heuristic = Heuristic::kDijkstra, .graph_mode = GraphMode::kEager});
  const PlanResult found = planner.plan(request, {.prefetch = true});
  EXPECT_GT(found.statistics.nodes_expanded, 4000u);
  EXPECT_FALSE(rows->others_asked());
}

}  // namespace
}  // namespace arcway::internal

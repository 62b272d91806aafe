#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <mutex>

#include "arcway/datasets/clutter.h"
#include "arcway/feasible_graph_snapshot.h"
#include "arcway/planner.h"
#include "core/roadmap/feasible_graph.h"
#include "tests/support/same_graphs.h"
#include "tests/support/thread_team.h"

namespace arcway::internal {
namespace {

struct Case {
  World world = random_world({.kind = ClutterKind::kStar, .obstacles = 20, .vertices = 6, .fill = 0.3, .seed = 5});
  Vehicle vehicle;
  QuerySet queries = make_reference_queries(world);
  VisibilityGraph visibility = build_reduced_visibility_graph(world, *queries.visibility);
  std::shared_ptr<const VisibilityRows> rows = rows_of(world, visibility);
  std::vector<double> radii = {vehicle.min_turning_radius(), 2.0 * vehicle.min_turning_radius()};
  FeasibleGraph graph{world, vehicle, visibility, queries, radii, SerialExecutor()};
};

TEST(FeasibleGraphSnapshot, GiveTheSameGraphAgain) {
  const Case c;
  ASSERT_GT(c.graph.links().size(), 100u);
  test::expect_same(FeasibleGraph(c.world, c.vehicle, c.rows, c.queries, c.radii, c.graph.snapshot()), c.graph);
}

TEST(FeasibleGraphSnapshot, AProcessGroupBuildsTheSameGraph) {
  const Case c;
  for (const std::size_t size : {2u, 3u, 7u, 500u}) {
    std::mutex mutex;
    test::run_process_group(size, [&](const ProcessGroup& process_group) {
      const FeasibleGraph graph(c.world, c.vehicle, c.visibility, c.queries, c.radii, SerialExecutor(),
                                GraphMode::kEager, process_group);
      const std::scoped_lock lock(mutex);
      if (process_group.rank() % 50 < 3) test::expect_same(graph, c.graph);
    });
  }
}

TEST(FeasibleGraphSnapshot, ThoseOfNoGraphAreRefusedWithTheEntryAtFault) {
  const Case c;
  const FeasibleGraphSnapshot snapshot = c.graph.snapshot();
  const std::size_t circles = c.graph.circles().size();
  const std::size_t busy = snapshot.links[0].from;
  struct Spoiled {
    SnapshotArray array;
    std::size_t index;
    std::function<void(FeasibleGraphSnapshot&)> spoil;
  };
  const Spoiled cases[] = {
      {SnapshotArray::kIntervalStarts, circles, [](FeasibleGraphSnapshot& t) { t.interval_starts.pop_back(); }},
      {SnapshotArray::kIntervalStarts, circles, [](FeasibleGraphSnapshot& t) { ++t.interval_starts.back(); }},
      {SnapshotArray::kIntervalStarts, 0, [](FeasibleGraphSnapshot& t) { t.interval_starts.front() = 1; }},
      {SnapshotArray::kIntervals, 0, [](FeasibleGraphSnapshot& t) { t.intervals[0].low = -1.0; }},
      {SnapshotArray::kLinkStarts, busy + 2,
       [&](FeasibleGraphSnapshot& t) { t.link_starts[busy + 1] = t.links.size(); }},
      {SnapshotArray::kLinks, 0, [](FeasibleGraphSnapshot& t) { t.links[0].to = 0xFFFFFFFF; }},
      {SnapshotArray::kLinks, 0, [](FeasibleGraphSnapshot& t) { ++t.links[0].from; }},
      {SnapshotArray::kLinks, 0, [](FeasibleGraphSnapshot& t) { t.links[0].heading = 7.0; }},
      {SnapshotArray::kLinks, 0, [](FeasibleGraphSnapshot& t) { t.links[0].length = -1.0; }},
      {SnapshotArray::kLinkCounts, circles - 1, [](FeasibleGraphSnapshot& t) { t.link_counts.pop_back(); }},
  };
  for (const Spoiled& spoiled : cases) {
    FeasibleGraphSnapshot other = snapshot;
    spoiled.spoil(other);
    try {
      const FeasibleGraph graph(c.world, c.vehicle, c.rows, c.queries, c.radii, std::move(other));
      ADD_FAILURE() << "took " << name_of(spoiled.array) << " " << spoiled.index;
    } catch (const SnapshotError& error) {
      EXPECT_EQ(error.array(), spoiled.array) << error.what();
      EXPECT_EQ(error.index(), spoiled.index) << error.what();
    }
  }
}

TEST(PreparedGraph, PlansAsThePlannerThatBuiltIt) {
  const Case c;
  const Planner built(c.world, c.vehicle);
  const Planner taken = Planner::restored(c.world, c.vehicle, backend_of(c.world, c.queries), built.prepared_graph());
  test::expect_same(taken.feasible_graph(), built.feasible_graph());
  const PlanRequest request{{1, 1, 0}, {20, 20, 1}};
  EXPECT_EQ(taken.plan(request).travel_time, built.plan(request).travel_time);
  const World other = random_world({.obstacles = 7, .vertices = 5, .fill = 0.3, .seed = 5});
  EXPECT_THROW(Planner::restored(other, c.vehicle, reference_backend(other), built.prepared_graph()), SnapshotError);
}

}  // namespace
}  // namespace arcway::internal

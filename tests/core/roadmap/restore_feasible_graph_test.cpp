#include "core/roadmap/restore_feasible_graph.h"

#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "arcway/datasets/clutter.h"
#include "arcway/planner.h"
#include "arcway/snapshot.h"
#include "tests/support/graph_case.h"
#include "tests/support/same_graphs.h"

namespace arcway::internal {
namespace {

TEST(RestoreFeasibleGraph, GivesTheSameGraphAgain) {
  const test::GraphCase c;
  const auto graph = c.finished();
  ASSERT_GT(graph->links().size(), 100u);
  test::expect_same(*restore_feasible_graph(c.inputs(), graph->snapshot()), *graph);
}

TEST(RestoreFeasibleGraph, RefusesTablesOfNoGraphWithTheEntryAtFault) {
  const test::GraphCase c;
  const auto graph = c.finished();
  const FeasibleGraphSnapshot tables = graph->snapshot();
  const std::size_t circles = graph->circles().size();
  const std::size_t busy = tables.links[0].from;
  struct Spoiled {
    SnapshotArray table;
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
    FeasibleGraphSnapshot other = tables;
    spoiled.spoil(other);
    try {
      (void)restore_feasible_graph(c.inputs(), std::move(other));
      ADD_FAILURE() << "took " << name_of(spoiled.table) << " " << spoiled.index;
    } catch (const SnapshotError& error) {
      EXPECT_EQ(error.array(), spoiled.table) << error.what();
      EXPECT_EQ(error.index(), spoiled.index) << error.what();
    }
  }
}

TEST(PreparedGraph, PlansAsThePlannerThatBuiltIt) {
  const test::GraphCase c;
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

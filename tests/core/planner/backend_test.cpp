#include "arcway/backend.h"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "arcway/datasets/clutter.h"
#include "arcway/planner.h"
#include "core/roadmap/feasible_graph.h"

namespace arcway::internal {
namespace {

World clutter() { return random_world({.obstacles = 20, .vertices = 6, .fill = 0.2, .seed = 3}); }

// Parts that count how often each is made.
struct Counts {
  int queries = 0, graphs = 0, rows = 0, changes = 0;
};

Backend counting_backend(const World& world, Counts& counts, bool with_rows) {
  Backend::Parts parts{.queries =
                           [&counts](const Backend& b) {
                             ++counts.queries;
                             return make_reference_queries(b.world());
                           },
                       .reduced_graph =
                           [&counts](const Backend& b) {
                             ++counts.graphs;
                             return std::make_shared<const VisibilityGraph>(
                                 build_reduced_visibility_graph(b.world(), *b.queries().visibility));
                           }};
  if (with_rows)
    parts.lazy_rows = [&counts](const Backend& b) {
      ++counts.rows;
      return rows_of(b.world(), build_reduced_visibility_graph(b.world(), *b.queries().visibility));
    };
  parts.changed_graph = [&counts](const Backend& b, const VisibilityGraph&, const WorldChange&) {
    ++counts.changes;
    return std::make_shared<const VisibilityGraph>(build_reduced_visibility_graph(b.world(), *b.queries().visibility));
  };
  return {world, std::move(parts), kSerialExecutor};
}

TEST(Backend, MakesQueriesOnceAndGraphsForEachPlanner) {
  Counts counts;
  const World world = clutter();
  const Backend backend = counting_backend(world, counts, false);
  EXPECT_EQ(counts.queries, 0);
  const Planner first(world, Vehicle{}, backend), second(world, Vehicle{}, backend);
  EXPECT_EQ(counts.queries, 1);
  EXPECT_EQ(counts.graphs, 2);
  EXPECT_NE(first.feasible_graph().finished(), nullptr);
  EXPECT_EQ(first.options().graph_mode, GraphMode::kEager);
  EXPECT_EQ(first.visibility_graph(), Planner(world, Vehicle{}).visibility_graph());
}

TEST(Backend, ItsPlannersAreLazyWhereItHasLazyRows) {
  Counts counts;
  const World world = clutter();
  const Backend backend = counting_backend(world, counts, true);
  const Planner lazy(world, Vehicle{}, backend);
  EXPECT_EQ(lazy.feasible_graph().finished(), nullptr);
  EXPECT_EQ(lazy.options().graph_mode, GraphMode::kLazy);
  EXPECT_EQ(counts.graphs, 0);
  EXPECT_EQ(counts.rows, 1);
  const Planner eager(world, Vehicle{}, backend, {.graph_mode = GraphMode::kEager});
  EXPECT_NE(eager.feasible_graph().finished(), nullptr);
  EXPECT_EQ(counts.graphs, 1);
  EXPECT_EQ(counts.rows, 1);
  const PlanRequest request{{-1, -1, 0.3}, {30, 30, 1}};
  EXPECT_EQ(lazy.plan(request).travel_time, eager.plan(request).travel_time);
}

TEST(Backend, ChangesTheGraphOfAPlannerThatHasOne) {
  Counts counts;
  const World world = clutter();
  const std::vector<ObstacleId> removed{4};
  const World after = world.changed(removed, {});
  const WorldChange change(world, after, removed);
  const Backend backend = counting_backend(after, counts, true);
  const Planner eager(world, Vehicle{});
  const Planner changed = Planner::changed(eager, change, backend);
  EXPECT_EQ(counts.changes, 1);
  EXPECT_NE(changed.feasible_graph().finished(), nullptr);
  EXPECT_EQ(changed.visibility_graph(), Planner(after, Vehicle{}).visibility_graph());
  Counts of_before;
  const Planner lazy(world, Vehicle{}, counting_backend(world, of_before, true));
  const Planner lazily_changed = Planner::changed(lazy, change, backend);
  EXPECT_EQ(counts.changes, 1);
  EXPECT_EQ(counts.rows, 1);
  const PlanRequest request{{-1, -1, 0.3}, {30, 30, 1}};
  EXPECT_EQ(lazily_changed.plan(request).travel_time, changed.plan(request).travel_time);
}

TEST(Backend, RefusesMissingParts) {
  const World world = clutter();
  EXPECT_THROW(Backend(world, {}, kSerialExecutor), std::invalid_argument);
  EXPECT_THROW(
      Backend(world, {.queries = [](const Backend& b) { return make_reference_queries(b.world()); }}, kSerialExecutor),
      std::invalid_argument);
  EXPECT_THROW(static_cast<void>(backend_of(world, QuerySet{}).queries()), std::invalid_argument);
  EXPECT_THROW(Planner(clutter().changed(std::vector<ObstacleId>{0}, {}), Vehicle{}, reference_backend(world)),
               std::invalid_argument);
}

}  // namespace
}  // namespace arcway::internal

#include "core/planner/plan_maps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "arcway/datasets/clutter.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/planner.h"
#include "arcway/visibility_graph.h"
#include "arcway/world_change.h"
#include "core/model/outlines.h"
#include "core/model/vertex_map.h"
#include "core/motion/speed_profile.h"
#include "core/planner/planner_maps.h"
#include "core/refine/refine_path.h"
#include "core/roadmap/lazy_feasible_graph.h"
#include "core/search/arrival_search.h"
#include "tests/support/graph_case.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

Vehicle driven_by(const TurnSpeedLaw& law, double max_speed = VehicleParameters().max_speed) {
  VehicleParameters parameters;
  parameters.max_speed = max_speed;
  parameters.turn_speed = law;
  parameters.max_acceleration = 2.0;
  return Vehicle(parameters);
}

TEST(WithOtherTurns, TakesTurnsWithSoManyTimesTheLateralAcceleration) {
  for (const TurnSpeedLaw& law : {TurnSpeedLaw(ConstantTurnSpeed{5.0}), TurnSpeedLaw(LateralAccelerationLimit{2.0}),
                                  TurnSpeedLaw(TurnSpeedTable{{{1.5, 2.0}, {6.0, 5.0}, {40.0, 11.0}}})}) {
    const Vehicle vehicle = driven_by(law), unlimited = driven_by(law, 1000.0);
    for (const double factor : {0.5, 1.0, 2.0, 16.0}) {
      const Vehicle other = with_other_turns(vehicle, factor);
      for (const double radius : {1.3, 2.0, 7.0, 30.0, 300.0})
        EXPECT_NEAR(other.turn_speed(radius),
                    std::min(vehicle.max_speed(), std::sqrt(factor) * unlimited.turn_speed(radius)), 1e-12);
      EXPECT_EQ(other.min_turning_radius(), vehicle.min_turning_radius());
      EXPECT_EQ(other.max_speed(), vehicle.max_speed());
    }
  }
}

Roadmap lazy_map(const Planner& planner, const std::vector<double>& radii) {
  return {
      planner.world(),
      planner.vehicle(),
      planner.queries(),
      radii,
      std::make_shared<const LazyFeasibleGraph>(
          FeasibleGraphInputs{planner.world(), planner.vehicle(), planner.visibility_rows(), planner.queries(), radii},
          SerialExecutor()),
      std::make_shared<const Outlines>(planner.world())};
}

std::vector<const Roadmap*> maps_of(const OtherMaps& maps) {
  std::vector<const Roadmap*> found;
  for (const OtherRoute& route : routes_of_strategy())
    if (const Roadmap* map = maps.find(route)) found.push_back(map);
  return found;
}

class SeveralRadii : public testing::TestWithParam<ClutterKind> {
 protected:
  World world_ = random_world({.kind = GetParam(), .obstacles = 30, .vertices = 8, .fill = 0.2, .seed = 4});
  Vehicle vehicle_ = driven_by(LateralAccelerationLimit{2.0});
  QuerySet queries_ = make_reference_queries(world_);
  Planner planner_{world_, vehicle_, backend_of(world_, queries_)};
  std::vector<PlanRequest> requests_ = random_queries(world_, queries_, vehicle_, {.count = 6, .seed = 5});

  [[nodiscard]] Planner with_radii(std::vector<double> radii, const PlannerOptions& options = {}) const {
    PlannerOptions o = options;
    o.radii = std::move(radii);
    return {world_, vehicle_, backend_of(world_, queries_, planner_.visibility_graph()), o};
  }
};

TEST_P(SeveralRadii, NoPlanIsSlowerThanThatOfTheSmallestAlone) {
  ASSERT_GT(planner_.options().radii.size(), 3u);
  // A slower plan is further from its bound, and trees of a slim body then look for a faster one.
  const PlannerOptions options{
      .leave_out = {"trees of a slim body, for a faster path", "other ways by trees", "refinement at length"}};
  const Planner smallest = with_radii({vehicle_.min_turning_radius()}, options);
  int solved = 0, faster = 0;
  for (const PlanRequest& request : requests_) {
    const PlanResult plan = planner_.plan(request);
    const PlanResult tight = smallest.plan(request);
    EXPECT_TRUE(plan.solved() || !tight.solved());
    if (!plan.solved()) continue;
    test::expect_valid(planner_, plan);
    ++solved;
    if (!tight.solved()) continue;
    EXPECT_LE(plan.travel_time, tight.travel_time);
    faster += plan.travel_time < 0.98 * tight.travel_time ? 1 : 0;
  }
  EXPECT_GT(solved, 3);
  EXPECT_GT(faster, 0);
}

TEST_P(SeveralRadii, OtherWaysArePathsOfTheirMaps) {
  const std::vector<double>& radii = planner_.options().radii;
  const Roadmap all = lazy_map(planner_, radii), smallest = lazy_map(planner_, {radii.front()});
  const OtherMaps other_maps(all, smallest, routes_of_strategy(),
                             LazyGraphs(planner_.visibility_rows(), SerialExecutor(), nullptr), nullptr);
  const std::vector<const Roadmap*> maps = maps_of(other_maps);
  EXPECT_GE(maps.size(), 2u);
  ArrivalSearch search;
  int other = 0;
  for (const PlanRequest& request : requests_) {
    const PlanResult plan = planner_.plan(request);
    if (!plan.solved()) continue;
    const std::vector<Attachment> starts{{request.start, {}}}, goals{{request.goal, {}}};
    const auto usual = search.find(all, starts, goals, {}).path;
    for (const Roadmap* other_map : maps) {
      const Roadmap& map = *other_map;
      EXPECT_TRUE(std::ranges::includes(radii, map.radii.of(Side::kLeft)));
      EXPECT_GE(map.vehicle.turn_speed(radii.front()), vehicle_.turn_speed(radii.front()));
      const auto path = search.find(map, starts, goals, {}).path;
      if (!path || !usual) continue;
      // None is faster before refinement, as the graph of all radii holds them all.
      const double time = speed_profile(*path, vehicle_).total_time;
      EXPECT_GE(time, speed_profile(*usual, vehicle_).total_time * (1.0 - 1e-12));
      other += time > speed_profile(*usual, vehicle_).total_time ? 1 : 0;
      EXPECT_LE(plan.travel_time, time);
    }
  }
  EXPECT_GT(other, 0);
}

// Vertices of the world after a change that have other neighbors than before.
std::vector<VertexId> differing(const Planner& before, const Planner& after, const VertexMap& map) {
  std::vector<VertexId> differ;
  for (const VertexId v : after.world().convex_vertices()) {
    const VertexId was = map.before(v);
    std::vector<VertexId> row;
    if (was != kNone)
      for (const VertexId w : before.visibility_rows()->of(was)) row.push_back(map.after(w));
    if (was == kNone || !std::ranges::equal(row, after.visibility_rows()->of(v))) differ.push_back(v);
  }
  return differ;
}

TEST_P(SeveralRadii, GraphsKeepWhatWasFoundBeforeAChange) {
  const std::vector<double> tightest{planner_.options().radii.front()};
  const Roadmap before = lazy_map(planner_, tightest);
  for (std::uint32_t c = 0; c < before.graph->circles().size(); ++c) (void)before.graph->links_from(c);
  const std::vector<ObstacleId> removed{0};
  const Planner after(planner_.world().changed(removed, {}), vehicle_);
  const WorldChange change(planner_.world(), after.world(), removed);
  const std::vector<VertexId> may_differ = differing(planner_, after, VertexMap(change));
  const LazyGraphs::Change what{change, may_differ};
  const Roadmap anew = lazy_map(after, tightest);
  const LazyGraphs graphs(after.visibility_rows(), SerialExecutor(), &what);
  const auto graph = graphs.map_of(anew, tightest, &before).graph;
  const auto known_rows = [](const FeasibleGraph& g) {
    std::size_t known = 0;
    for (std::uint32_t c = 0; c < g.circles().size(); ++c) known += g.known_row(c) ? 1 : 0;
    return known;
  };
  EXPECT_GT(known_rows(*graph), anew.graph->circles().size() / 10);
  for (std::uint32_t c = 0; c < anew.graph->circles().size(); ++c)
    test::expect_same(graph->links_from(c), anew.graph->links_from(c));
  EXPECT_EQ(known_rows(*graphs.map_of(anew, tightest, nullptr).graph), 0u);
  EXPECT_EQ(known_rows(*graphs.map_of(anew, planner_.options().radii, &before).graph), 0u) << "of other radii";
}

TEST_P(SeveralRadii, NoOtherWayIsLookedForTwice) {
  const std::vector<double>& radii = planner_.options().radii;
  for (const std::size_t count : {std::size_t{2}, radii.size()}) {
    const PlanMaps all(lazy_map(planner_, {radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(count)}), false);
    const PlanMaps smallest(lazy_map(planner_, {radii.front()}), false);
    const OtherMaps other_maps(all.plain, smallest.plain, routes_of_strategy(),
                               LazyGraphs(planner_.visibility_rows(), SerialExecutor(), nullptr), nullptr);
    std::vector<std::pair<std::vector<double>, double>> ways;
    const auto add = [&](const Roadmap& map) {
      const double limit = std::get<LateralAccelerationLimit>(map.vehicle.parameters().turn_speed).lateral_acceleration;
      ways.emplace_back(std::vector(map.radii.of(Side::kLeft).begin(), map.radii.of(Side::kLeft).end()), limit);
    };
    // The first of the other routes is that of all radii with faster turns.
    for (const Roadmap* map :
         {&all.plain, &all.slower_turns, &smallest.plain, &smallest.faster_turns, &smallest.slower_turns})
      add(*map);
    for (const Roadmap* map : maps_of(other_maps)) add(*map);
    std::ranges::sort(ways);
    EXPECT_EQ(std::ranges::adjacent_find(ways), ways.end()) << count << " radii";
  }
}

TEST_P(SeveralRadii, WithoutRefinementTheGraphsFastestPathIsThePlan) {
  const Planner plain = with_radii(
      {}, {.maneuver_poses = 0, .gap_circles = false, .refinement = {.max_trials = 0}, .leave_out = {"first path"}});
  int solved = 0;
  for (const PlanRequest& request : requests_) {
    const PlanResult plan = plain.plan(request);
    if (!plan.solved()) continue;
    ++solved;
    EXPECT_EQ(plan.travel_time, plan.statistics.first_travel_time);
    EXPECT_EQ(plan.statistics.refine_trials, 0u);
  }
  EXPECT_GE(solved, 3);
}

class OneRadius : public testing::TestWithParam<ClutterKind> {};

TEST_P(OneRadius, NoPlanIsSlowerThanTheOtherWaysRefined) {
  const World world = random_world({.kind = GetParam(), .obstacles = 40, .vertices = 8, .fill = 0.25, .seed = 11});
  const Vehicle vehicle;
  const QuerySet queries = make_reference_queries(world);
  const Planner planner(world, vehicle, backend_of(world, queries));
  const std::vector<double> radii = planner.options().radii;
  ASSERT_EQ(radii.size(), 1u);
  const PlanMaps maps(lazy_map(planner, radii), false);
  EXPECT_GT(maps.faster_turns.vehicle.turn_speed(radii[0]), vehicle.turn_speed(radii[0]));
  EXPECT_LT(maps.slower_turns.vehicle.turn_speed(radii[0]), vehicle.turn_speed(radii[0]));
  const Outlines outlines(world);
  ArrivalSearch search;
  int other = 0;
  for (const PlanRequest& request : random_queries(world, queries, vehicle, {.count = 40, .seed = 5})) {
    const PlanResult plan = planner.plan(request);
    if (!plan.solved()) continue;
    test::expect_valid(planner, plan);
    const std::vector<Attachment> starts{{request.start, {}}}, goals{{request.goal, {}}};
    for (const Roadmap* map : {&maps.faster_turns, &maps.slower_turns}) {
      const auto path = search.find(*map, starts, goals, {}).path;
      if (!path || plan.travel_time <= 1.01 * plan.lower_bound) continue;
      const RefinedPath refined =
          refine_path({*path, request.start, request.goal, vehicle, *queries.sweep, {}, {}, &world, &outlines});
      EXPECT_LE(plan.travel_time, refined.travel_time * (1.0 + 1e-12));
      other += speed_profile(*path, vehicle).total_time > plan.statistics.first_travel_time ? 1 : 0;
    }
  }
  EXPECT_GT(other, 0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, OneRadius, testing::Values(ClutterKind::kConvex, ClutterKind::kStar));
INSTANTIATE_TEST_SUITE_P(Kinds, SeveralRadii, testing::Values(ClutterKind::kConvex, ClutterKind::kStar));

}  // namespace
}  // namespace arcway::internal

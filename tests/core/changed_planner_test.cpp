// Planners after changes of the map, against planners built anew.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "arcway/datasets/clutter.h"
#include "arcway/datasets/map_file.h"
#include "arcway/planner.h"
#include "core/roadmap/feasible_graph.h"
#include "tests/support/nasty_worlds.h"
#include "tests/support/plans.h"
#include "tests/support/same_graphs.h"

namespace arcway::internal {
namespace {

std::string bits_of(const PlanResult& result) {
  std::string bits;
  const auto add = [&bits](const auto& value) { bits.append(reinterpret_cast<const char*>(&value), sizeof value); };
  add(result.status);
  for (const double value : {result.travel_time, result.length, result.lower_bound, result.min_clearance}) add(value);
  for (const TimedSegment& s : result.segments)
    for (const double value : {s.segment.start.x, s.segment.start.y, s.segment.start.heading, s.segment.length,
                               s.segment.curvature, s.speed_in, s.speed_out, s.duration})
      add(value);
  return bits;
}

Planner changed(const Planner& before, const World& after, std::span<const ObstacleId> removed,
                const PlannerOptions& options) {
  const ThreadExecutor threads(2);
  return Planner::changed(before, WorldChange(before.world(), after, removed),
                          backend_of(after, make_reference_queries(after), threads), options);
}

// Free or not.
Pose draw_pose(const World& world, test::RandomInputs& random) {
  Box box = world.box();
  box.extend(Vec2(0, 0));
  return {random.uniform(box.min.x(), box.max.x()), random.uniform(box.min.y(), box.max.y()),
          random.uniform(0.0, 6.28)};
}

std::vector<ObstacleKey> keys_of(const World& world, std::span<const ObstacleId> obstacles) {
  std::vector<ObstacleKey> keys;
  for (const ObstacleId o : obstacles) keys.push_back(world.key_of(o));
  std::ranges::reverse(keys);  // in no order
  return keys;
}

// Steps of removing some obstacles and adding others, by a chain of eager planners and one of lazy ones; the lazy one
// finds something out between the steps. A third chain makes its own worlds.
// @returns how many plans there were.
std::size_t expect_changes(World world, const Vehicle& vehicle, test::RandomInputs& random, int steps,
                           std::int64_t one_in, const std::vector<double>& radii, const auto& draw_added) {
  const RefineOptions short_refinement{.max_trials = 300};  // what changes is what comes before it
  PlannerOptions eager_options{.radii = radii, .refinement = short_refinement};
  PlannerOptions lazy_options{.graph_mode = GraphMode::kLazy, .radii = radii, .refinement = short_refinement};
  Planner eager(world, vehicle, eager_options), lazy(world, vehicle, lazy_options), own = lazy;
  std::size_t solved = 0;
  for (int step = 0; step < steps; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    std::vector<ObstacleId> removed;
    for (ObstacleId o = 0; o < world.obstacle_count(); ++o)
      if (random.integer(1, one_in) == 1) removed.push_back(o);
    const std::vector<Polygon> added = draw_added();
    own.change_obstacles(keys_of(own.world(), removed), added);
    world = world.changed(removed, added);
    eager = changed(eager, world, removed, eager_options);
    lazy = changed(lazy, world, removed, lazy_options);
    const Planner anew(world, vehicle, eager_options);
    test::expect_same(eager.feasible_graph(), anew.feasible_graph());
    if (testing::Test::HasFailure()) return solved;
    for (int i = 0; i < 5; ++i) {
      const PlanRequest request{draw_pose(world, random), draw_pose(world, random)};
      const PlanResult expected = anew.plan(request);
      EXPECT_EQ(bits_of(lazy.plan(request)), bits_of(expected));
      EXPECT_EQ(bits_of(own.plan(request)), bits_of(expected));
      EXPECT_EQ(bits_of(eager.plan(request)), bits_of(expected));
      if (testing::Test::HasFailure()) return solved;
      if (!expected.solved()) continue;
      test::expect_valid(anew, expected);
      ++solved;
    }
  }
  return solved;
}

// Copies of obstacles, some of them moved by an edge of theirs, so that they touch or overlap others.
std::vector<Polygon> draw_copies(const std::vector<Polygon>& obstacles, test::RandomInputs& random) {
  std::vector<Polygon> added;
  while (random.integer(0, 2) != 0) {
    Polygon copy =
        obstacles[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(obstacles.size()) - 1))];
    const Vec2 shift = static_cast<double>(random.integer(0, 3)) * (copy.outer[1] - copy.outer[0]);
    for (Vec2& p : copy.outer) p += shift;
    added.push_back(std::move(copy));
  }
  return added;
}

TEST(ChangedPlanner, PlansAsOneBuiltAnewInClutter) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const World world = random_world({.kind = seed % 2 == 0 ? ClutterKind::kStar : ClutterKind::kConvex,
                                      .obstacles = 25,
                                      .vertices = 6,
                                      .fill = 0.15,
                                      .seed = seed});
    const std::vector<Polygon> obstacles = to_map_file(world).obstacles;
    test::RandomInputs random(seed);
    VehicleParameters parameters;
    if (seed % 3 == 0) parameters.turn_speed = LateralAccelerationLimit{2.0};
    const std::size_t solved =
        expect_changes(world, Vehicle(parameters), random, 4, 12, {}, [&] { return draw_copies(obstacles, random); });
    EXPECT_GT(solved, 0u);
    if (HasFailure()) return;
  }
}

TEST(ChangedPlanner, PlansAsOneBuiltAnewInNastyWorlds) {
  const Vehicle vehicle({.length = 0.3, .width = 0.16, .wheelbase = 0.26, .safety_margin = 0.01});
  std::size_t solved = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::RandomInputs random(seed);
    const std::vector<double> radii{vehicle.min_turning_radius(), 2.0 * vehicle.min_turning_radius()};
    solved += expect_changes(test::nasty_world(seed, 12), vehicle, random, 4, 4, radii, [&] {
      return random.integer(0, 2) == 0 ? std::vector<Polygon>{}
                                       : to_map_file(test::nasty_world(random.bits(), 3)).obstacles;
    });
    if (HasFailure()) return;
  }
  EXPECT_GT(solved, 40u);
}

TEST(ChangedPlanner, ChecksFewCirclesForAChangeOfOneObstacle) {
  const World world = random_world({.obstacles = 300, .vertices = 6, .fill = 0.2, .seed = 3});
  const PlannerOptions options{.graph_mode = GraphMode::kLazy};
  const Planner before(world, Vehicle{});
  const std::vector<ObstacleId> removed{150};
  const World after = world.changed(removed, {});
  const FeasibleGraphCounts kept = changed(before, after, removed, options).feasible_graph().counts();
  EXPECT_GT(kept.candidates, before.feasible_graph().counts().candidates / 2);
  EXPECT_LT(kept.candidates, before.feasible_graph().counts().candidates);
}

TEST(ChangedPlanner, RefusesAChangeOfAnotherWorld) {
  const World world = random_world({.obstacles = 5, .vertices = 5, .fill = 0.2, .seed = 3});
  const World other = random_world({.obstacles = 6, .vertices = 5, .fill = 0.2, .seed = 3});
  const World after = world.changed(std::vector<ObstacleId>{2}, {});
  const WorldChange change(world, after, std::vector<ObstacleId>{2});
  const auto take = [&](const World& from, const World& to) {
    return Planner::changed(Planner(from, Vehicle{}), change, reference_backend(to));
  };
  EXPECT_NO_THROW(take(world, after));
  EXPECT_THROW(take(other, after), std::invalid_argument);
  EXPECT_THROW(take(world, other), std::invalid_argument);
}

TEST(ChangedPlanner, LeavesThePlannerBeforeAsItIs) {
  const World world = random_world({.obstacles = 8, .vertices = 5, .fill = 0.2, .seed = 3});
  const Planner before(world, Vehicle{});
  const std::optional<Pose> start = before.nearest_free({0, 0, 0.3}), goal = before.nearest_free({10, 9, 1});
  ASSERT_TRUE(start && goal);
  const PlanRequest request{*start, *goal};
  EXPECT_TRUE(before.plan(request).solved()) << before.plan(request).reason;
  const std::string bits = bits_of(before.plan(request));
  const std::vector<ObstacleKey> removed{2, 5};
  const Planner after = before.with_obstacles(removed, {});
  EXPECT_EQ(before.world().obstacle_count(), 8u);
  EXPECT_EQ(after.world().obstacle_count(), 6u);
  EXPECT_EQ(bits_of(before.plan(request)), bits);
}

// In place, with a key that there is not, and with an obstacle that is none.
TEST(ChangedPlanner, StaysAsItIsIfAChangeInPlaceThrows) {
  const World world = random_world({.obstacles = 8, .vertices = 5, .fill = 0.2, .seed = 3});
  Planner planner(world, Vehicle{}, PlannerOptions{.graph_mode = GraphMode::kLazy});
  const std::vector<ObstacleKey> first{0}, none{8};
  const Ring line{{0, 0}, {1, 0}, {2, 0}};
  const void* const data = planner.world().vertices().data();
  EXPECT_THROW(planner.change_obstacles(none, {}), std::invalid_argument);
  EXPECT_THROW(planner.change_obstacles(first, {{line, {}}}), WorldError);
  EXPECT_EQ(planner.world().vertices().data(), data);
  planner.change_obstacles(first, {});
  EXPECT_EQ(planner.world().obstacle_count(), world.obstacle_count() - 1);
}

// Warming up for changes makes two of them, so that the first ones find the arrays of worlds that are gone.
TEST(ChangedPlanner, IsWarmForTheFirstChangesIfWanted) {
  const World world = random_world({.obstacles = 8, .vertices = 5, .fill = 0.2, .seed = 3});
  int changes = 0;
  const auto queries = [](const Backend& b) { return make_reference_queries(b.world()); };
  const auto graph = [](const Backend& b) {
    return std::make_shared<const VisibilityGraph>(
        build_reduced_visibility_graph(b.world(), *b.queries().visibility, kSerialExecutor));
  };
  const Backend::Parts parts{.queries = queries, .reduced_graph = graph};
  Backend::Parts counted = parts;
  counted.changed_parts = [&](const Backend&, const World& after, const WorldChange& change) {
    ++changes;
    EXPECT_EQ(after.obstacle_count(), 8u);
    EXPECT_EQ(change.removed_boxes.size(), 1u);
    return parts;
  };
  const Planner planner(world, Vehicle{}, Backend(world, counted, kSerialExecutor));
  planner.warm_up();
  EXPECT_EQ(changes, 0);
  planner.warm_up(1, true);
  EXPECT_EQ(changes, 2);
  const World empty{std::vector<Polygon>{}};
  Planner(empty, Vehicle{}, Backend(empty, counted, kSerialExecutor)).warm_up(1, true);
  EXPECT_EQ(changes, 2) << "there is nothing to change";
  EXPECT_THROW(Planner(world, Vehicle{}, backend_of(world, make_reference_queries(world))).warm_up(1, true),
               std::invalid_argument);
}

TEST(ChangedPlanner, RefusesKeysThatNoObstacleHas) {
  const Planner before(random_world({.obstacles = 4, .vertices = 5, .fill = 0.2, .seed = 3}), Vehicle{});
  const auto error_of = [](const Planner& planner, const std::vector<ObstacleKey>& removed) -> std::string {
    try {
      (void)planner.with_obstacles(removed, {});
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_NE(error_of(before, {4}).find("has the key 4"), std::string::npos);
  EXPECT_NE(error_of(before, {1, 3, 1}).find("the key 1 is named twice"), std::string::npos);
  const Planner after = before.with_obstacles(std::vector<ObstacleKey>{1}, {});
  EXPECT_NE(error_of(after, {1}).find("has the key 1"), std::string::npos);
  EXPECT_EQ(error_of(after, {3}), "");
}

TEST(ChangedPlanner, NeedsABackendThatIsOfMoreThanOneWorld) {
  const World world = random_world({.obstacles = 4, .vertices = 5, .fill = 0.2, .seed = 3});
  const Planner planner(world, Vehicle{}, backend_of(world, make_reference_queries(world)));
  EXPECT_THROW((void)planner.with_obstacles({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace arcway::internal

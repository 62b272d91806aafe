// Lazy planners on accel's backend after changes of the map, against planners built anew.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "arcway/accel/accel_backend.h"
#include "arcway/datasets/catalog.h"
#include "arcway/datasets/map_file.h"
#include "arcway/planner.h"
#include "core/roadmap/feasible_graph.h"
#include "core/roadmap/found_before.h"
#include "core/roadmap/lazy_feasible_graph.h"
#include "tests/support/known_obstacles.h"
#include "tests/support/nasty_worlds.h"
#include "tests/support/plans.h"
#include "tests/support/same_graphs.h"
#include "tests/support/same_worlds.h"
#include "tests/support/touching_worlds.h"

namespace arcway::internal {
namespace {

// Makes worlds out of others by removing some obstacles and adding others, and knows what they should be.
class ChangingMap {
 public:
  ChangingMap(const World& world, std::uint64_t seed)
      : bounds_(to_map_file(world).bounds), known_(to_map_file(world).obstacles), random_(seed) {}

  // Removes each obstacle with a probability of one in `one_in`, and adds what `draw` gives.
  Planner changed(const Planner& planner, std::int64_t one_in, const std::vector<Polygon>& added) {
    std::vector<ObstacleId> ids;
    std::vector<ObstacleKey> removed;
    for (ObstacleId o = 0; o < known_.all().size(); ++o) {
      if (random_.integer(1, one_in) != 1) continue;
      ids.push_back(o);
      removed.insert(removed.begin(), known_.all()[o].key);  // in another order than ids
    }
    known_.change(ids, added);
    Planner after = planner.with_obstacles(removed, added);
    for (ObstacleId o = 0; o < known_.all().size(); ++o) EXPECT_EQ(after.world().key_of(o), known_.all()[o].key);
    return after;
  }

  [[nodiscard]] World anew() const { return World(known_.polygons(), bounds_); }
  [[nodiscard]] std::vector<Polygon> obstacles() const { return known_.polygons(); }
  test::RandomInputs& random() { return random_; }

 private:
  std::optional<Ring> bounds_;
  test::KnownObstacles known_;
  test::RandomInputs random_;
};

template <class T>
std::string bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

void expect_same_rows(const Planner& planner, const Planner& anew) {
  for (VertexId v = 0; v < anew.world().vertices().size(); ++v)
    ASSERT_EQ(bytes_of(planner.visibility_rows()->of(v)), bytes_of(anew.visibility_rows()->of(v))) << "vertex " << v;
}

// Headings, links and verdicts of one circle in so many.
void expect_same_links(const Planner& planner, const Planner& anew, std::uint32_t one_in) {
  const FeasibleGraph &graph = planner.feasible_graph(), &expected = anew.feasible_graph();
  ASSERT_EQ(graph.circles().size(), expected.circles().size());
  for (std::uint32_t c = 0; c < graph.circles().size(); ++c) {
    ASSERT_EQ(graph.circles()[c].center, expected.circles()[c].center) << "circle " << c;
    ASSERT_EQ(graph.circles()[c].radius, expected.circles()[c].radius) << "circle " << c;
    if (c % one_in != 0) continue;
    ASSERT_EQ(bytes_of(std::span(graph.free_headings(c).intervals())),
              bytes_of(std::span(expected.free_headings(c).intervals())))
        << "circle " << c;
    ASSERT_EQ(bytes_of(graph.links_from(c)), bytes_of(expected.links_from(c))) << "circle " << c;
    for (std::size_t i = 0; i < graph.links_from(c).size(); ++i)
      ASSERT_EQ(graph.is_kept(c, i), expected.is_kept(c, i)) << "circle " << c << ", link " << i;
  }
}

TEST(ChangedPlanners, HaveTheRowsAndLinksOfNewOnesInNastyWorlds) {
  const Vehicle vehicle({.length = 0.3, .width = 0.16, .wheelbase = 0.26, .safety_margin = 0.01});
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const World world = seed % 4 == 0 ? test::touching_world(seed, 6) : test::nasty_world(seed, 14);
    ChangingMap map(world, seed);
    const PlannerOptions options{.radii = {vehicle.min_turning_radius()}};
    Planner planner(world, vehicle, accel_backend(world), options);
    for (int step = 0; step < 5; ++step) {
      SCOPED_TRACE("step " + std::to_string(step));
      // Known in part, so that some of it is taken over.
      for (std::uint32_t c = 0; c < planner.feasible_graph().circles().size(); c += 2)
        for (std::size_t i = 0; i < planner.feasible_graph().links_from(c).size(); i += 2)
          (void)planner.feasible_graph().is_kept(c, i);
      const bool adds = map.random().integer(0, 2) != 0;
      planner = map.changed(
          planner, 6, adds ? to_map_file(test::nasty_world(map.random().bits(), 2)).obstacles : std::vector<Polygon>{});
      const World after = map.anew();
      const Planner anew(after, vehicle, accel_backend(after), options);
      expect_same_rows(planner, anew);
      expect_same_links(planner, anew, 1);
      if (HasFatalFailure()) return;
    }
  }
}

// Changes use arrays again of planners that are gone, and not of those that are kept.
TEST(ChangedPlanners, LeaveOthersAsTheyAre) {
  const Vehicle vehicle({.length = 0.3, .width = 0.16, .wheelbase = 0.26, .safety_margin = 0.01});
  const PlannerOptions options{.radii = {vehicle.min_turning_radius()}};
  struct Known {
    Planner planner;
    ChangingMap map;
  };
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const World world = test::nasty_world(seed, 40);
    std::vector<Known> kept{{Planner(world, vehicle, accel_backend(world), options), ChangingMap(world, seed)}};
    for (int step = 0; step < 8; ++step) {
      const std::size_t from = step % kept.size();
      Known next = kept[from];
      const bool adds = next.map.random().integer(0, 2) != 0;
      next.planner = next.map.changed(
          next.planner, 12,
          adds ? to_map_file(test::nasty_world(next.map.random().bits(), 2)).obstacles : std::vector<Polygon>{});
      if (step % 3 == 0) {
        kept.push_back(std::move(next));
      } else {
        kept[from] = std::move(next);
      }
    }
    for (const Known& known : kept) {
      const World after = known.map.anew();
      const Planner anew(after, vehicle, accel_backend(after), options);
      expect_same_rows(known.planner, anew);
      expect_same_links(known.planner, anew, 3);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(ChangedPlanners, ThatAreEagerHaveTheGraphsOfNewOnes) {
  const World world = catalog_world("clutter/star/n40/m9/f30/s5");
  const PlannerOptions options{.graph_mode = GraphMode::kEager};
  ChangingMap map(world, 1);
  Planner planner(world, Vehicle{}, accel_backend(world), options);
  for (int step = 0; step < 4; ++step) {
    planner = map.changed(planner, 10, {map.obstacles()[static_cast<std::size_t>(step)]});
    const World after = map.anew();
    const Planner anew(after, Vehicle{}, accel_backend(after), options);
    EXPECT_EQ(planner.visibility_graph(), anew.visibility_graph());
    test::expect_same(planner.feasible_graph(), anew.feasible_graph());
  }
}

// An obstacle moves in steps, as in a replanning loop.
void expect_plans_of_new_ones(const Vehicle& vehicle, int steps) {
  const char* name = "clutter/convex/n200/m8/f25/s3";
  const World world = catalog_world(name);
  const std::vector<PlanRequest> requests = catalog_queries(name, 4, 1);
  Planner planner(world, vehicle, accel_backend(world));
  constexpr ObstacleKey kKey = 90;
  std::vector<Polygon> obstacles = to_map_file(world).obstacles;
  Polygon& moving = obstacles[kKey];
  for (int step = 0; step < steps; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    for (const PlanRequest& request : requests) (void)planner.plan(request);
    for (Vec2& p : moving.outer) p += Vec2(0.5, -0.25);
    const Planner before = planner;
    planner.change_obstacles(std::vector<ObstacleKey>{kKey}, {moving});
    EXPECT_NE(before.world().polygon_of(kKey).outer, moving.outer) << "a copy keeps the map before";
    EXPECT_EQ(planner.world().polygon_of(kKey).outer, moving.outer);
    const World after(obstacles, to_map_file(world).bounds);
    const Planner anew(after, vehicle, accel_backend(after));
    for (const PlanRequest& request : requests) test::expect_same_plan(planner.plan(request), anew.plan(request));
    expect_same_rows(planner, anew);
    expect_same_links(planner, anew, 7);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_EQ(planner.world().obstacle_with(kKey), kKey);
}

TEST(ChangedPlanners, PlanAsNewOnesWhereAnObstacleMoves) { expect_plans_of_new_ones(Vehicle{}, 12); }

TEST(ChangedPlanners, PlanAsNewOnesWithSeveralRadii) {
  expect_plans_of_new_ones(
      Vehicle({.max_speed = 2.0, .turn_speed = LateralAccelerationLimit{1.0}, .max_acceleration = 1.0}), 5);
}

// Another obstacle moves each time, so that scenes look past ever more of what they were built of.
TEST(ChangedPlanners, PlanAsNewOnesWhereOneObstacleAfterTheOtherMoves) {
  const char* name = "clutter/convex/n200/m8/f25/s3";
  const World world = catalog_world(name);
  const std::vector<PlanRequest> requests = catalog_queries(name, 4, 1);
  std::vector<Polygon> obstacles = to_map_file(world).obstacles;
  Planner planner(world, Vehicle{}, accel_backend(world));
  for (ObstacleKey key = 0; key < 80; ++key) {
    Polygon& moved = obstacles[(7 * key) % obstacles.size()];
    for (Vec2& p : moved.outer) p += key % 2 == 0 ? Vec2(0.5, -0.25) : Vec2(-2.0, 1.0);
    planner.change_obstacles(std::vector<ObstacleKey>{(7 * key) % obstacles.size()}, {moved});
    if (key % 16 != 15) continue;
    SCOPED_TRACE("step " + std::to_string(key));
    const World after(obstacles, to_map_file(world).bounds);
    const Planner anew(after, Vehicle{}, accel_backend(after));
    test::expect_same_world(planner.world(), after);
    for (const PlanRequest& request : requests) test::expect_same_plan(planner.plan(request), anew.plan(request));
    expect_same_rows(planner, anew);
    expect_same_links(planner, anew, 7);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(ChangedPlanners, KeepWhatIsFarFromTheChange) {
  const char* name = "clutter/convex/n1000/m8/f25/s3";
  const World world = catalog_world(name);
  const Planner planner(world, Vehicle{}, accel_backend(world));
  for (const PlanRequest& request : catalog_queries(name, 10, 1)) (void)planner.plan(request);
  const auto known_rows = [](const Planner& p) {
    std::size_t known = 0;
    for (std::uint32_t c = 0; c < p.feasible_graph().circles().size(); ++c)
      known += p.feasible_graph().known_row(c).has_value() ? 1 : 0;
    return known;
  };
  const auto known_headings = [](const Planner& p) {
    std::size_t known = 0;
    for (std::uint32_t c = 0; c < p.feasible_graph().circles().size(); ++c)
      known += p.feasible_graph().known_headings(c) != nullptr ? 1 : 0;
    return known;
  };
  const std::size_t before = known_rows(planner), headings_before = known_headings(planner);
  Planner after = planner.with_obstacles(std::vector<ObstacleKey>{500}, {});
  EXPECT_GT(known_rows(after), before - before / 3);
  EXPECT_LT(known_rows(after), before);
  // A chain of changes without a plan. Once all vertices may have other neighbors, no row is known any more.
  for (ObstacleKey key = 501; key < 513; ++key) {
    after = after.with_obstacles(std::vector<ObstacleKey>{key}, {});
    const auto& graph = dynamic_cast<const LazyFeasibleGraph&>(after.feasible_graph());
    ASSERT_NE(graph.found_before(), nullptr);
    EXPECT_EQ(graph.found_before()->graphs(), 1u);
  }
  EXPECT_GT(known_headings(after), headings_before / 2);
}

// What no plan asks for is known for some changes, then forgotten.
TEST(ChangedPlanners, ForgetWhatNoPlanAsksFor) {
  const char* name = "clutter/convex/n200/m8/f25/s3";
  const World world = catalog_world(name);
  const std::vector<PlanRequest> requests = catalog_queries(name, 5, 1);
  Planner planner(world, Vehicle{}, accel_backend(world));
  for (const PlanRequest& request : requests) (void)planner.plan(request);
  const auto graph = [&]() -> const LazyFeasibleGraph& {
    return dynamic_cast<const LazyFeasibleGraph&>(planner.feasible_graph());
  };
  const auto count_known = [&] {
    std::size_t count = 0;
    for (std::uint32_t c = 0; c < graph().circles().size(); ++c) count += graph().known_row(c).has_value() ? 1 : 0;
    return count;
  };
  const std::size_t all = count_known();
  const ObstacleKey key = 0;
  std::size_t most_behind = 0, after_few = 0;
  const Polygon there = to_map_file(world).obstacles[key];
  for (int step = 0; step < 40; ++step) {
    planner = planner.with_obstacles(std::vector<ObstacleKey>{key}, {there});
    (void)planner.plan(requests[0]);
    most_behind = std::max(most_behind, graph().found_before()->graphs());
    if (step == 5) after_few = count_known();
  }
  EXPECT_GT(after_few, all / 2);
  EXPECT_LT(count_known(), after_few);
  EXPECT_EQ(most_behind, 32u);
}

}  // namespace
}  // namespace arcway::internal

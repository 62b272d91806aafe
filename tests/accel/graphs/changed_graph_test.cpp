#include "accel/graphs/changed_graph.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "arcway/accel/tangent_cone_graph.h"
#include "arcway/datasets/catalog.h"
#include "arcway/datasets/map_file.h"
#include "tests/support/nasty_worlds.h"

namespace arcway::internal {
namespace {

// Removes and adds obstacles in steps, and compares every graph with one built anew.
void expect_changes(World world, test::RandomInputs& random, int steps, std::int64_t one_in, const auto& draw_added) {
  VisibilityGraph graph = build_reduced_visibility_graph_by_tangent_cones(world);
  for (int step = 0; step < steps; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    std::vector<ObstacleId> removed;
    for (ObstacleId o = 0; o < world.obstacle_count(); ++o)
      if (random.integer(1, one_in) == 1) removed.push_back(o);
    const World after = world.changed(removed, draw_added());
    graph = change_reduced_visibility_graph(graph, after, {world, after, removed}, ThreadExecutor(2));
    ASSERT_EQ(graph, build_reduced_visibility_graph_by_tangent_cones(after));
    world = after;
  }
}

TEST(ChangedGraph, IsTheOneBuiltAnewInNastyWorlds) {
  for (std::uint64_t seed = 1; seed <= 250; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::RandomInputs random(seed);
    expect_changes(test::nasty_world(seed, 12), random, 6, 4, [&] {
      return random.integer(0, 2) == 0 ? std::vector<Polygon>{}
                                       : to_map_file(test::nasty_world(random.bits(), 3)).obstacles;
    });
    if (HasFatalFailure()) return;
  }
}

TEST(ChangedGraph, IsTheOneBuiltAnewInWorldsOfTheCatalog) {
  std::uint64_t seed = 0;
  for (const char* name :
       {"clutter/convex/n60/m8/f30/s1", "clutter/star/n60/m8/f5/s2", "city/v400/s1", "rooms/v300/s2",
        "corridor/v300/s1", "islands/v500/s3", "adversarial/touching/v200/s1", "adversarial/shared/v200/s1",
        "adversarial/collinear/v200/s2", "adversarial/nested/v200/s1", "adversarial/overlapping/v200/s3",
        "adversarial/contacts/v200/s1", "adversarial/needles/v200/s1", "adversarial/holes/v200/s1"}) {
    SCOPED_TRACE(name);
    test::RandomInputs random(++seed);
    const World world = to_world(catalog_map(name), name);
    const std::vector<Polygon> obstacles = to_map_file(world).obstacles;
    expect_changes(world, random, 25, static_cast<std::int64_t>(obstacles.size()) / 2, [&] {
      std::vector<Polygon> added;
      while (random.integer(0, 2) != 0) {  // copies of others, shifted by about their size
        Polygon copy =
            obstacles[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(obstacles.size()) - 1))];
        const Vec2 shift = random.integer(0, 1) == 0 ? Vec2(0, 0) : Vec2(copy.outer[1] - copy.outer[0]);
        for (Vec2& p : copy.outer) p += shift;
        for (Ring& hole : copy.holes)
          for (Vec2& p : hole) p += shift;
        try {
          static_cast<void>(World({copy}));
          added.push_back(std::move(copy));
        } catch (const WorldError&) {
        }
      }
      return added;
    });
    if (HasFatalFailure()) return;
  }
}

TEST(ChangedGraph, RefusesTheGraphOfAnotherWorld) {
  const World world({{test::square(0, 0, 1), {}}, {test::square(3, 0, 1), {}}});
  const World after = world.changed({}, {{test::square(6, 0, 1), {}}});
  const WorldChange change(world, after, {});
  EXPECT_THROW(
      (void)change_reduced_visibility_graph(build_reduced_visibility_graph_by_tangent_cones(after), after, change),
      std::invalid_argument);
  EXPECT_THROW(
      (void)change_reduced_visibility_graph(build_reduced_visibility_graph_by_tangent_cones(world), world, change),
      std::invalid_argument);
}

TEST(ChangedGraph, WalksFewRowsForAChangeOfOneObstacle) {
  const World world = to_world(catalog_map("clutter/convex/n1000/m10/f30/s7"), "clutter");
  const VisibilityGraph graph = build_reduced_visibility_graph_by_tangent_cones(world);
  const std::vector<ObstacleId> removed = {500};
  const World after = world.changed(removed, {});
  std::size_t rows = 0;
  static_cast<void>(change_reduced_visibility_graph(graph, after, {world, after, removed}, SerialExecutor(), &rows));
  EXPECT_GT(rows, 10u);
  EXPECT_LT(rows, 1500u);  // of 8,000
  const World again = after.changed({}, {to_map_file(world).obstacles[500]});
  static_cast<void>(change_reduced_visibility_graph(build_reduced_visibility_graph_by_tangent_cones(after), again,
                                                    {after, again, {}}, SerialExecutor(), &rows));
  EXPECT_LT(rows, 1000u);
}

}  // namespace
}  // namespace arcway::internal

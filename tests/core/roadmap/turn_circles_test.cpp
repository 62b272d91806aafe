#include "core/roadmap/turn_circles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/map_file.h"
#include "arcway/planner.h"
#include "arcway/visibility_graph.h"
#include "arcway/world_change.h"
#include "core/model/vertex_map.h"
#include "tests/support/nasty_worlds.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

// A wall of a thickness, its end at y = 0, with free space around it.
World wall(double thickness) { return World({{{{0, -20}, {thickness, -20}, {thickness, 0}, {0, 0}}, {}}}); }

TurnCircles circles_of(const World& world, std::vector<double> radii) {
  const QuerySet queries = make_reference_queries(world);
  const auto rows = rows_of(world, build_reduced_visibility_graph(world, *queries.visibility));
  return {world, *rows, radii, Vehicle().footprint(1e-3), SerialExecutor()};
}

TEST(TurnCircles, GoRoundBothCornersAtTheEndOfAThinWall) {
  const World world = wall(0.5);
  const TurnCircles circles = circles_of(world, {1.3, 2.6});
  ASSERT_EQ(circles.all().size(), 4u * 4u + 2u * 2u);  // both ends of the wall
  const double inner = swept_annulus(Vehicle().footprint(1e-3), Side::kLeft, 1.3).inner;
  std::size_t at_top = 0;
  for (const TurnCircle& circle : circles.all().subspan(16)) {
    EXPECT_EQ(circle.radius, 1.3);
    for (const VertexId v : {circle.vertex, circle.second})
      EXPECT_NEAR((circle.center - world.vertex(v)).norm(), inner, 1e-12);
    EXPECT_NEAR(circle.center.x(), 0.25, 1e-12);
    if (circle.center.y() > -10.0) {
      ++at_top;
      EXPECT_LT(circle.center.y(), 0.0);
    }
  }
  EXPECT_EQ(at_top, 2u);
  for (const VertexId v : world.convex_vertices()) {
    for (const Side side : {Side::kLeft, Side::kRight}) {
      std::size_t visited = 0;
      circles.visit_around(v, side, [&](std::uint32_t c) {
        const TurnCircle& circle = circles.all()[c];
        EXPECT_EQ(circle.side, side);
        EXPECT_TRUE(circle.vertex == v || circle.second == v);
        ++visited;
      });
      EXPECT_EQ(visited, 3u);
    }
  }
}

TEST(TurnCircles, AreOfOneVertexWhereTheWallIsThick) { EXPECT_EQ(circles_of(wall(1.5), {1.3}).all().size(), 4u * 2u); }

// The vertices of a world whose rows are not those that they had before a change.
std::vector<VertexId> with_other_rows(const VisibilityRows& before, const VisibilityRows& after, const World& world,
                                      const VertexMap& change) {
  std::vector<VertexId> others;
  for (const VertexId v : world.convex_vertices()) {
    std::vector<VertexId> expected;
    if (const VertexId was = change.before(v); was != kNone)
      for (const VertexId w : before.of(was)) expected.push_back(change.after(w));
    if (expected.empty() || !std::ranges::equal(after.of(v), expected)) others.push_back(v);
  }
  return others;
}

// The circles that a search visits at a vertex, in its order.
std::vector<std::uint32_t> visited_at(const TurnCircles& circles, VertexId v) {
  std::vector<std::uint32_t> all;
  const auto note = [&all](std::uint32_t c) { all.push_back(c); };
  if (circles.has(v))
    for (const Side side : {Side::kLeft, Side::kRight}) circles.visit_around(v, side, note);
  circles.visit_by_first(v, note);
  return all;
}

void expect_equal(const TurnCircles& changed, const TurnCircles& anew, const World& world) {
  ASSERT_EQ(changed.all().size(), anew.all().size());
  for (std::size_t c = 0; c < anew.all().size(); ++c) {
    const TurnCircle &one = changed.all()[c], &other = anew.all()[c];
    ASSERT_EQ(std::tie(one.vertex, one.second, one.radius, one.side),
              std::tie(other.vertex, other.second, other.radius, other.side));
    ASSERT_EQ(one.center, other.center);
  }
  for (VertexId v = 0; v < world.vertices().size(); ++v) {
    ASSERT_EQ(changed.has(v), anew.has(v));
    ASSERT_EQ(visited_at(changed, v), visited_at(anew, v));
  }
  ASSERT_EQ(changed.used_count(), anew.used_count());
}

std::ptrdiff_t count_of_pairs(const TurnCircles& circles) {
  return std::ranges::count_if(circles.all(), [](const TurnCircle& c) { return c.second != kNone; });
}

std::shared_ptr<const VisibilityRows> reference_rows(const World& world) {
  return rows_of(world, build_reduced_visibility_graph(world, *make_reference_queries(world).visibility));
}

// A box covers the end of a thin wall, and with it the circles around both of its corners, and goes away again: a wall
// of the first world, and one that was added.
TEST(TurnCircles, AreAfterChangesThoseOfTheWorld) {
  const CircleRadii radii(std::vector<double>{1.3, 2.6});
  const Footprint body = Vehicle().footprint(1e-3);
  const Polygon second{{{10, -20}, {10.5, -20}, {10.5, 0}, {10, 0}}, {}};
  const auto box_at = [](double x) { return Polygon{{{x - 1, -2}, {x + 2, -2}, {x + 2, 3}, {x - 1, 3}}, {}}; };
  struct Step {
    std::vector<ObstacleId> removed;
    std::vector<Polygon> added;
    std::size_t pairs;
  };
  const std::vector<Step> steps{{{}, {second}, 8},    {{}, {box_at(10)}, 6},  {{2}, {}, 8},
                                {{}, {box_at(0)}, 6}, {{2}, {box_at(10)}, 6}, {{0}, {}, 2}};
  World world = wall(0.5);
  auto rows = reference_rows(world);
  std::optional<TurnCircles> circles(std::in_place, world, *rows, radii, body, SerialExecutor());
  for (const Step& step : steps) {
    const World after = world.changed(step.removed, step.added);
    const VertexMap change(WorldChange::unchecked(world, after, step.removed));
    const auto rows_after = reference_rows(after);
    TurnCircles changed(*circles, change, after, *rows_after, with_other_rows(*rows, *rows_after, after, change), radii,
                        body);
    const TurnCircles anew(after, *rows_after, radii, body, SerialExecutor());
    expect_equal(changed, anew, after);
    EXPECT_EQ(anew.used_count(), 4 * after.convex_vertices().size() + step.pairs);
    EXPECT_EQ(count_of_pairs(anew), static_cast<std::ptrdiff_t>(step.pairs));
    circles.emplace(std::move(changed));
    world = after;
    rows = rows_after;
  }
}

// Obstacles that touch, nest and overlap come, leave and cover others, each change upon the one before.
TEST(TurnCircles, AreAfterManyChangesThoseOfTheWorld) {
  const CircleRadii radii(std::vector<double>{1.3});
  const Footprint body = Vehicle().footprint(1e-3);
  std::ptrdiff_t pairs = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    test::RandomInputs random(seed);
    World world = test::nasty_world(seed, 10);
    auto rows = reference_rows(world);
    std::optional<TurnCircles> circles(std::in_place, world, *rows, radii, body, SerialExecutor());
    for (int step = 0; step < 6; ++step) {
      const std::vector<ObstacleId> removed = test::draw_obstacles(world, 8, random);
      const World after = world.changed(removed, to_map_file(test::nasty_world(random.bits(), 1)).obstacles);
      const VertexMap change(WorldChange::unchecked(world, after, removed));
      const auto rows_after = reference_rows(after);
      TurnCircles changed(*circles, change, after, *rows_after, with_other_rows(*rows, *rows_after, after, change),
                          radii, body);
      expect_equal(changed, {after, *rows_after, radii, body, SerialExecutor()}, after);
      pairs += count_of_pairs(changed);
      circles.emplace(std::move(changed));
      world = after;
      rows = rows_after;
    }
  }
  EXPECT_GT(pairs, 1000);
}

// Two corridors, joined at the open end of the wall between them.
World hairpin(double thickness, double width) {
  const double right = 2.0 * width + thickness;
  return World({{{{width, 0}, {width + thickness, 0}, {width + thickness, 20}, {width, 20}}, {}}},
               Ring{{0, 0}, {right, 0}, {right, 20.0 + 1.5 * width}, {0, 20.0 + 1.5 * width}});
}

TEST(TurnCircles, LeadRoundWallsOfAnyThickness) {
  for (const double thickness : {0.01, 0.1, 0.5, 0.9, 1.2, 1.3, 2.0})
    for (const double width : {2.3, 3.5}) {
      SCOPED_TRACE(testing::Message() << "thickness " << thickness << ", width " << width);
      const World world = hairpin(thickness, width);
      const PlanRequest there{{0.5 * width, 2.0, kPi / 2}, {1.5 * width + thickness, 2.0, -kPi / 2}};
      const PlanRequest back{{1.5 * width + thickness, 2.0, kPi / 2}, {0.5 * width, 2.0, -kPi / 2}};
      const Planner eager(world, Vehicle());
      const Planner lazy(world, Vehicle(), {.graph_mode = GraphMode::kLazy});
      for (const PlanRequest& request : {there, back}) {
        const PlanResult result = eager.plan(request);
        EXPECT_TRUE(result.solved()) << result.reason;
        test::expect_valid(eager, result);
        EXPECT_EQ(lazy.plan(request).travel_time, result.travel_time);
      }
    }
}

}  // namespace
}  // namespace arcway::internal

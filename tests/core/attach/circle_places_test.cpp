#include "core/attach/circle_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "arcway/backend.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/map_file.h"
#include "arcway/planner.h"
#include "arcway/world_change.h"
#include "core/gaps/gap_circles.h"
#include "core/model/vertex_map.h"
#include "core/roadmap/feasible_graph.h"
#include "core/roadmap/feasible_graph_inputs.h"
#include "core/roadmap/lazy_feasible_graph.h"
#include "tests/support/nasty_worlds.h"

namespace arcway::internal {
namespace {

// Holes and bounds have pieces of their own; walls hardly longer than a turn have circles round two vertices.
World world_with_holes() {
  std::vector<Polygon> obstacles =
      generate_clutter({.obstacles = 20, .vertices = 30, .fill = 0.3, .seed = 3}).obstacles;
  obstacles.push_back({{{200, 0}, {230, 0}, {230, 30}, {200, 30}}, {{{202, 2}, {202, 28}, {228, 28}, {228, 2}}}});
  obstacles.push_back({{{100, -20}, {101, -20}, {101, -19.9}, {100, -19.9}}, {}});
  return World(std::move(obstacles));
}

TEST(CirclePlaces, HoldEachCircleOnce) {
  const World world = world_with_holes();
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{2.0}});
  const Planner planner(world, vehicle, {.graph_mode = GraphMode::kLazy});
  const TurnCircles& base = planner.feasible_graph().turn_circles();
  const auto outlines = std::make_shared<const Outlines>(world);
  AddedCircles added;
  for (const VertexId v : world.convex_vertices())
    added.around_vertices.push_back(turn_circle(world, v, 20.0, Side::kLeft, vehicle.footprint()));
  const TurnCircle of_gap_straight = added.around_vertices[0];
  added.gap_straights.push_back({{of_gap_straight}, {of_gap_straight}});
  for (const TurnCircles& circles : {base, TurnCircles(base, added)}) {
    const CirclePlaces places(circles, outlines);
    std::vector<std::uint32_t> found;
    places.visit_near_first(
        Vec2(0, 0), [](const Box&) { return true; },
        [&](const Outlines::Piece& piece, std::uint32_t index) {
          EXPECT_EQ(piece.first, (*outlines)[index].first);
          const CirclePlaces::Circles here = places.of(index);
          for (const CirclePlaces::Group& group : here.groups) {
            double least = 1e9, most = 0.0;
            for (const std::uint32_t c : here.of(group)) {
              const TurnCircle& circle = circles.all()[c];
              found.push_back(c);
              EXPECT_GE(circle.vertex, piece.first);
              EXPECT_LT(circle.vertex, piece.first + piece.edge_count());
              EXPECT_TRUE(group.box.contains(circle.center - Vec2(circle.radius, circle.radius)));
              EXPECT_TRUE(group.box.contains(circle.center + Vec2(circle.radius, circle.radius)));
              least = std::min(least, circle.radius);
              most = std::max(most, circle.radius);
            }
            EXPECT_LT(most, 2.0 * least);
          }
        });
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found.size(), circles.all().size());
    for (std::uint32_t c = 0; c < found.size(); ++c) ASSERT_EQ(found[c], c);
  }
  EXPECT_GT(base.all().size(),
            2 * planner.options().radii.size() * world.convex_vertices().size());  // round two as well
}

TEST(CirclePlaces, EndOnceTheClockIsOver) {
  const World world = world_with_holes();
  const Planner planner(world, Vehicle(), {.graph_mode = GraphMode::kLazy});
  const TurnCircles& circles = planner.feasible_graph().turn_circles();
  const auto outlines = std::make_shared<const Outlines>(world);
  EXPECT_THROW(CirclePlaces(circles, outlines, StopClock(0.0)), Canceled);
}

TEST(CirclePlaces, LieWithTheirPieces) {
  const World world = world_with_holes();
  const Planner planner(world, Vehicle(), {.graph_mode = GraphMode::kLazy});
  const TurnCircles& circles = planner.feasible_graph().turn_circles();
  const CirclePlaces places(circles, std::make_shared<const Outlines>(world));
  for (const Box& query : {Box{{10, 10}, {30, 20}}, Box{{215, 3}, {216, 4}}, Box{{90, -25}, {110, -15}}}) {
    std::vector<VertexId> seen;
    places.visit_near_first(
        Vec2(20, 20), [&](const Box& box) { return box.overlaps(query); },
        [&](const Outlines::Piece& piece, std::uint32_t) {
          for (std::size_t k = 0; k < piece.edge_count(); ++k) seen.push_back(static_cast<VertexId>(piece.first + k));
        });
    for (const TurnCircle& c : circles.all()) {
      const Vec2 half(c.radius, c.radius);
      if (!query.overlaps(Box{c.center - half, c.center + half}) && !query.contains(world.vertex(c.vertex))) continue;
      EXPECT_NE(std::ranges::find(seen, c.vertex), seen.end());
    }
    EXPECT_LT(seen.size(), world.vertices().size());
  }
}

// A lazy graph of a world, and what it is made of.
struct Circles {
  explicit Circles(const World& w)
      : world(w),
        vehicle({.length = 0.3, .width = 0.16, .wheelbase = 0.26, .safety_margin = 0.01}),
        rows(rows_of(world, *reference_backend(world).reduced_graph())),
        graph(std::make_shared<const LazyFeasibleGraph>(
            FeasibleGraphInputs{world, vehicle, rows, make_reference_queries(world), {vehicle, {0.3, 0.9}}},
            SerialExecutor())) {}

  World world;
  Vehicle vehicle;
  std::shared_ptr<const VisibilityRows> rows;
  std::shared_ptr<const FeasibleGraph> graph;
};

// Vertices with other neighbors than before a change, or new ones: they may have been there, inside an obstacle.
std::vector<VertexId> differing(const Circles& before, const Circles& after, const VertexMap& map) {
  std::vector<VertexId> differ;
  for (const VertexId v : after.world.convex_vertices()) {
    const VertexId was = map.before(v);
    if (was == kNone || !std::ranges::binary_search(before.world.convex_vertices(), was) ||
        !std::ranges::equal(before.rows->of(was), after.rows->of(v), {}, [&](VertexId w) { return map.after(w); }))
      differ.push_back(v);
  }
  return differ;
}

// Each circle that is used is found once, by any box that it meets.
void expect_right(const CirclePlaces& places, const TurnCircles& circles) {
  for (const TurnCircle& of_query : circles.all()) {
    const double to_side = of_query.vertex % 2 == 0 ? of_query.radius : -of_query.radius;
    const Vec2 corner = of_query.center + Vec2(to_side, of_query.side == Side::kLeft ? to_side : -to_side);
    const Box query{corner, corner};
    std::vector<std::uint32_t> found;
    places.visit_near_first(
        query.min, [&](const Box& box) { return box.overlaps(query); },
        [&](const Outlines::Piece& piece, std::uint32_t index) {
          EXPECT_EQ(piece.first, places.outlines()[index].first);
          const CirclePlaces::Circles here = places.of(index);
          for (const CirclePlaces::Group& group : here.groups)
            for (const std::uint32_t c : here.of(group)) {
              found.push_back(c);
              EXPECT_TRUE(piece.first <= circles.all()[c].vertex &&
                          circles.all()[c].vertex < piece.first + piece.edge_count());
            }
        });
    std::ranges::sort(found);
    EXPECT_EQ(std::ranges::adjacent_find(found), found.end());
    for (std::uint32_t c = 0; c < circles.all().size(); ++c) {
      if (!circles.is_used(c)) continue;
      const Vec2 half(circles.all()[c].radius, circles.all()[c].radius);
      if (!Box{circles.all()[c].center - half, circles.all()[c].center + half}.overlaps(query)) continue;
      ASSERT_TRUE(std::ranges::binary_search(found, c)) << c;
    }
  }
}

TEST(CirclePlaces, AfterChangesHoldTheCirclesOfNewOnes) {
  std::size_t changes = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    test::RandomInputs random(seed);
    Circles before(test::nasty_world(seed, 50));
    auto outlines = std::make_shared<const Outlines>(before.world);
    CirclePlaces places(before.graph->turn_circles(), outlines);
    for (int step = 0; step < 3; ++step) {
      std::vector<ObstacleId> removed;
      for (ObstacleId o = 0; o < before.world.obstacle_count(); ++o)
        if (random.integer(0, 40) == 0) removed.push_back(o);
      const Circles after(before.world.changed(removed, to_map_file(test::nasty_world(random.bits(), 2)).obstacles));
      const VertexMap map(WorldChange(before.world, after.world, removed));
      if (!outlines->can_change(map)) break;
      outlines = std::make_shared<const Outlines>(*outlines, after.world, map);
      places = CirclePlaces(places, after.graph, outlines, differing(before, after, map));
      expect_right(places, after.graph->turn_circles());
      expect_right(CirclePlaces(after.graph->turn_circles(), outlines), after.graph->turn_circles());
      if (HasFatalFailure()) return;
      before = after;
      ++changes;
    }
  }
  EXPECT_GT(changes, 20u);
}

}  // namespace
}  // namespace arcway::internal

#include "core/attach/circle_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "arcway/datasets/clutter.h"
#include "arcway/planner.h"
#include "core/gaps/gap_circles.h"
#include "core/roadmap/feasible_graph.h"

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
          for (const CirclePlaces::Group& group : places.groups(index)) {
            double least = 1e9, most = 0.0;
            for (const std::uint32_t c : places.circles(group)) {
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

}  // namespace
}  // namespace arcway::internal

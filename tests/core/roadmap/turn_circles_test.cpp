#include "core/roadmap/turn_circles.h"

#include <gtest/gtest.h>

#include <vector>

#include "arcway/angle.h"
#include "arcway/planner.h"
#include "arcway/visibility_graph.h"
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

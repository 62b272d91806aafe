#include "core/validate/edge_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/geometry/predicates.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

bool meets(const LineSegment& edge, const Box& box) {
  if (box.contains(edge.a) || box.contains(edge.b)) return true;
  const Vec2 right_low(box.max.x(), box.min.y()), left_high(box.min.x(), box.max.y());
  for (const LineSegment& side :
       {LineSegment{box.min, right_low}, {right_low, box.max}, {box.max, left_high}, {left_high, box.min}})
    if (relate(edge, side) != SegmentRelation::kDisjoint) return true;
  return false;
}

// Once each, and none that meets the box is missing.
void expect_all_that_meet(const EdgeGrid& grid, const Box& asked) {
  std::vector<VertexId> visited;
  grid.visit_near(asked, [&](VertexId e) { visited.push_back(e); });
  std::sort(visited.begin(), visited.end());
  EXPECT_TRUE(std::adjacent_find(visited.begin(), visited.end()) == visited.end());
  for (VertexId e = 0; e < grid.edges().size(); ++e) {
    if (!box_of(grid.edges()[e]).overlaps(asked) || !meets(grid.edges()[e], asked)) continue;
    ASSERT_TRUE(std::binary_search(visited.begin(), visited.end(), e)) << "edge " << e;
  }
}

std::vector<LineSegment> random_edges(test::RandomInputs& random, std::size_t count, double width, double height) {
  std::vector<LineSegment> edges(count);
  for (LineSegment& edge : edges) {
    edge.a = Vec2(random.uniform(0.0, width), random.uniform(0.0, height));
    const double length = random.integer(0, 9) == 0 ? 1.0 : 0.01;  // some cross the map
    edge.b = edge.a + Vec2(random.uniform(0.0, length * width), random.uniform(0.0, length * height));
  }
  return edges;
}

TEST(EdgeGrid, VisitsEachEdgeThatMeetsABoxOnce) {
  test::RandomInputs random(1);
  struct Size {
    double width, height;
  };
  for (const auto& [width, height] : {Size{100, 100}, {1e6, 1}, {1, 1e-9}, {0, 50}, {50, 0}, {0, 0}})
    for (const std::size_t count : {1u, 2u, 30u, 2000u}) {
      const std::vector<LineSegment> edges = random_edges(random, count, width, height);
      const EdgeGrid grid(edges);
      for (int i = 0; i < 100; ++i) {
        const Vec2 corner(random.uniform(-0.5, 1.5) * width, random.uniform(-0.5, 1.5) * height);
        const double part = i % 2 == 0 ? 0.02 : 0.5;
        const Vec2 size(random.uniform(0.0, part) * width, random.uniform(0.0, part) * height);
        expect_all_that_meet(grid, {corner, corner + size});
        expect_all_that_meet(grid, box_of(edges[static_cast<std::size_t>(random.bits() % count)]));
      }
      constexpr double kUnbounded = std::numeric_limits<double>::infinity();
      expect_all_that_meet(grid, Box{edges[0].a, edges[0].a}.grown(kUnbounded));
      expect_all_that_meet(grid, Box{edges[0].a, edges[0].a}.grown(1e300));
    }
}

TEST(EdgeGrid, VisitsLittleBesideThat) {
  test::RandomInputs random(2);
  std::vector<LineSegment> edges(100'000);
  for (LineSegment& edge : edges) {
    edge.a = random.point(0.0, 1000.0);
    edge.b = edge.a + random.point(-1.0, 1.0);
  }
  const EdgeGrid grid(edges);
  std::size_t visited = 0;
  for (int i = 0; i < 100; ++i) {
    const Vec2 corner = random.point(0.0, 990.0);
    grid.visit_near({corner, corner + Vec2(10.0, 10.0)}, [&](VertexId) { ++visited; });
  }
  EXPECT_GT(visited, 500u);    // a thousandth of the map at a time
  EXPECT_LT(visited, 10000u);  // which has ten edges a time
}

// Slanted walls side by side, all of whose boxes overlap.
TEST(EdgeGrid, VisitsFewOfManyLongEdges) {
  for (const double slope : {1.0, -0.3}) {
    std::vector<LineSegment> edges;
    for (int i = 0; i < 400; ++i)
      for (int piece = 0; piece < 20; ++piece) {
        const Vec2 start(i + 10.0 * piece, slope * 10.0 * piece);
        edges.push_back({start, start + 10.0 * Vec2(1.0, slope)});
      }
    const EdgeGrid grid(edges);
    for (int i = 10; i < 390; i += 10) {
      std::size_t visited = 0;
      const Vec2 corner(i + 100.0, slope * 100.0);
      grid.visit_near({corner, corner + Vec2(2.0, 2.0)}, [&](VertexId) { ++visited; });
      EXPECT_GE(visited, 2u);
      EXPECT_LE(visited, 100u);
    }
  }
}

TEST(EdgeGrid, HasNothingWithoutEdges) {
  const EdgeGrid grid({});
  grid.visit_near({{-1, -1}, {1, 1}}, [](VertexId e) { ADD_FAILURE() << e; });
  EXPECT_TRUE(grid.box().empty());
}

}  // namespace
}  // namespace arcway::internal

#include "core/gaps/gap_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>
#include <vector>

#include "arcway/datasets/clutter.h"
#include "arcway/query_set.h"
#include "core/base/infinity.h"
#include "core/geometry/distance.h"
#include "core/geometry/predicates.h"
#include "tests/support/boxes.h"
#include "tests/support/nasty_worlds.h"

namespace arcway::internal {
namespace {

using test::box;

double clearance(const World& world, const Vec2& p) {
  double least = kInfinity;
  for (const LineSegment& edge : world.edges()) least = std::min(least, distance(p, edge));
  return least;
}

// The widest route along the points of a grid, by the least clearance at its points. With steps to four neighbors it is
// at most h / 2 above that of some path. With steps to eight it is at most h / sqrt(2) below that of the best path.
class Grid {
 public:
  Grid(const World& world, const Box& area, int cells) : area_(area), cells_(cells) {
    for (int i = 0; i < cells * cells; ++i) clearances_.push_back(internal::clearance(world, center(i)));
  }

  [[nodiscard]] double cell() const { return (area_.max.x() - area_.min.x()) / cells_; }
  [[nodiscard]] Vec2 center(int i) const {
    return area_.min + cell() * Vec2(0.5 + static_cast<double>(i % cells_), 0.5 + static_cast<double>(i / cells_));
  }
  [[nodiscard]] double clearance(int i) const { return clearances_[static_cast<std::size_t>(i)]; }

  [[nodiscard]] std::vector<double> widest_from(int start, int neighbors) const {
    std::vector<double> widest(clearances_.size(), -1.0);
    std::priority_queue<std::pair<double, int>> open;
    open.emplace(clearance(start), start);
    while (!open.empty()) {
      const auto [width, at] = open.top();
      open.pop();
      if (widest[static_cast<std::size_t>(at)] >= 0.0) continue;
      widest[static_cast<std::size_t>(at)] = width;
      for (int n = 0; n < neighbors; ++n) {
        static constexpr int kX[] = {1, -1, 0, 0, 1, 1, -1, -1}, kY[] = {0, 0, 1, -1, 1, -1, 1, -1};
        const int x = at % cells_ + kX[n], y = at / cells_ + kY[n];
        if (x < 0 || y < 0 || x >= cells_ || y >= cells_) continue;
        const int to = y * cells_ + x;
        open.emplace(std::min(width, clearance(to)), to);
      }
    }
    return widest;
  }

 private:
  Box area_;
  int cells_;
  std::vector<double> clearances_;
};

// All pairs, as the definition says: the least width whose grown edges part the points, by flooding of nothing but
// links between edges. Independent of trees, circles and forests.
double bottleneck_by_all_pairs(const World& world, const Vec2& from, const Vec2& to) {
  const auto edges = world.edges();
  const auto n = static_cast<std::uint32_t>(edges.size());
  const auto crosses = [](const Vec2& p, const Vec2& a, const Vec2& b) {
    if ((a.y() <= p.y()) == (b.y() <= p.y())) return false;
    return a.y() <= p.y() ? orientation(a, b, p) > 0 : orientation(b, a, p) > 0;
  };
  struct Link {
    std::uint32_t a, b;
    double width;
    bool odd;
  };
  std::vector<Link> links;
  std::vector<double> widths{0.0};
  for (std::uint32_t a = 0; a < n; ++a)
    for (std::uint32_t b = a + 1; b < n; ++b) {
      const LineSegment& s = edges[a];
      const LineSegment& t = edges[b];
      const double width = distance(s, t);
      // The nearest points; where edges cross, that point.
      Vec2 p = s.a, q = closest_point(s.a, t);
      const auto take = [&](const Vec2& u, const Vec2& v) {
        if ((u - v).norm() < (p - q).norm()) p = u, q = v;
      };
      take(s.b, closest_point(s.b, t));
      take(closest_point(t.a, s), t.a);
      take(closest_point(t.b, s), t.b);
      if (relate(s, t) == SegmentRelation::kCrossing) {
        const Vec2 u = s.b - s.a, v = t.b - t.a;
        p = q = s.a + cross(t.a - s.a, v) / cross(u, v) * u;
      }
      bool odd = false;
      for (const Vec2& end : {from, to})
        for (const auto& [c, d] : {std::pair(s.a, p), std::pair(p, q), std::pair(q, t.a)})
          odd = odd != crosses(end, c, d);
      links.push_back({a, b, width, odd});
      widths.push_back(width);
    }
  std::sort(widths.begin(), widths.end());
  const auto parted = [&](double width) {
    std::vector<std::vector<std::pair<std::uint32_t, bool>>> joined(n);
    for (const Link& link : links)
      if (link.width <= width) {
        joined[link.a].emplace_back(link.b, link.odd);
        joined[link.b].emplace_back(link.a, link.odd);
      }
    std::vector<int> colors(n, -1);
    for (std::uint32_t root = 0; root < n; ++root) {
      if (colors[root] >= 0) continue;
      std::vector<std::uint32_t> stack{root};
      colors[root] = 0;
      while (!stack.empty()) {
        const std::uint32_t at = stack.back();
        stack.pop_back();
        for (const auto& [to_edge, odd] : joined[at]) {
          const int color = odd ? 1 - colors[at] : colors[at];
          if (colors[to_edge] < 0) {
            colors[to_edge] = color;
            stack.push_back(to_edge);
          } else if (colors[to_edge] != color) {
            return true;
          }
        }
      }
    }
    return false;
  };
  const auto first = std::partition_point(widths.begin(), widths.end(), [&](double w) { return !parted(w); });
  return first == widths.end() ? kInfinity : *first;
}

TEST(GapMap, ADoorInAWall) {
  const World world({box(5, 0, 6, 4), box(5, 4.5, 6, 10)}, box(0, 0, 10, 10).outer);
  const GapMap map(world, 2.0);
  const auto gap = map.bottleneck({2, 5}, {8, 5});
  ASSERT_TRUE(gap);
  EXPECT_DOUBLE_EQ(gap->width, 0.5);
  EXPECT_EQ(world.obstacle_of(gap->edge_a), 0u);
  EXPECT_EQ(world.obstacle_of(gap->edge_b), 1u);
  EXPECT_EQ(gap->on_a.y(), 4.0);
  EXPECT_EQ(gap->on_b.y(), 4.5);
  EXPECT_FALSE(map.bottleneck({2, 5}, {2, 8}));
  EXPECT_FALSE(map.bottleneck({2, 5}, {2, 5}));
}

TEST(GapMap, TheWiderOfTwoDoorsCounts) {
  const World world({box(5, 0, 6, 2), box(5, 2.4, 6, 7), box(5, 7.7, 6, 10)}, box(0, 0, 10, 10).outer);
  EXPECT_DOUBLE_EQ(GapMap(world, 2.0).bottleneck({2, 5}, {8, 5})->width, 7.7 - 7.0);
  EXPECT_FALSE(GapMap(world, 0.5).bottleneck({2, 5}, {8, 5}));
}

TEST(GapMap, TheNarrowerOfTwoWallsCounts) {
  const World world({box(3, 0, 4, 4), box(3, 4.6, 4, 10), box(6, 0, 7, 8), box(6, 8.5, 7, 10)},
                    box(0, 0, 10, 10).outer);
  EXPECT_DOUBLE_EQ(GapMap(world, 2.0).bottleneck({2, 5}, {9, 5})->width, 0.5);
  EXPECT_DOUBLE_EQ(GapMap(world, 2.0).bottleneck({2, 5}, {5, 5})->width, 4.6 - 4.0);
}

TEST(GapMap, BothGapsBesideAnIslandAreToTheBounds) {
  const World world({box(4, 0.3, 6, 9.2)}, box(0, 0, 10, 10).outer);
  const auto gap = GapMap(world, 2.0).bottleneck({2, 5}, {8, 5});
  ASSERT_TRUE(gap);
  EXPECT_DOUBLE_EQ(gap->width, 10.0 - 9.2);
  EXPECT_EQ(world.obstacle_of(gap->edge_b), 1u);  // the bounds
}

TEST(GapMap, TheMouthOfOneObstacle) {
  // A ring with a slit: both sides belong to one obstacle.
  const Ring pan{{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 3.4}, {1, 3.4}, {1, 5}, {5, 5}, {5, 1}, {1, 1}, {1, 3}, {0, 3}};
  const World world({{pan, {}}});
  const auto gap = GapMap(world, 2.0).bottleneck({3, 3}, {-3, 3});
  ASSERT_TRUE(gap);
  EXPECT_NEAR(gap->width, 0.4, 1e-15);
  EXPECT_EQ(world.obstacle_of(gap->edge_a), world.obstacle_of(gap->edge_b));
  EXPECT_FALSE(GapMap(world, 2.0).bottleneck({3, 3}, {2, 2}));
}

TEST(GapMap, HolesAndTouchingObstaclesLeaveNoWay) {
  const World hole({{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{2, 2}, {2, 7}, {7, 7}, {7, 2}}}}});
  const GapMap in_hole(hole, 1.0);
  ASSERT_TRUE(in_hole.bottleneck({4, 4}, {20, 4}));
  EXPECT_EQ(in_hole.bottleneck({4, 4}, {20, 4})->width, 0.0);
  EXPECT_FALSE(in_hole.bottleneck({4, 4}, {5, 5}));
  EXPECT_FALSE(in_hole.bottleneck({-4, 4}, {20, 4}));

  // Four boxes that only touch at corners, or overlap.
  for (const double overlap : {0.0, 0.5}) {
    const World ring(
        {box(0, 0, 6 + overlap, 1), box(6, 1 - overlap, 7, 7), box(1, 7, 6 + overlap, 8), box(0, 1 - overlap, 1, 7)});
    const auto gap = GapMap(ring, 1.0).bottleneck({3, 4}, {20, 4});
    ASSERT_TRUE(gap);
    EXPECT_EQ(gap->width, 0.0);
    EXPECT_EQ(gap->on_a, gap->on_b);
  }
}

TEST(GapMap, RoomAtTheEndsIsNoBottleneck) {
  // A lane of one width: it is as wide as the room around what stands in it.
  const World world({box(0, 1, 20, 2), box(0, -2, 20, -1)});
  const GapMap map(world, 5.0);
  EXPECT_FALSE(map.bottleneck({5, 0}, {15, 0}));
  EXPECT_FALSE(map.bottleneck({5, 0}, {40, 0}));
}

TEST(GapMap, EmptyWorldsHaveNone) {
  EXPECT_FALSE(GapMap(World({}), 1.0).bottleneck({0, 0}, {5, 5}));
  EXPECT_TRUE(GapMap(World({}), 1.0).gaps().empty());
}

TEST(GapMap, EqualsAllPairs) {
  int narrow = 0, none = 0, closed = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE(seed);
    const bool nasty = seed % 2 == 0;
    const World world =
        nasty ? test::nasty_world(seed, 9) : random_world({.obstacles = 12, .vertices = 5, .fill = 0.4, .seed = seed});
    if (world.edges().empty()) continue;
    const double size = (world.box().max - world.box().min).maxCoeff();
    const double widest = 0.15 * size;
    const GapMap map(world, widest);
    test::RandomInputs random(seed);
    const auto regions = make_reference_queries(world);
    std::vector<Vec2> points;
    for (int i = 0; i < 40 && points.size() < 6; ++i) {
      const double x = random.unit();  // one after the other: compilers differ in the order of arguments
      const double y = random.unit();
      const Vec2 p = world.box().min + Vec2(x, y).cwiseProduct(world.box().max - world.box().min);
      if (regions.distance->containing(p) == kNone && clearance(world, p) > 0.0) points.push_back(p);
    }
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double room = 2.0 * std::min(clearance(world, points[i]), clearance(world, points[i + 1]));
      const double expected = bottleneck_by_all_pairs(world, points[i], points[i + 1]);
      const auto gap = map.bottleneck(points[i], points[i + 1]);
      const bool counts = expected == 0.0 || (expected <= widest && expected < room);
      // Where two widths differ by rounding alone either may come first.
      ASSERT_EQ(gap.has_value(), counts) << expected << " of " << widest << ", room " << room;
      if (gap) {
        EXPECT_NEAR(gap->width, expected, 1e-9 * size);
        EXPECT_NEAR((gap->on_a - gap->on_b).norm(), gap->width, 1e-9 * size);
      }
      narrow += gap && gap->width > 0.0 ? 1 : 0;
      closed += gap && gap->width == 0.0 ? 1 : 0;
      none += gap ? 0 : 1;
    }
  }
  EXPECT_GT(narrow, 30);
  EXPECT_GT(closed, 3);
  EXPECT_GT(none, 30);
}

TEST(GapMap, LiesBetweenTheWidestWaysOfGrids) {
  constexpr int kCells = 160;
  int checked = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const World world = random_world({.obstacles = 10, .vertices = 7, .fill = 0.45, .seed = seed});
    const double size = (world.box().max - world.box().min).maxCoeff();
    const GapMap map(world, size);
    Box area;  // the way round all obstacles as well
    area.extend(world.box().min - Vec2::Constant(0.3 * size));
    area.extend(area.min + Vec2::Constant(1.6 * size));
    const Grid grid(world, area, kCells);
    const auto regions = make_reference_queries(world);
    std::vector<int> cells;
    test::RandomInputs random(seed);
    while (cells.size() < 8) {  // each with more room than most, so that what lies between is narrower
      int best = -1;
      for (int trial = 0; trial < 60; ++trial) {
        const auto i = static_cast<int>(random.integer(0, kCells * kCells - 1));
        const bool free = regions.distance->containing(grid.center(i)) == kNone && world.box().contains(grid.center(i));
        if (free && (best < 0 || grid.clearance(i) > grid.clearance(best))) best = i;
      }
      if (best >= 0) cells.push_back(best);
    }
    for (const int from : cells) {
      const auto low = grid.widest_from(from, 4), high = grid.widest_from(from, 8);
      for (const int to : cells) {
        if (from == to) continue;
        const double room = 2.0 * std::min(grid.clearance(from), grid.clearance(to));
        const auto gap = map.bottleneck(grid.center(from), grid.center(to));
        const double width = gap ? std::min(gap->width, room) : room;
        const auto at = static_cast<std::size_t>(to);
        EXPECT_GE(width, 2.0 * low[at] - grid.cell());
        EXPECT_LE(width, 2.0 * high[at] + std::sqrt(2.0) * grid.cell());
        checked += gap ? 1 : 0;
      }
    }
  }
  EXPECT_GT(checked, 100);
}

}  // namespace
}  // namespace arcway::internal

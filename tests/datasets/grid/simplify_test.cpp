#include "datasets/grid/simplify.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "arcway/polygon.h"
#include "arcway/world.h"
#include "tests/support/random_grids.h"

namespace arcway::internal {
namespace {

using test::grid_of;

std::int64_t cross_of(const Corner& a, const Corner& b, std::int64_t x, std::int64_t y, std::int64_t scale) {
  return (std::int64_t{b.x} - a.x) * (y - scale * a.y) - (std::int64_t{b.y} - a.y) * (x - scale * a.x);
}

// Whether a ring's edge passes through the open cell.
bool edge_enters(const Corner& a, const Corner& b, std::int64_t x, std::int64_t y) {
  if (std::max(a.x, b.x) <= x || std::min(a.x, b.x) >= x + 1 || std::max(a.y, b.y) <= y || std::min(a.y, b.y) >= y + 1)
    return false;
  bool left = false, right = false;
  for (const std::int64_t dx : {0, 1}) {
    for (const std::int64_t dy : {0, 1}) {
      const std::int64_t side = cross_of(a, b, x + dx, y + dy, 1);
      left = left || side > 0;
      right = right || side < 0;
    }
  }
  return left && right;
}

// Whether the cell's middle is inside, by counting crossings to the right in doubled coordinates. Exact.
bool holds_middle(const CornerPolygon& polygon, std::int64_t x, std::int64_t y) {
  bool inside = false;
  for (const CornerRing& ring : polygon) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Corner a = ring[i], b = ring[(i + 1) % ring.size()];
      if (a.y > b.y) std::swap(a, b);
      const std::int64_t py = 2 * y + 1;
      if (2 * a.y < py && py < 2 * b.y && cross_of(a, b, 2 * x + 1, py, 2) > 0) inside = !inside;
    }
  }
  return inside;
}

// Exact: no edge comes into the cell, and the middle is inside.
bool covers(const CornerPolygon& polygon, std::int64_t x, std::int64_t y) {
  for (const CornerRing& ring : polygon)
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (edge_enters(ring[i], ring[(i + 1) % ring.size()], x, y)) return false;
  return holds_middle(polygon, x, y);
}

TEST(Simplify, StairsBecomeALine) {
  const OccupancyGrid stairs = grid_of({"....#", "...##", "..###", ".####", "#####"});
  auto polygons = trace_blocked(stairs, false);
  simplify(polygons, 0.5);
  EXPECT_EQ(corner_count(polygons), 12u) << "the inner corners are 0.71 cells from the line";
  simplify(polygons, 0.75);
  ASSERT_EQ(corner_count(polygons), 5u);
  EXPECT_EQ(polygons[0][0], (CornerRing{{0, 0}, {5, 0}, {5, 5}, {4, 5}, {0, 1}}));
}

TEST(Simplify, BumpsStay) {
  auto polygons = trace_blocked(grid_of({".......", "...#...", "#######"}), false);
  simplify(polygons, 0.9);
  EXPECT_EQ(corner_count(polygons), 8u) << "without the bump's corners its cell would be uncovered";
}

TEST(Simplify, NothingIsUncoveredAndWorldsStayValid) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const OccupancyGrid grid = test::random_grid(seed);
    const auto traced = trace_blocked(grid, false);
    for (const double tolerance : {0.4, 0.8, 1.5, 4.0}) {
      auto polygons = traced;
      simplify(polygons, tolerance);
      ASSERT_EQ(polygons.size(), traced.size());
      EXPECT_LE(corner_count(polygons), corner_count(traced));
      for (std::size_t y = 0; y < grid.height; ++y) {
        for (std::size_t x = 0; x < grid.width; ++x) {
          if (grid.at(x, y) == Cell::kFree) continue;
          const auto cell = [&](const CornerPolygon& p) {
            return covers(p, static_cast<std::int64_t>(x), static_cast<std::int64_t>(y));
          };
          ASSERT_TRUE(std::any_of(polygons.begin(), polygons.end(), cell))
              << "seed " << seed << ", tolerance " << tolerance << ", cell " << x << ' ' << y;
        }
      }
      std::vector<Polygon> obstacles;
      for (const CornerPolygon& polygon : polygons) {
        Polygon& obstacle = obstacles.emplace_back();
        for (std::size_t k = 0; k < polygon.size(); ++k) {
          Ring& ring = k == 0 ? obstacle.outer : obstacle.holes.emplace_back();
          for (const Corner& corner : polygon[k]) ring.emplace_back(corner.x, corner.y);
        }
        EXPECT_GT(winding(obstacle.outer), 0);
      }
      EXPECT_NO_THROW(World(std::move(obstacles))) << "seed " << seed << ", tolerance " << tolerance;
    }
  }
}

TEST(Simplify, CornersStayWithinTheTolerance) {
  const auto distance = [](const Corner& p, const Corner& a, const Corner& b) {
    const Vec2 ab(b.x - a.x, b.y - a.y), ap(p.x - a.x, p.y - a.y);
    return (ap - std::clamp(ap.dot(ab) / ab.squaredNorm(), 0.0, 1.0) * ab).norm();
  };
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const auto traced = trace_blocked(test::random_grid(seed), false);
    auto polygons = traced;
    simplify(polygons, 1.2);
    for (std::size_t i = 0; i < traced.size(); ++i) {
      for (std::size_t k = 0; k < traced[i].size(); ++k) {
        const CornerRing& ring = polygons[i][k];
        for (const Corner& corner : traced[i][k]) {
          double nearest = 1e9;
          for (std::size_t e = 0; e < ring.size(); ++e)
            nearest = std::min(nearest, distance(corner, ring[e], ring[(e + 1) % ring.size()]));
          EXPECT_LE(nearest, 1.2) << "seed " << seed;
        }
      }
    }
  }
}

TEST(Simplify, ObstaclesDoNotOverlap) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const OccupancyGrid grid = test::random_grid(seed);
    auto polygons = trace_blocked(grid, false);
    simplify(polygons, 3.0);
    for (int y = 0; y < static_cast<int>(grid.height); ++y) {
      for (int x = 0; x < static_cast<int>(grid.width); ++x) {
        const auto holds = [&](const CornerPolygon& p) { return holds_middle(p, x, y); };
        EXPECT_LE(std::count_if(polygons.begin(), polygons.end(), holds), 1) << "seed " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace arcway::internal

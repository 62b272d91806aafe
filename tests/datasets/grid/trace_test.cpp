#include "datasets/grid/trace.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

#include "arcway/world.h"
#include "datasets/grid/grid_map.h"
#include "tests/support/random_grids.h"

namespace arcway::internal {
namespace {

using test::grid_of;

TEST(Trace, AWallIsFourCorners) {
  const auto polygons = trace_blocked(grid_of({"....", ".##.", "...."}), false);
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_EQ(polygons[0], (CornerPolygon{{{1, 1}, {3, 1}, {3, 2}, {1, 2}}}));
}

TEST(Trace, CellsThatTouchAtACornerAreOneObstacle) {
  const auto polygons = trace_blocked(grid_of({".#", "#."}), false);
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_EQ(polygons[0], (CornerPolygon{{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}}));
}

TEST(Trace, PocketsAreHoles) {
  const auto polygons = trace_blocked(grid_of({".#.", "#.#", ".#."}), false);
  ASSERT_EQ(polygons.size(), 1u);
  ASSERT_EQ(polygons[0].size(), 2u);
  EXPECT_EQ(polygons[0][1], (CornerRing{{2, 1}, {1, 1}, {1, 2}, {2, 2}}));
}

TEST(Trace, UnknownCellsAreBlockedUnlessTheyAreFree) {
  EXPECT_EQ(trace_blocked(grid_of({"?.#"}), false).size(), 2u);
  EXPECT_EQ(trace_blocked(grid_of({"?.#"}), true).size(), 1u);
}

// The number of obstacles by flooding from cell to cell.
std::size_t components(const OccupancyGrid& grid) {
  std::vector<bool> seen(grid.cells.size(), false);
  std::size_t count = 0;
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (seen[i] || grid.cells[i] == Cell::kFree) continue;
    ++count;
    std::vector<std::size_t> open{i};
    seen[i] = true;
    while (!open.empty()) {
      const std::size_t k = open.back();
      open.pop_back();
      const auto x = static_cast<std::ptrdiff_t>(k % grid.width), y = static_cast<std::ptrdiff_t>(k / grid.width);
      for (std::ptrdiff_t ny = y - 1; ny <= y + 1; ++ny) {
        for (std::ptrdiff_t nx = x - 1; nx <= x + 1; ++nx) {
          if (nx < 0 || ny < 0 || nx >= std::ssize(grid.cells) / std::ptrdiff_t(grid.height) ||
              ny >= static_cast<std::ptrdiff_t>(grid.height))
            continue;
          const auto n = static_cast<std::size_t>(ny) * grid.width + static_cast<std::size_t>(nx);
          if (seen[n] || grid.cells[n] == Cell::kFree) continue;
          seen[n] = true;
          open.push_back(n);
        }
      }
    }
  }
  return count;
}

TEST(Trace, RingsAreTheBordersOfTheCells) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const OccupancyGrid grid = test::random_grid(seed);
    const auto polygons = trace_blocked(grid, false);
    EXPECT_EQ(polygons.size(), components(grid)) << "seed " << seed;
    // Every unit of a border once, blocked on the left and free on the right.
    std::set<std::pair<std::pair<int, int>, std::pair<int, int>>> traced;
    for (const CornerPolygon& polygon : polygons) {
      for (const CornerRing& ring : polygon) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const Corner a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
          ASSERT_TRUE((a.x == b.x) != (a.y == b.y)) << "seed " << seed;
          ASSERT_TRUE((a.x == b.x) != (b.x == c.x)) << "collinear, seed " << seed;
          const int dx = (b.x > a.x) - (b.x < a.x), dy = (b.y > a.y) - (b.y < a.y);
          for (Corner p = a; !(p == b); p = {p.x + dx, p.y + dy})
            ASSERT_TRUE(traced.insert({{p.x, p.y}, {dx, dy}}).second) << "seed " << seed;
        }
      }
    }
    const auto blocked = [&](int x, int y) {
      return x >= 0 && y >= 0 && x < static_cast<int>(grid.width) && y < static_cast<int>(grid.height) &&
             grid.at(static_cast<std::size_t>(x), static_cast<std::size_t>(y)) != Cell::kFree;
    };
    std::size_t borders = 0;
    for (int y = -1; y <= static_cast<int>(grid.height); ++y) {
      for (int x = -1; x <= static_cast<int>(grid.width); ++x) {
        if (!blocked(x, y)) continue;
        const auto expect = [&](int nx, int ny, std::pair<int, int> from, std::pair<int, int> direction) {
          if (blocked(nx, ny)) return;
          ++borders;
          EXPECT_TRUE(traced.contains({from, direction})) << "seed " << seed;
        };
        expect(x, y - 1, {x, y}, {1, 0});
        expect(x + 1, y, {x + 1, y}, {0, 1});
        expect(x, y + 1, {x + 1, y + 1}, {-1, 0});
        expect(x - 1, y, {x, y + 1}, {0, -1});
      }
    }
    EXPECT_EQ(traced.size(), borders) << "seed " << seed;
  }
}

TEST(Trace, EveryTracedGridIsAWorld) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const OccupancyGrid grid = test::random_grid(seed);
    EXPECT_NO_THROW(to_world(to_map_file(grid), "grid")) << "seed " << seed;
  }
}

}  // namespace
}  // namespace arcway::internal

#include "core/model/world_coverage.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/geometry/predicates.h"
#include "tests/support/nasty_worlds.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

Coverage swept(const World& world) {
  std::vector<ObstacleId> region_of;
  for (VertexId v = 0; v < world.vertices().size(); ++v) region_of.push_back(world.obstacle_of(v));
  return sweep_coverage(world.edges(), region_of,
                        world.has_bounds() ? static_cast<ObstacleId>(world.obstacle_count()) : kNone);
}

bool is_in_one_of(const World& world, VertexId v, const auto& takes) {
  for (ObstacleId o = 0; o < world.region_count(); ++o)
    if (takes(o) && world.locate(world.vertex(v), o) == PointLocation::kInside) return true;
  return false;
}

bool crosses_others(const World& world, ObstacleId o) {
  const auto [first, last] = world.vertices_of(o);
  for (VertexId e = first; e < last; ++e)
    for (VertexId f = 0; f < world.edges().size(); ++f)
      if (world.obstacle_of(f) != o && relate(world.edges()[e], world.edges()[f]) == SegmentRelation::kCrossing)
        return true;
  return false;
}

TEST(Coverage, IsWhatEveryRegionSays) {
  std::size_t covered = 0, free = 0, crossing = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    const World world = test::nasty_world(seed, 14);
    const Coverage coverage = swept(world);
    ASSERT_TRUE(std::is_sorted(coverage.left_over.begin(), coverage.left_over.end()));
    for (const ObstacleId o : coverage.left_over) ASSERT_TRUE(crosses_others(world, o)) << "seed " << seed;
    const auto is_taken = [&](ObstacleId o) {
      return !std::binary_search(coverage.left_over.begin(), coverage.left_over.end(), o);
    };
    for (VertexId v = 0; v < world.vertices().size(); ++v) {
      ASSERT_EQ(coverage.covered[v], is_in_one_of(world, v, is_taken)) << "seed " << seed << " vertex " << v;
      ++(coverage.covered[v] ? covered : free);
    }
    for (ObstacleId o = 0; o < world.region_count(); ++o) crossing += crosses_others(world, o) ? 1 : 0;
  }
  EXPECT_GT(covered, 5000u);
  EXPECT_GT(free, 5000u);
  EXPECT_GT(crossing, 500u);
}

// Frames in frames, each of which crosses the next one, so that no box tells them apart.
TEST(Coverage, LeavesNothingOverWhereEachRingCrossesFewOthers) {
  std::vector<Polygon> obstacles;
  for (int k = 1; k <= 200; ++k) {
    const double r = 4.0 * k;
    obstacles.push_back({{{-r, -r}, {r, -r}, {r, 0.1 * r}, {r + 3.0, 0.1 * r + 0.1}, {r, 0.2 * r}, {r, r}, {-r, r}},
                         {test::square(-r + 2.0, -r + 2.0, 2.0 * r - 4.0)}});
  }
  const World world(obstacles);
  const Coverage coverage = swept(world);
  EXPECT_TRUE(coverage.left_over.empty());
  std::size_t covered = 0;
  for (VertexId v = 0; v < world.vertices().size(); ++v) {
    ASSERT_EQ(coverage.covered[v], is_in_one_of(world, v, [](ObstacleId) { return true; })) << "vertex " << v;
    covered += coverage.covered[v] ? 1 : 0;
  }
  EXPECT_GE(covered, 199u);
}

// Boxes of which each crosses all others.
TEST(Coverage, LeavesOverWhatCrossesMany) {
  std::vector<Polygon> obstacles;
  for (int k = 0; k < 12; ++k) {
    const double w = 1.0 + k, h = 12.0 - k;
    obstacles.push_back({{{-w, -h}, {w, -h}, {w, h}, {-w, h}}, {}});
  }
  const Coverage coverage = swept(World(obstacles));
  EXPECT_FALSE(coverage.left_over.empty());
  EXPECT_LT(coverage.left_over.size(), 12u);
}

// Rings in rings, so many that the world is swept: full ones and ones with holes, and some that cross.
TEST(Coverage, IsThatOfTheWorldWhereBoxesNest) {
  for (const bool is_turned : {false, true}) {
    std::vector<Polygon> obstacles;
    const Vec2 u = direction_of(is_turned ? 0.6 : 0.0), center(1e4, -3.0);
    const auto ring = [&](double r) {
      return Ring{center + r * u, center + r * perpendicular(u), center - r * u, center - r * perpendicular(u)};
    };
    const int count = 600;
    for (int k = 1; k <= count; ++k) {
      obstacles.push_back({ring(3.0 * k + 1), {ring(3.0 * k)}});
      if (k % 100 == 0) obstacles.push_back({test::square(center.x() + 2.5 * k, center.y() - 3, 4.0), {}});
    }
    obstacles.push_back({ring(20.5), {}});
    const World world(obstacles);
    for (VertexId v = 0; v < world.vertices().size(); v += 3)
      ASSERT_EQ(world.is_covered(v), is_in_one_of(world, v, [](ObstacleId) { return true; })) << "vertex " << v;
  }
}

}  // namespace
}  // namespace arcway::internal

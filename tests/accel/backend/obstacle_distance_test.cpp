#include "arcway/accel/obstacle_distance.h"

#include <gtest/gtest.h>

#include <tuple>

#include "arcway/accel/parallel.h"
#include "arcway/datasets/clutter.h"
#include "core/geometry/distance.h"
#include "tests/support/troublesome_queries.h"

namespace arcway::internal {
namespace {

ObstacleDistance try_all(const World& world, std::span<const ObstacleId> a, std::span<const ObstacleId> b) {
  ObstacleDistance best;
  const auto edges_of = [&](std::span<const ObstacleId> set) {
    std::vector<VertexId> edges;
    for (const ObstacleId o : set)
      for (VertexId e = world.vertices_of(o).first; e < world.vertices_of(o).last; ++e) edges.push_back(e);
    return edges;
  };
  for (const VertexId s : edges_of(a))
    for (const VertexId t : edges_of(b)) {
      const double d = distance(world.edges()[s], world.edges()[t]);
      if (std::tie(d, s, t) < std::tie(best.distance, best.edge_a, best.edge_b)) best = {d, s, t};
    }
  return best;
}

void expect_equal(const ObstacleDistance& found, const ObstacleDistance& expected) {
  EXPECT_EQ(found.distance, expected.distance);
  EXPECT_EQ(found.edge_a, expected.edge_a);
  EXPECT_EQ(found.edge_b, expected.edge_b);
}

TEST(ObstacleDistances, AreThoseOfTryingAllPairsOfEdges) {
  constexpr struct {
    double size, offset;  // [m]; the last as far out as doubles tell the cells apart
  } kPlaces[] = {{64.0, 0.0}, {64.0, 0x1p14}, {0x1p-10, 0.0}, {0x1p-10, 0x1p14}, {0x1p7, 0x1p53}};
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto& place = kPlaces[seed % std::size(kPlaces)];
    test::TroublesomeQueries questions(seed, place.size, place.offset);
    const World& world = questions.world();
    const ObstacleDistances distances(world);
    const auto last = static_cast<ObstacleId>(world.region_count() - 1);
    std::vector<ObstaclePair> pairs;
    for (ObstacleId a = 0; a <= last; ++a) pairs.push_back({a, last - a});
    std::vector<ObstacleDistance> found(pairs.size());
    distances.between(pairs, found, TbbExecutor(2));
    for (std::size_t i = 0; i < pairs.size(); ++i)
      expect_equal(found[i], try_all(world, {&pairs[i].a, 1}, {&pairs[i].b, 1}));

    std::vector<ObstacleId> left;
    std::vector<ObstacleId> right;
    for (ObstacleId o = 0; o <= last; ++o) (questions.random().integer(0, 1) == 0 ? left : right).push_back(o);
    expect_equal(distances.between(left, right), try_all(world, left, right));
    expect_equal(distances.between(left, right, TbbExecutor(2)), try_all(world, left, right));
  }
}

TEST(ObstacleDistances, AreThoseOfDisjointClutterFarFromTheOrigin) {
  const Clutter clutter = generate_clutter({.obstacles = 40, .vertices = 8, .fill = 0.2, .seed = 4});
  std::vector<Polygon> obstacles = clutter.obstacles;
  for (Polygon& obstacle : obstacles)
    for (Vec2& p : obstacle.outer) p += Vec2(5e6, -3e6);
  const World world(std::move(obstacles));
  const ObstacleDistances distances(world);
  for (ObstacleId a = 0; a < 40; ++a) {
    const ObstacleId b = (a * 7 + 3) % 40;
    if (a == b) continue;
    const ObstacleDistance expected = try_all(world, {&a, 1}, {&b, 1});
    expect_equal(distances.between({&a, 1}, {&b, 1}), expected);
    EXPECT_GT(expected.distance, 0.0);
  }
}

TEST(ObstacleDistances, OfNoObstaclesAreInfiniteAndOfStrangersRefused) {
  const World world({{test::square(0, 0, 1), {}}, {test::square(5, 0, 1), {}}});
  const ObstacleDistances distances(world);
  const ObstacleId zero = 0;
  const ObstacleId two = 2;
  EXPECT_EQ(distances.between({&zero, 1}, {}).edge_a, kNone);
  EXPECT_THROW((void)distances.between({&zero, 1}, {&two, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace arcway::internal

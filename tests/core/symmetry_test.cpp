// What a map's place, its handedness and the order of its file do not change.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/map_file.h"
#include "arcway/planner.h"
#include "tests/support/nasty_worlds.h"
#include "tests/support/plans.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

// An exact motion of the plane, perhaps with a reflection before.
struct Motion {
  const char* name;
  Vec2 (*move)(const Vec2&);
  double (*turn)(double heading);
  [[nodiscard]] Pose operator()(const Pose& pose) const {
    const Vec2 p = move(pose.position());
    return {p.x(), p.y(), turn(pose.heading)};
  }
};
constexpr std::array kMirroredMotions{
    Motion{"quarter turn", [](const Vec2& p) { return Vec2(-p.y(), p.x()); }, [](double h) { return h + 0.5 * kPi; }},
    Motion{"mirror", [](const Vec2& p) { return Vec2(p.x(), -p.y()); }, [](double h) { return -h; }},
    Motion{"shift", [](const Vec2& p) { return Vec2(p.x() + 1024.0, p.y() - 512.0); }, [](double h) { return h; }}};

// On a grid, so that shifts are exact.
MapFile rounded(MapFile map) {
  const auto round = [](Ring& ring) {
    for (Vec2& p : ring) p = 0x1p-16 * (0x1p16 * p).array().round();
  };
  for (Polygon& polygon : map.obstacles) {
    round(polygon.outer);
    std::ranges::for_each(polygon.holes, round);
  }
  if (map.bounds) round(*map.bounds);
  return map;
}

MapFile moved(MapFile map, const Motion& motion) {
  const auto move = [&](Ring& ring) { std::ranges::transform(ring, ring.begin(), motion.move); };
  for (Polygon& polygon : map.obstacles) {
    move(polygon.outer);
    std::ranges::for_each(polygon.holes, move);
  }
  if (map.bounds) move(*map.bounds);
  return map;
}

// Obstacles in another order, rings from another vertex on and some of them the other way round.
MapFile shuffled(MapFile map, test::RandomInputs& random) {
  const auto shuffle = [&](Ring& ring) {
    std::rotate(ring.begin(), ring.begin() + random.integer(0, static_cast<std::int64_t>(ring.size()) - 1), ring.end());
    if (random.integer(0, 1) == 0) std::ranges::reverse(ring);
  };
  for (Polygon& polygon : map.obstacles) {
    shuffle(polygon.outer);
    std::ranges::for_each(polygon.holes, shuffle);
  }
  for (std::size_t i = map.obstacles.size(); i > 1; --i)
    std::swap(map.obstacles[i - 1],
              map.obstacles[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(i) - 1))]);
  if (map.bounds) shuffle(*map.bounds);
  return map;
}

// The reduced graph as places, whatever the vertices' numbers.
std::vector<std::array<double, 4>> edges_of(const World& world, const std::function<Vec2(const Vec2&)>& move) {
  const VisibilityGraph graph = build_reduced_visibility_graph(world, *make_reference_queries(world).visibility);
  std::vector<std::array<double, 4>> edges;
  for (VertexId u = 0; u < graph.vertex_count(); ++u)
    for (const VertexId v : graph.row(u)) {
      std::array a{move(world.vertex(u)), move(world.vertex(v))};
      if (std::pair(a[1].x(), a[1].y()) < std::pair(a[0].x(), a[0].y())) std::swap(a[0], a[1]);
      edges.push_back({a[0].x(), a[0].y(), a[1].x(), a[1].y()});
    }
  std::ranges::sort(edges);
  return edges;
}

std::vector<MapFile> maps() {
  std::vector<MapFile> maps;
  for (const ClutterKind kind : {ClutterKind::kConvex, ClutterKind::kStar, ClutterKind::kMixed})
    maps.push_back(
        rounded(to_map_file(random_world({.kind = kind, .obstacles = 20, .vertices = 6, .fill = 0.2, .seed = 5}))));
  for (std::uint64_t seed = 1; seed <= 40; ++seed) maps.push_back(rounded(to_map_file(test::nasty_world(seed, 10))));
  std::erase_if(maps, [](const MapFile& map) {  // rounding may have made rings cross
    try {
      (void)to_world(map, "map");
      return false;
    } catch (const FormatError&) {
      return true;
    }
  });
  EXPECT_GT(maps.size(), 25u);
  return maps;
}

TEST(Symmetry, ReducedGraphsAreThoseOfTheMovedMap) {
  const auto same = [](const Vec2& p) { return p; };
  test::RandomInputs random(1);
  std::size_t edges = 0;
  for (const MapFile& map : maps()) {
    const World world = to_world(map, "map");
    for (const Motion& motion : kMirroredMotions) {
      SCOPED_TRACE(motion.name);
      EXPECT_EQ(edges_of(to_world(moved(map, motion), "moved"), same), edges_of(world, motion.move));
    }
    const auto expected = edges_of(world, same);
    EXPECT_EQ(edges_of(to_world(shuffled(map, random), "shuffled"), same), expected);
    edges += expected.size();
  }
  EXPECT_GT(edges, 1000u);
}

// Nothing but the graph's fastest path: what is tried beside it goes by grids.
TEST(Symmetry, PlansTakeAsLongOnTheMovedMap) {
  const PlannerOptions options{.maneuver_poses = 0, .gap_circles = false, .refinement = {.max_trials = 0}};
  VehicleParameters gentle;
  gentle.turn_speed = LateralAccelerationLimit{2.0};
  gentle.max_acceleration = 2.0;
  test::RandomInputs random(2);
  int solved = 0;
  for (const Vehicle& vehicle : {Vehicle(), Vehicle(gentle)})
    for (const ClutterKind kind : {ClutterKind::kConvex, ClutterKind::kStar}) {
      const MapFile map =
          rounded(to_map_file(random_world({.kind = kind, .obstacles = 25, .vertices = 6, .fill = 0.15, .seed = 3})));
      const World world = to_world(map, "map");
      const Planner planner(world, vehicle, options);
      std::vector<std::pair<Motion, Planner>> others;
      for (const Motion& motion : kMirroredMotions)
        others.emplace_back(motion, Planner(to_world(moved(map, motion), "moved"), vehicle, options));
      others.emplace_back(Motion{"shuffle", [](const Vec2& p) { return p; }, [](double h) { return h; }},
                          Planner(to_world(shuffled(map, random), "shuffled"), vehicle, options));
      const Vec2 size = world.box().max - world.box().min;
      for (int i = 0; i < 12; ++i) {
        const auto pose = [&] {
          const Vec2 p = world.box().min + Vec2(random.uniform(0.0, 1.0), random.uniform(0.0, 1.0)).cwiseProduct(size);
          const Vec2 on_grid = 0x1p-16 * (0x1p16 * p).array().round();
          return Pose{on_grid.x(), on_grid.y(), random.uniform(-kPi, kPi)};
        };
        const PlanRequest request{pose(), pose()};
        const PlanResult expected = planner.plan(request);
        solved += expected.solved();
        for (const auto& [motion, other] : others) {
          SCOPED_TRACE(motion.name);
          const PlanResult result = other.plan({motion(request.start), motion(request.goal)});
          ASSERT_EQ(result.status, expected.status);
          EXPECT_NEAR(result.travel_time, expected.travel_time, 1e-9 * (1.0 + expected.travel_time));
          EXPECT_NEAR(result.lower_bound, expected.lower_bound, 1e-9 * (1.0 + expected.lower_bound));
          if (result.solved()) test::expect_valid(other, result);
        }
      }
    }
  EXPECT_GT(solved, 20);
}

}  // namespace
}  // namespace arcway::internal

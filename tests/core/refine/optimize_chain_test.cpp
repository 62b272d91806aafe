#include "core/refine/optimize_chain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <stop_token>
#include <tuple>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/planner.h"
#include "core/collision/motion_free.h"
#include "core/motion/gear_words.h"
#include "core/motion/speed_profile.h"
#include "tests/support/free_plans.h"
#include "tests/support/gear_paths.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

constexpr ChainEffort kUsualEffort{.parts = 3, .least_turn = 0.05, .iterations = 40, .first_barrier = 1e-3};

Vehicle optimized_vehicle() { return Vehicle({.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0}); }

// A world, with all that an optimization asks for.
struct OptimizedWorld {
  explicit OptimizedWorld(World of) : world(std::move(of)), outlines(world), queries(make_reference_queries(world)) {}

  World world;
  Outlines outlines;
  QuerySet queries;
};

Clutter optimized_clutter(ClutterKind kind, std::uint64_t seed) {
  return generate_clutter({.kind = kind, .obstacles = 40, .vertices = 8, .fill = 0.25, .seed = seed});
}

// The free chains that a planner finds.
std::vector<CircleChain> free_chains(const World& world, std::size_t count, std::uint64_t seed,
                                     const Vehicle& vehicle = optimized_vehicle()) {
  const Planner planner(world, vehicle, {.radii = {}, .refinement = {.max_trials = 0}});
  test::RandomInputs random(seed);
  std::vector<CircleChain> chains;
  while (chains.size() < count) {
    const auto [request, path] = test::next_free_plan(planner, random);
    if (const auto chain = chain_of(path, request.start, request.goal); chain && lines_of(*chain))
      chains.push_back(*chain);
  }
  return chains;
}

struct OptimizedPath {
  ChainOptimizer::Result result{};
  Path path;  ///< empty if the circles have no bitangents
  double time = 0.0;
  bool is_free = false;
};

OptimizedPath optimized_path(ChainOptimizer& optimizer, const OptimizedWorld& in, const CircleChain& chain,
                             const ChainEffort& effort = kUsualEffort, const StopClock& clock = {},
                             const Vehicle& vehicle = optimized_vehicle(), const ClearanceCost* clearance = nullptr) {
  const auto lines = lines_of(chain).value();
  CircleChain optimized;
  OptimizedPath now;
  now.result =
      optimizer.optimize(chain, lines, {vehicle, in.world, in.outlines, effort, clock, {}, clearance}, optimized);
  const auto joints = now.result.is_optimized ? lines_of(optimized) : std::nullopt;
  if (!joints) return now;
  for (const TurnCircle& circle : optimized.circles) EXPECT_GE(circle.radius, vehicle.min_turning_radius());
  now.path = path_of(optimized, *joints);
  now.time = speed_profile(now.path, vehicle).total_time;
  now.is_free = motion_free(*in.queries.sweep, vehicle.body(0.5 * vehicle.safety_margin()), now.path);
  const Pose start = now.path.front().start, end = now.path.back().end();
  EXPECT_NEAR((start.position() - chain.start.position()).norm(), 0.0, 1e-9);
  EXPECT_NEAR((end.position() - chain.goal.position()).norm(), 0.0, 1e-6);
  EXPECT_NEAR(wrap_signed(start.heading - chain.start.heading), 0.0, 1e-9);
  EXPECT_NEAR(wrap_signed(end.heading - chain.goal.heading), 0.0, 1e-9);
  return now;
}

double time_before(const CircleChain& chain, const Vehicle& vehicle = optimized_vehicle()) {
  return speed_profile(path_of(chain, lines_of(chain).value()), vehicle).total_time;
}

TEST(OptimizeChain, ServesChainsOfVehiclesThatAreFasterOnWiderArcs) {
  const auto serves = [](VehicleParameters parameters) {
    return ChainOptimizer::serves_chains(Vehicle(std::move(parameters)));
  };
  const LateralAccelerationLimit lateral{2.0};
  EXPECT_FALSE(serves({}));
  EXPECT_FALSE(serves({.turn_speed = ConstantTurnSpeed{1.0}}));
  EXPECT_TRUE(serves({.turn_speed = TurnSpeedTable{{{1.0, 1.0}, {9.0, 3.0}}}}));  // never as fast as on lines
  EXPECT_FALSE(serves({.turn_speed = TurnSpeedTable{{{9.0, 3.0}}}}));
  EXPECT_FALSE(serves({.turn_speed = TurnSpeedTable{{{0.5, 1.0}, {1.2, 3.0}}}}));  // no faster on wider arcs
  EXPECT_TRUE(serves({.max_speed = 3.0, .turn_speed = TurnSpeedTable{{{1.0, 1.0}, {9.0, 3.0}}}}));
  EXPECT_TRUE(serves({.turn_speed = lateral}));
  EXPECT_TRUE(serves({.steering = Steering::kRear, .turn_speed = lateral}));
  EXPECT_TRUE(serves({.steering = Steering::kSymmetric, .max_steering_angle = 0.5, .turn_speed = lateral}));
  // The tightest circle, of radius 1.3 m, is driven at the top speed of 1.6 m/s, or just not.
  EXPECT_FALSE(serves({.max_speed = 1.6, .turn_speed = lateral}));
  EXPECT_TRUE(serves({.max_speed = 1.63, .turn_speed = lateral}));
}

// Chains of a vehicle with as large a margin keep the distance.
TEST(OptimizeChain, KeepsThePreferredDistanceWhereAChainKeepsIt) {
  constexpr double kDistance = 0.3;
  const OptimizedWorld in(
      random_world({.kind = ClutterKind::kConvex, .obstacles = 25, .vertices = 6, .fill = 0.12, .seed = 5}));
  const Vehicle vehicle = optimized_vehicle();
  const ClearanceCost clearance(vehicle, std::make_shared<const Outlines>(in.world), {.distance = kDistance});
  VehicleParameters wide = vehicle.parameters();
  wide.safety_margin = 2.0 * (kDistance + vehicle.safety_margin());
  ChainOptimizer optimizer;
  int kept = 0, given_up = 0, faster = 0;
  for (const CircleChain& chain : free_chains(in.world, 15, 2, Vehicle(wide))) {
    ASSERT_EQ(clearance.of(path_of(chain, lines_of(chain).value())), 0.0);
    const OptimizedPath near = optimized_path(optimizer, in, chain);
    const OptimizedPath far = optimized_path(optimizer, in, chain, kUsualEffort, {}, vehicle, &clearance);
    if (!near.is_free || !far.is_free) continue;
    kept += clearance.of(far.path) == 0.0 ? 1 : 0;
    given_up += clearance.of(near.path) > 0.0 ? 1 : 0;
    faster += far.time < time_before(chain) ? 1 : 0;
  }
  EXPECT_GE(kept, 11);
  EXPECT_GE(given_up, 6);
  EXPECT_GE(faster, 11);
}

class OptimizeChainInClutter : public testing::TestWithParam<ClutterKind> {};

TEST_P(OptimizeChainInClutter, MostResultsAreFreeAndFasterAndTheSameEveryTime) {
  const Clutter clutter = optimized_clutter(GetParam(), 3);
  const OptimizedWorld in(World(clutter.obstacles, clutter.bounds));
  const std::vector<CircleChain> chains = free_chains(in.world, 25, 1);
  ChainOptimizer optimizer, again;
  int free = 0, faster = 0;
  double share = 0.0;
  for (const CircleChain& chain : chains) {
    const OptimizedPath result = optimized_path(optimizer, in, chain);
    EXPECT_LE(result.result.iterations, kUsualEffort.iterations);
    ASSERT_TRUE(result.result.is_optimized);
    const OptimizedPath same = optimized_path(again, in, chain);
    EXPECT_EQ(same.time, result.time);
    EXPECT_EQ(same.result.iterations, result.result.iterations);
    if (result.path.empty()) continue;
    free += result.is_free;
    faster += result.is_free && result.time < time_before(chain);
    if (result.is_free) share += 1.0 - result.time / time_before(chain);
  }
  EXPECT_GE(free, 20);
  EXPECT_GE(faster, 20);
  EXPECT_GT(share / free, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Clutters, OptimizeChainInClutter, testing::Values(ClutterKind::kConvex, ClutterKind::kStar));

// Bodies that cover the center of the tightest turn, or do not cover the reference point.
TEST(OptimizeChain, MostResultsOfUnusualBodiesAreFreeAndFaster) {
  const Clutter clutter =
      generate_clutter({.kind = ClutterKind::kStar, .obstacles = 30, .vertices = 8, .fill = 0.12, .seed = 5});
  const OptimizedWorld in(World(clutter.obstacles, clutter.bounds));
  const auto with = [](auto set) {
    VehicleParameters parameters{.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0};
    set(parameters);
    return Vehicle(parameters);
  };
  const std::vector<Vehicle> vehicles{with([](VehicleParameters& p) { p.width = 3.0; }), with([](VehicleParameters& p) {
                                        p.footprint = {{{1.0, -0.4}, {2.0, -0.4}, {2.0, 0.4}, {1.0, 0.4}}};
                                      }),
                                      with([](VehicleParameters& p) {
                                        p.footprint = {{{-2.0, -0.4}, {-0.8, -0.4}, {-0.8, 0.4}, {-2.0, 0.4}}};
                                      }),
                                      with([](VehicleParameters& p) {
                                        p.footprint = {{{-0.5, 0.6}, {0.7, 0.6}, {0.7, 1.2}, {-0.5, 1.2}}};
                                      })};
  ChainOptimizer optimizer;
  for (std::size_t v = 0; v < vehicles.size(); ++v) {
    const Vehicle& vehicle = vehicles[v];
    ASSERT_TRUE(ChainOptimizer::serves_chains(vehicle));
    int faster = 0;
    double share = 0.0;
    for (const CircleChain& chain : free_chains(in.world, 8, 1 + v, vehicle)) {
      const OptimizedPath result = optimized_path(optimizer, in, chain, kUsualEffort, {}, vehicle);
      const double before = time_before(chain, vehicle);
      if (result.path.empty() || !result.is_free || !(result.time < before)) continue;
      ++faster;
      share += 1.0 - result.time / before;
    }
    EXPECT_GE(faster, 4) << "vehicle " << v;
    EXPECT_GT(share / faster, 0.03) << "vehicle " << v;
  }
}

Ring mirrored_ring(const Ring& ring) {
  Ring result;
  for (const Vec2& point : ring) result.emplace_back(point.x(), -point.y());
  return test::reversed(result);
}

Pose mirrored_pose(const Pose& pose) { return {pose.x, -pose.y, -pose.heading}; }

CircleChain mirrored_chain(CircleChain chain) {
  chain.start = mirrored_pose(chain.start);
  chain.goal = mirrored_pose(chain.goal);
  for (TurnCircle& circle : chain.circles) {
    circle.center.y() = -circle.center.y();
    circle.side = opposite(circle.side);
  }
  return chain;
}

TEST(OptimizeChain, IsTheSameInAMirror) {
  const Clutter clutter = optimized_clutter(ClutterKind::kConvex, 4);
  std::vector<Polygon> obstacles;
  for (const Polygon& obstacle : clutter.obstacles) obstacles.push_back({mirrored_ring(obstacle.outer), {}});
  const OptimizedWorld in(World(clutter.obstacles, clutter.bounds)),
      mirror(World(obstacles, mirrored_ring(clutter.bounds)));
  ChainOptimizer optimizer;
  for (const CircleChain& chain : free_chains(in.world, 20, 2)) {
    const OptimizedPath result = optimized_path(optimizer, in, chain);
    const OptimizedPath other = optimized_path(optimizer, mirror, mirrored_chain(chain));
    EXPECT_NEAR(other.time, result.time, 1e-6 * result.time);
    EXPECT_EQ(other.is_free, result.is_free);
  }
}

TEST(OptimizeChain, EndsWhenTheClockIsOver) {
  const Clutter clutter = optimized_clutter(ClutterKind::kConvex, 3);
  const OptimizedWorld in(World(clutter.obstacles, clutter.bounds));
  ChainOptimizer optimizer;
  for (const CircleChain& chain : free_chains(in.world, 5, 3)) {
    const OptimizedPath result = optimized_path(optimizer, in, chain, kUsualEffort, StopClock(0.0));
    EXPECT_FALSE(result.result.is_optimized);
    EXPECT_EQ(result.result.iterations, 0);
    std::stop_source source;
    source.request_stop();
    EXPECT_EQ(optimized_path(optimizer, in, chain, kUsualEffort, StopClock(1e9, source.get_token())).result.iterations,
              0);
  }
}

TEST(OptimizeChain, KeepsToItsIterations) {
  const Clutter clutter = optimized_clutter(ClutterKind::kConvex, 3);
  const OptimizedWorld in(World(clutter.obstacles, clutter.bounds));
  ChainOptimizer optimizer;
  for (const CircleChain& chain : free_chains(in.world, 5, 3)) {
    double slowest = 0.0;
    for (const int iterations : {0, 1, 5, 40}) {
      ChainEffort effort = kUsualEffort;
      effort.iterations = iterations;
      const OptimizedPath result = optimized_path(optimizer, in, chain, effort);
      EXPECT_TRUE(result.result.is_optimized);
      EXPECT_LE(result.result.iterations, iterations);
      if (iterations <= 5) {
        EXPECT_EQ(result.result.iterations, iterations);
      }
      if (iterations == 0) slowest = result.time;
      EXPECT_LE(result.time, slowest * 1.01);
    }
  }
}

// In the open, where nothing is in the way, turns become spirals: tight where the vehicle is slow.
TEST(OptimizeChain, TurnsAreWiderWhereTheVehicleIsFaster) {
  const OptimizedWorld in{World({})};
  Path path{{{0, 0, 0}, 2.0, 0.0}};
  for (const auto& [length, curvature] : {std::pair{3.0, 0.5}, {30.0, 0.0}, {3.0, -0.5}, {2.0, 0.0}})
    path.push_back({path.back().end(), length, curvature});
  const CircleChain chain = chain_of(path, path.front().start, path.back().end()).value();
  ChainOptimizer optimizer;
  const OptimizedPath result = optimized_path(optimizer, in, chain);
  ASSERT_TRUE(result.is_free);
  EXPECT_LT(result.time, 0.97 * time_before(chain));
  std::vector<double> radii;
  for (const PathSegment& segment : result.path)
    if (!segment.is_line()) radii.push_back(1.0 / std::abs(segment.curvature));
  ASSERT_EQ(radii.size(), 6u);
  for (const std::size_t i : {0u, 1u}) EXPECT_LT(1.2 * radii[i], radii[i + 1]);
  for (const std::size_t i : {3u, 4u}) EXPECT_GT(radii[i], 1.2 * radii[i + 1]);
}

// An optimized path in both gears, with what holds for all of them.
OptimizedPath optimized_in_both_gears(ChainOptimizer& optimizer, const OptimizedWorld& in, const Path& path,
                                      const Vehicle& vehicle, const ChainEffort& effort = kUsualEffort) {
  OptimizedPath now;
  now.result = optimizer.optimize(path, {vehicle, in.world, in.outlines, effort}, now.path);
  if (!now.result.is_optimized) return now;
  now.time = speed_profile(now.path, vehicle).total_time;
  now.is_free = motion_free(*in.queries.sweep, vehicle.body(0.5 * vehicle.safety_margin()), now.path);
  const auto expect_same = [](const Pose& a, const Pose& b) {
    EXPECT_NEAR((a.position() - b.position()).norm(), 0.0, 1e-9);
    EXPECT_NEAR(wrap_signed(a.heading - b.heading), 0.0, 1e-9);
  };
  expect_same(now.path.front().start, path.front().start);
  expect_same(now.path.back().end(), path.back().end());
  for (std::size_t i = 0; i < now.path.size(); ++i) {
    if (i > 0) expect_same(now.path[i - 1].end(), now.path[i].start);
    if (!now.path[i].is_line()) {
      EXPECT_GE(1.0 / std::abs(now.path[i].curvature), vehicle.min_turning_radius() * (1.0 - 1e-15));
    }
  }
  EXPECT_LE(cusps_of(now.path), cusps_of(path));
  return now;
}

std::vector<Vehicle> vehicles_in_both_gears() {
  std::vector<Vehicle> vehicles;
  const auto add = [&](const TurnSpeedLaw& law, double reverse) {
    vehicles.push_back(
        Vehicle({.max_speed = 4.0, .turn_speed = law, .max_reverse_speed = reverse, .max_acceleration = 2.0}));
  };
  add(LateralAccelerationLimit{2.0}, 4.0);
  add(LateralAccelerationLimit{2.0}, 1.0);  // slower backwards than in the tightest turn
  add(ConstantTurnSpeed{1.5}, 4.0);
  add(ConstantTurnSpeed{1.5}, 1.0);
  add(TurnSpeedTable{{{1.0, 1.0}, {9.0, 3.0}}}, 4.0);
  add(TurnSpeedTable{{{1.0, 1.0}, {9.0, 3.0}}}, 0.5);
  return vehicles;
}

TEST(OptimizeChain, ServesPathsOfVehiclesOfOneTurnSpeed) {
  for (const Vehicle& vehicle : vehicles_in_both_gears()) EXPECT_TRUE(ChainOptimizer::serves(vehicle));
  EXPECT_FALSE(ChainOptimizer::serves(Vehicle({.turn_speed = TurnSpeedTable{{{0.5, 1.0}, {1.2, 3.0}}}})));
}

TEST(OptimizeChain, MostPathsInBothGearsBecomeFasterAndStayFree) {
  const Clutter clutter =
      generate_clutter({.kind = ClutterKind::kConvex, .obstacles = 25, .vertices = 6, .fill = 0.12, .seed = 3});
  const OptimizedWorld in(World(clutter.obstacles, clutter.bounds));
  test::RandomInputs random(11);
  ChainOptimizer optimizer, again;
  const Vec2 low = in.world.box().min, span = in.world.box().max - low;
  for (const Vehicle& vehicle : vehicles_in_both_gears()) {
    int tried = 0, free = 0, faster = 0;
    double share = 0.0;
    while (tried < 25) {
      Path path = test::random_gear_path(random, 1.3 * vehicle.min_turning_radius(), 0.2 * span.minCoeff());
      const Vec2 to = low + span.cwiseProduct(random.point(0.1, 0.7));
      for (PathSegment& segment : path) {
        segment.start.x += to.x();
        segment.start.y += to.y();
      }
      if (!motion_free(*in.queries.sweep, vehicle.body(0.5 * vehicle.safety_margin()), path)) continue;
      ++tried;
      const double before = speed_profile(path, vehicle).total_time;
      const OptimizedPath result = optimized_in_both_gears(optimizer, in, path, vehicle);
      const OptimizedPath same = optimized_in_both_gears(again, in, path, vehicle);
      EXPECT_EQ(same.time, result.time);
      if (!result.result.is_optimized || !result.is_free) continue;
      ++free;
      faster += result.time < before;
      share += std::min(result.time / before, 1.0);
    }
    EXPECT_GE(free, 22);
    EXPECT_GE(faster, 22);
    EXPECT_LT(share, 0.92 * free);
  }
}

// Without obstacles, three turns that are too wide become as fast as the best word of the smallest radius.
TEST(OptimizeChain, FindsTheTurnInThreePoints) {
  const OptimizedWorld in{World({})};
  const Vehicle vehicle({.turn_speed = ConstantTurnSpeed{1.0}, .max_acceleration = 2.0});
  const double radius = vehicle.min_turning_radius();
  Path path{{{0.0, 0.0, 0.0}, 1.0, 0.0}};
  for (const auto& [turn, curvature, gear] : {std::tuple{1.2, 0.8 / radius, Gear::kForward},
                                              {0.8, -0.9 / radius, Gear::kReverse},
                                              {kPi - 2.0, 0.7 / radius, Gear::kForward}})
    path.push_back({path.back().end(), turn / std::abs(curvature), curvature, gear});
  ChainOptimizer optimizer;
  const OptimizedPath result = optimized_in_both_gears(optimizer, in, path, vehicle, {1, 0.05, 100, 1e-3});
  ASSERT_TRUE(result.result.is_optimized);
  double fastest = speed_profile(path, vehicle).total_time;
  EXPECT_LT(result.time, 0.97 * fastest);
  for (std::size_t word = 0; word < kGearWords; ++word)
    if (const auto other = GearWords(path.front().start, path.back().end(), radius).path(word))
      if (cusps_of(*other) == 2) fastest = std::min(fastest, speed_profile(*other, vehicle).total_time);
  EXPECT_LE(result.time, 1.001 * fastest);
}

TEST(OptimizeChain, IsNotDoneWhereNoLineGivesWay) {
  const OptimizedWorld in{World({})};
  const Pose start{0, 0, 0};
  const Path path{{start, 2.0, 0.5}, {PathSegment{start, 2.0, 0.5}.end(), 2.0, 0.2}};
  const CircleChain chain = chain_of(path, start, path.back().end()).value();
  ChainOptimizer optimizer;
  const OptimizedPath result = optimized_path(optimizer, in, chain);
  EXPECT_FALSE(result.result.is_optimized);
  EXPECT_EQ(result.result.iterations, 0);
}

}  // namespace
}  // namespace arcway::internal

#include "core/collision/close_ends.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "arcway/datasets/clutter.h"
#include "tests/support/boxes.h"
#include "tests/support/random_bodies.h"

namespace arcway::internal::close_ends_test {
namespace {

using test::box;

// A random motion of several segments in both gears.
Path random_path(test::RandomInputs& random, const Vehicle& vehicle, Pose at) {
  Path path;
  for (int i = 0; i < 4; ++i) {
    const Gear gear = random.unit() < 0.7 ? Gear::kForward : Gear::kReverse;
    const Side side = random.unit() < 0.5 ? Side::kLeft : Side::kRight;
    const double radius = vehicle.min_turning_radius(side) * random.uniform(1.0, 1.5);
    const double curvature = random.unit() < 0.2 ? 0.0 : sign_of(side) / radius;
    path.push_back({at, random.uniform(0.02, 0.6), curvature, gear});
    at = path.back().end();
  }
  return path;
}

double length_of_all(const Path& path) {
  double length = 0.0;
  for (const PathSegment& segment : path) length += segment.length;
  return length;
}

TEST(CloseEnds, CostNoMoreThanAnyPathDoes) {
  test::RandomInputs random(3);
  int bounded = 0, tight = 0;
  for (std::uint64_t i = 0; i < 240; ++i) {
    const World free = random_world({.obstacles = 12, .vertices = 6, .fill = 0.3, .seed = i / 8});
    const double side = free.box().max.x();
    const World world = free.with_zones({{box(0.2 * side, 0.1 * side, 0.7 * side, 0.8 * side), KeepClear{0.7, 2.0}}});
    const Vehicle vehicle = i % 2 == 0 ? Vehicle() : test::random_body_vehicle(random);
    const auto outlines = std::make_shared<const Outlines>(world);
    const auto cost =
        ClearanceCost::of(vehicle, outlines, ClearancePreference{.distance = 0.6, .cost = 5.0}, world.zones());
    const Path path =
        random_path(random, vehicle, {random.uniform(0, side), random.uniform(0, side), random.uniform(-3.0, 3.0)});
    const double bound =
        close_ends_cost(*cost, vehicle, *outlines, path.front().start, path.back().end(), length_of_all(path));
    EXPECT_LE(bound, cost->of(path) * (1.0 + 1e-12)) << "path " << i;
    bounded += bound > 0.1 ? 1 : 0;
    tight += bound > 0.5 * cost->of(path) && bound > 0.0 ? 1 : 0;
  }
  EXPECT_GT(bounded, 30);
  EXPECT_GT(tight, 10);
}

// A body that drives straight off a wall behind it. Nothing of it moves faster than F on a line.
TEST(CloseEnds, AreAsFarAsTheBodyMayMove) {
  const World world = World({box(-3, -5, -2, 5)});
  const Vehicle vehicle;
  const auto outlines = std::make_shared<const Outlines>(world);
  const double rear = vehicle.footprint().rear;
  const Pose start{-2.0 + rear + 0.1, 0.0, 0.0}, goal{30.0, 0.0, 0.0};
  const ClearanceCost cost(vehicle, outlines, {.distance = 0.5, .cost = 10.0});
  const double bound = close_ends_cost(cost, vehicle, *outlines, start, goal, 32.0);
  const double exact = cost.of(PathSegment{start, 32.0, 0.0});
  EXPECT_NEAR(exact, 4.0, 1e-9);
  EXPECT_LE(bound, exact);
  EXPECT_GT(bound, 0.3 * exact);
  EXPECT_NEAR(close_ends_cost(cost, vehicle, *outlines, goal, start, 32.0), bound, 1e-12);
  EXPECT_NEAR(close_ends_cost(cost, vehicle, *outlines, start, goal, 0.01), 0.1, 1e-9);
  EXPECT_EQ(close_ends_cost(cost, vehicle, *outlines, goal, goal, 32.0), 0.0);
}

TEST(CloseEnds, OfAZoneReachToItsBorder) {
  const World world = World({box(-3, -5, -2, 5)});
  const Vehicle vehicle;
  const auto outlines = std::make_shared<const Outlines>(world);
  const Pose start{-2.0 + vehicle.footprint().rear + 0.1, 0.0, 0.0}, goal{30.0, 0.0, 0.0};
  const auto bound_in = [&](const Polygon& area) {
    const std::vector<Zone> zones{{area, KeepClear{0.5, 10.0}}};
    return close_ends_cost(*ClearanceCost::of(vehicle, outlines, std::nullopt, zones), vehicle, *outlines, start, goal,
                           32.0);
  };
  EXPECT_GT(bound_in(box(-10, -10, 10, 10)), 1.0);
  EXPECT_NEAR(bound_in(box(-10, -10, start.x + 0.05, 10)), 0.5, 1e-7);
  EXPECT_EQ(bound_in(box(5, -10, 10, 10)), 0.0);
}

}  // namespace
}  // namespace arcway::internal::close_ends_test

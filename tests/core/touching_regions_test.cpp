// Plans around regions that touch themselves, and around the same regions cut in two.

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/planner.h"
#include "tests/support/plans.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

VehicleParameters small_robot() {
  VehicleParameters parameters;
  parameters.length = 0.3;
  parameters.width = 0.2;
  parameters.wheelbase = 0.2;
  parameters.max_steering_angle = 0.75;
  parameters.max_speed = 1.0;
  parameters.turn_speed = ConstantTurnSpeed{1.0};
  parameters.max_acceleration = 1000.0;
  return parameters;
}

// A square of 10 m with a triangle whose apex touches its lower edge at x: in one piece, and in two that share the
// edge above the triangle.
struct SameRegions {
  std::vector<Polygon> touching, cut;
};
SameRegions square_with_triangle(double x, const Vec2& along, const Vec2& offset) {
  const auto at = [&](double u, double v) { return Vec2(offset + u * along + v * Vec2(-along.y(), along.x())); };
  const Vec2 apex = at(x, 0), top = at(x, 10), base = at(x, 4), left = at(x - 2, 4), right = at(x + 2, 4);
  return {{{{at(0, 0), at(10, 0), at(10, 10), at(0, 10)}, {{apex, right, left}}}},
          {{{at(0, 0), apex, left, base, top, at(0, 10)}, {}}, {{apex, at(10, 0), at(10, 10), top, base, right}, {}}}};
}

// The two are one set of points, so that the plan of one is a path of the other: no bound may exceed it.
TEST(TouchingRegions, BoundsHoldForTheSameRegionsCutInTwo) {
  test::RandomInputs random(7);
  const Vehicle vehicle(small_robot());
  for (int round = 0; round < 12; ++round) {
    SCOPED_TRACE(round);
    // Whole coordinates and legs of triangles with whole sides: the apex lies on the edge exactly.
    const Vec2 along = round % 3 == 0 ? Vec2(1, 0) : round % 3 == 1 ? Vec2(0.75, 1) : Vec2(-1.25, 3);
    const Vec2 offset = round % 2 == 0 ? Vec2(0, 0) : Vec2(1e6, -5e5);
    const SameRegions regions = square_with_triangle(static_cast<double>(random.integer(3, 7)), along, offset);
    const World world(regions.touching), cut(regions.cut);
    ASSERT_EQ(world.self_contacts().size(), 1u);
    ASSERT_TRUE(cut.self_contacts().empty());
    const double size = along.norm();
    const Planner planner(world, vehicle), other(cut, vehicle);
    for (int i = 0; i < 4; ++i) {
      const auto pose = [&](double u) {
        const Vec2 p = offset + u * along + random.uniform(-1.0, 9.0) * Vec2(-along.y(), along.x());
        return Pose{p.x(), p.y(), random.uniform(0.0, kTwoPi)};
      };
      const PlanRequest request{.start = pose(-1.0 - 1.0 / size), .goal = pose(11.0 + 1.0 / size)};
      const PlanResult a = planner.plan(request), b = other.plan(request);
      ASSERT_TRUE(a.solved()) << a.reason;
      ASSERT_TRUE(b.solved()) << b.reason;
      test::expect_valid(planner, a);
      test::expect_valid(other, b);
      EXPECT_GE(a.travel_time, b.lower_bound);
      EXPECT_GE(b.travel_time, a.lower_bound);
      EXPECT_NEAR(a.lower_bound, b.lower_bound, 1e-9 * a.lower_bound);
      EXPECT_NEAR(a.travel_time, b.travel_time, 0.02 * a.travel_time);
    }
  }
}

// The way along the wall that a hole touches is the fastest one.
TEST(TouchingRegions, AWayAlongTheTouchedEdgeIsFound) {
  const Vehicle vehicle(small_robot());
  const PlanRequest request{.start = {-3, 2, -0.5 * kPi}, .goal = {13, 2, 0.5 * kPi}};
  const Ring square = test::square(0, 0, 10);
  const Planner touching(World({{square, {{{5, 0}, {7, 4}, {3, 4}}}}}), vehicle);
  const Planner apart(World({{square, {{{5, 1}, {7, 4}, {3, 4}}}}}), vehicle);
  const PlanResult a = touching.plan(request), b = apart.plan(request);
  ASSERT_TRUE(a.solved());
  ASSERT_TRUE(b.solved());
  EXPECT_EQ(a.travel_time, b.travel_time);
  EXPECT_EQ(a.lower_bound, b.lower_bound);
}

// A wheelbase longer than the body: the reference point lies off the body, and may be over an obstacle.
TEST(BodiesApartFromTheirReferencePoint, HaveValidPlans) {
  VehicleParameters parameters = small_robot();
  parameters.wheelbase = 0.8;
  const Vehicle vehicle(parameters);
  const Footprint body = vehicle.footprint();
  ASSERT_LT(body.rear, 0.0);
  // Posts of the size of the gap between the body and the reference point, and walls.
  std::vector<Polygon> obstacles;
  for (int i = 0; i < 5; ++i)
    for (int k = 0; k < 5; ++k) obstacles.push_back({test::square(2.0 * i, 2.0 * k + 0.3 * (i % 3), 0.3), {}});
  const Planner planner(World(obstacles, test::square(-4, -4, 18)), vehicle);
  test::RandomInputs random(3);
  int solved = 0;
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const auto pose = [&] { return Pose{random.uniform(-2, 11), random.uniform(-2, 11), random.uniform(0.0, kTwoPi)}; };
    const PlanResult result = planner.plan({.start = pose(), .goal = pose()});
    if (!result.solved()) continue;
    ++solved;
    test::expect_valid(planner, result);
  }
  EXPECT_GT(solved, 4);
}

}  // namespace
}  // namespace arcway::internal

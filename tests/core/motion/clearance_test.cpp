#include "core/motion/clearance.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "arcway/validation.h"
#include "core/geometry/distance.h"
#include "tests/support/boxes.h"

namespace arcway::internal {
namespace {

const Footprint kBody{1.4, 0.1, 0.4, 0.4};

using test::box;

TEST(Clearance, EmptyWorld) {
  const Clearance clearance = clearance_along({{}, 5.0, 0.0}, kBody, World({}));
  EXPECT_EQ(clearance.distance, std::numeric_limits<double>::infinity());
  EXPECT_EQ(clearance.edge, kNone);
  EXPECT_EQ(clearance_below(7.0, {{}, 5.0, 0.0}, kBody, Outlines(World({}))), 7.0);
}

TEST(Clearance, StraightBesideAndAhead) {
  const PathSegment line{{1.0, 0.0, 0.0}, 5.0, 0.0};
  const Clearance beside = clearance_along(line, kBody, World({box(4.0, 0.7, 5.0, 2.0), box(30.0, 0.0, 31.0, 1.0)}));
  EXPECT_NEAR(beside.distance, 0.3, 1e-15);
  EXPECT_EQ(beside.edge, 0u);
  EXPECT_GE(beside.arc_length, 4.0 - 1.4 - 1.0 - 1e-12);
  EXPECT_LE(beside.arc_length, 5.0 + 0.1 - 1.0 + 1e-12);
  const Clearance ahead = clearance_along(line, kBody, World({box(8.0, -1.0, 9.0, 1.0)}));
  EXPECT_NEAR(ahead.distance, 0.6, 1e-14);
  EXPECT_EQ(ahead.arc_length, 5.0);
  EXPECT_EQ(ahead.edge, 3u);
  EXPECT_EQ(clearance_along(line, kBody, World({box(4.0, 0.0, 4.1, 0.1)})).distance, 0.0);
  EXPECT_EQ(clearance_along(line, kBody, World({box(4.0, -1.0, 4.1, 1.0)})).distance, 0.0);
}

TEST(Clearance, TurningAboutAVertexAndPastAWall) {
  const PathSegment left{{0.0, 0.0, 0.0}, 2.0 * std::numbers::pi, 0.5};  // half a circle about (0, 2)
  const Clearance inner = clearance_along(left, kBody, World({{{Vec2(0.0, 1.5), Vec2(1.5, 2.0), Vec2(0.0, 2.5)}, {}}}));
  EXPECT_NEAR(inner.distance, 0.1, 1e-14);
  EXPECT_NEAR(inner.arc_length, std::numbers::pi, 1e-12);  // abeam at a quarter turn
  const double outer = std::hypot(1.4, 2.4);
  const Clearance wall = clearance_along(left, kBody, World({box(outer + 0.2, -9.0, outer + 1.0, 9.0)}));
  EXPECT_NEAR(wall.distance, 0.2, 1e-14);
  EXPECT_NEAR(wall.arc_length, 2.0 * std::atan2(2.4, 1.4), 1e-12);
  EXPECT_EQ(wall.edge, 3u);
  EXPECT_EQ(clearance_along(left, kBody, World({box(outer - 1e-9, -9.0, outer + 1.0, 9.0)})).distance, 0.0);
  // The mirror image.
  const PathSegment right{{0.0, 0.0, 0.0}, 2.0 * std::numbers::pi, -0.5};
  EXPECT_NEAR(clearance_along(right, kBody, World({box(outer + 0.2, -9.0, outer + 1.0, 9.0)})).distance, 0.2, 1e-14);
}

TEST(Clearance, BoundsCount) {
  const World world({}, box(-5.0, -5.0, 8.0, 5.0).outer);
  EXPECT_NEAR(clearance_along({{}, 5.0, 0.0}, kBody, world).distance, 1.6, 1e-14);
}

TEST(Clearance, ZeroLengthIsThePose) {
  const World world({box(2.0, -1.0, 3.0, 1.0)});
  EXPECT_NEAR(clearance_along({{}, 0.0, 0.0}, kBody, world).distance, 0.6, 1e-15);
  EXPECT_NEAR(clearance_along({{}, 0.0, 0.5}, kBody, world).distance, 0.6, 1e-15);
}

// Against a check that shares no code: the validator's proved bound, at most 1e-6 below the true value.
TEST(Clearance, BackwardsIsThatOfTheSameMotionForwards) {
  const World world({box(4.0, 0.7, 5.0, 2.0)});
  for (const double curvature : {0.0, 0.2, -0.3}) {
    const PathSegment forwards{{1.0, 0.0, 0.0}, 3.0, curvature};
    const Clearance ahead = clearance_along(forwards, kBody, world);
    const Clearance back = clearance_along(forwards.reversed(), kBody, world);
    EXPECT_NEAR(back.distance, ahead.distance, 1e-12);
    EXPECT_NEAR(back.arc_length, 3.0 - ahead.arc_length, 1e-9);
    EXPECT_EQ(back.edge, ahead.edge);
  }
}

// The body as a polygon, at many poses of the motion.
TEST(Clearance, OfAnUnevenBodyIsThatOfItsOutline) {
  const Footprint body{1.4, 0.1, 0.7, 0.2};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-5.0, 5.0), unit(0.0, 1.0);
  int free = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<Polygon> obstacles;
    for (int i = 0; i < 3; ++i) {
      const Vec2 p(place(random), place(random));
      obstacles.push_back({{p, p + Vec2(0.8, 0.1), p + Vec2(0.1, 0.9)}, {}});
    }
    const World world(obstacles);
    const double curvature = round % 3 == 0 ? 0.0 : 1.6 * unit(random) - 0.8;
    const PathSegment segment{{0.0, 0.0, 6.0 * unit(random)}, 3.0 * unit(random), curvature};
    constexpr int kPlaces = 2000;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kPlaces; ++i) {
      const Pose at = segment.at(segment.length * i / kPlaces);
      const Vec2 ahead = direction_of(at.heading), left = perpendicular(ahead);
      const auto corner = [&](double x, double y) -> Vec2 { return at.position() + x * ahead + y * left; };
      const Polygon outline{{corner(-0.1, -0.2), corner(1.4, -0.2), corner(1.4, 0.7), corner(-0.1, 0.7)}, {}};
      for (const Polygon& obstacle : obstacles) least = std::min(least, distance(outline, obstacle));
    }
    const double step = segment.length / kPlaces * (1.0 + 1.6 * std::abs(curvature));
    const double clearance = clearance_along(segment, body, world).distance;
    EXPECT_LE(clearance, least + 1e-12);
    EXPECT_GE(clearance, least - step);
    EXPECT_NEAR(clearance_below(1e3, segment, body, Outlines(world)), clearance, 1e-14);
    free += clearance > 0.0;
  }
  EXPECT_GT(free, 20);
  EXPECT_LT(free, 60);
}

TEST(Clearance, AgreesWithTheValidatorInRandomWorlds) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-8.0, 8.0), size(0.1, 2.0), unit(0.0, 1.0);
  const Vehicle vehicle;
  int free = 0;
  for (int round = 0; round < 500; ++round) {
    std::vector<Polygon> obstacles;
    for (int i = 0; i < 5; ++i) {
      const double x = place(random);
      const double y = place(random);
      obstacles.push_back({{Vec2(x, y), Vec2(x + size(random), y + 0.1), Vec2(x + 0.1, y + size(random))}, {}});
    }
    const World world(obstacles);
    const PathSegment segment{
        {0.0, 0.0, 6.0 * unit(random)}, 5.0 * unit(random), round % 3 == 0 ? 0.0 : (2.0 * unit(random) - 1.0) / 1.3};
    const Clearance clearance = clearance_along(segment, vehicle.footprint(), world);
    const ValidationReport report = validate(world, vehicle, segment.start, segment.end(), {{segment}, {}, {}, {}});
    const Outlines outlines(world);
    const double half = 0.5 * clearance.distance;
    EXPECT_NEAR(clearance_below(1e3, segment, vehicle.footprint(), outlines), clearance.distance, 1e-14);
    EXPECT_NEAR(clearance_below(2.0 * half + 1e-9, segment, vehicle.footprint(), outlines), clearance.distance, 1e-14);
    EXPECT_EQ(clearance_below(half, segment, vehicle.footprint(), outlines), half);
    EXPECT_EQ(clearance.distance > 0.0, report.valid()) << "round " << round;
    if (!report.valid()) continue;
    ++free;
    EXPECT_LE(report.min_clearance, clearance.distance + 1e-12) << "round " << round;
    EXPECT_GE(report.min_clearance, clearance.distance - 1.1e-6) << "round " << round;
    // At the place given it is that near.
    const Pose pose = segment.at(clearance.arc_length);
    EXPECT_NEAR(clearance_along({pose, 0.0, 0.0}, vehicle.footprint(), world).distance, clearance.distance, 1e-12);
  }
  EXPECT_GT(free, 150);
}

}  // namespace
}  // namespace arcway::internal

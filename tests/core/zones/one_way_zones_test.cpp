#include "core/zones/one_way_zones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "arcway/angle.h"
#include "tests/support/boxes.h"
#include "tests/support/depth_in.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal::one_way_zones_test {
namespace {

using test::box;
using test::depth_in;

constexpr double kBorder = OneWayZones::kBorder;

// The largest depth of a place among the zones that its direction of motion is against by more than `slack` [rad].
double depth_against(const std::vector<Zone>& zones, const Vec2& p, double direction, double slack) {
  double deepest = -INFINITY;
  for (const Zone& zone : zones) {
    const auto& rule = std::get<OneWay>(zone.rule);
    if (std::abs(std::remainder(direction - rule.heading, kTwoPi)) > rule.tolerance + slack)
      deepest = std::max(deepest, depth_in(zone.area, p));
  }
  return deepest;
}

std::vector<Zone> random_zones(test::RandomInputs& random) {
  std::vector<Zone> zones;
  for (int i = 0; i < 4; ++i) {
    const Vec2 middle = random.point(-6, 6);
    Polygon area{test::random_star(random, middle, 1.0, random.uniform(1.5, 5.0), 7), {}};
    if (i % 2 == 0) area.holes.push_back(Polygon::regular(middle, 0.5, 4, random.unit()).outer);
    zones.push_back({area, OneWay{random.uniform(-kTwoPi, kTwoPi), random.uniform(0.1, 2.5)}});
  }
  return zones;
}

// A place and its direction of motion at each of many steps along a motion, and how far apart the places are.
constexpr int kSteps = 1500;

double against_along(const std::vector<Zone>& zones, const PathSegment& motion, Gear driven, double slack) {
  double deepest = -INFINITY;
  for (int i = 0; i <= kSteps; ++i) {
    const Pose pose = motion.at(motion.length * i / kSteps);
    const double direction = driven == Gear::kForward ? pose.heading : pose.heading + kPi;
    deepest = std::max(deepest, depth_against(zones, pose.position(), direction, slack));
  }
  return deepest;
}

TEST(OneWayZones, LinesAreDecidedAsByDenseSamples) {
  test::RandomInputs random(4);
  int refused = 0, allowed = 0;
  for (int i = 0; i < 600; ++i) {
    const std::vector<Zone> zones = random_zones(random);
    const OneWayZones query(zones);
    const Vec2 at = random.point(-8, 8);
    const PathSegment line{{at.x(), at.y(), random.uniform(-kPi, kPi)}, random.uniform(0.1, 12.0), 0.0};
    for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
      const bool is_allowed = query.allows_line(line.start, line.length, gear);
      const double step = line.length / kSteps;
      if (against_along(zones, line, gear, 1e-6) > 2.0 * kBorder) {
        EXPECT_FALSE(is_allowed) << i;
        ++refused;
      } else if (against_along(zones, line, gear, -1e-6) + step < 0.0) {
        EXPECT_TRUE(is_allowed) << i;
        ++allowed;
      }
    }
  }
  EXPECT_GT(refused, 250);
  EXPECT_GT(allowed, 300);
}

TEST(OneWayZones, HeadingsOnCirclesAreDecidedAsByDenseSamples) {
  test::RandomInputs random(5);
  int forbidden_count = 0, allowed_count = 0;
  for (int i = 0; i < 300; ++i) {
    const std::vector<Zone> zones = random_zones(random);
    const OneWayZones query(zones);
    const Side side = i % 2 == 0 ? Side::kLeft : Side::kRight;
    const DrivenCircle circle{random.point(-8, 8), random.uniform(0.2, 6.0), side,
                              i % 3 == 0 ? Gear::kReverse : Gear::kForward};
    std::vector<HeadingInterval> forbidden;
    query.append_forbidden(circle, forbidden);
    EXPECT_TRUE(forbidden.empty() || query.are_near(circle.center, circle.radius)) << i;
    const HeadingSet allowed = HeadingSet::complement(forbidden);
    for (int k = 0; k < 500; ++k) {
      const double heading = kTwoPi * (k + random.unit()) / 500;
      const Vec2 p = circle.center + circle.radius * direction_of(heading - sign_of(side) * 0.5 * kPi);
      const double direction = circle.gear == Gear::kForward ? heading : heading + kPi;
      if (depth_against(zones, p, direction, 1e-6) > 2.0 * kBorder) {
        EXPECT_FALSE(allowed.contains(heading)) << i << ", " << heading;
        ++forbidden_count;
      } else if (depth_against(zones, p, direction, -1e-6) < 0.0) {
        EXPECT_TRUE(allowed.contains(heading)) << i << ", " << heading;
        ++allowed_count;
      }
    }
  }
  EXPECT_GT(forbidden_count, 10'000);
  EXPECT_GT(allowed_count, 10'000);
}

TEST(OneWayZones, MotionsAreAllowedUntilTheyAreAgainstAZone) {
  test::RandomInputs random(6);
  int ended = 0;
  for (int i = 0; i < 300; ++i) {
    const std::vector<Zone> zones = random_zones(random);
    const OneWayZones query(zones);
    const Vec2 at = random.point(-8, 8);
    const double curvature = i % 3 == 0 ? 0.0 : random.uniform(-1.0, 1.0);
    const double longest = curvature == 0.0 ? 12.0 : std::min(12.0, kTwoPi / std::abs(curvature));
    const PathSegment motion{{at.x(), at.y(), random.uniform(-kPi, kPi)},
                             random.uniform(0.1, longest),
                             curvature,
                             i % 2 == 0 ? Gear::kForward : Gear::kReverse};
    for (const Gear driven : {Gear::kForward, Gear::kReverse}) {
      const double length = query.allowed_length(motion, driven);
      ASSERT_GE(length, 0.0);
      ASSERT_LE(length, motion.length);
      PathSegment part = motion;
      part.length = length;
      EXPECT_TRUE(length == 0.0 || against_along(zones, part, driven, 1e-6) <= 2.0 * kBorder) << i;
      if (length == motion.length) {
        EXPECT_LE(against_along(zones, motion, driven, 1e-6), 2.0 * kBorder) << i;
        continue;
      }
      ++ended;
      const Pose next = motion.at(std::min(motion.length, length + 1e-3));
      const double direction = driven == Gear::kForward ? next.heading : next.heading + kPi;
      EXPECT_GT(depth_against(zones, next.position(), direction, -1e-2), -1e-2) << i;
    }
  }
  EXPECT_GT(ended, 100);
}

// Zones that are driven towards +x.
std::vector<Zone> lane() { return {{box(0, -1, 10, 1), OneWay{0.0, 0.2}, "lane"}}; }

TEST(OneWayZones, TheBorderIsNotInside) {
  const OneWayZones zones(lane());
  EXPECT_TRUE(zones.allows_line({12, 1, kPi}, 20.0, Gear::kForward));
  EXPECT_TRUE(zones.allows_line({12, 1.0 - 0.5 * kBorder, kPi}, 20.0, Gear::kForward));
  EXPECT_FALSE(zones.allows_line({12, 1.0 - 2.0 * kBorder, kPi}, 20.0, Gear::kForward));
  EXPECT_TRUE(zones.allows_line({10, 3, -0.5 * kPi}, 6.0, Gear::kForward));
  EXPECT_FALSE(zones.allows_line({9.9, 3, -0.5 * kPi}, 6.0, Gear::kForward));
  // Up to the border and no further.
  EXPECT_TRUE(zones.allows_line({5, 4, -0.5 * kPi}, 3.0, Gear::kForward));
  EXPECT_FALSE(zones.allows_line({5, 4, -0.5 * kPi}, 3.0 + 2.0 * kBorder, Gear::kForward));
  // A slanted border, whose line is rounded to either side of it.
  for (int i = 0; i < 50; ++i) {
    const double angle = 0.1 * i;
    const Vec2 along = direction_of(angle), aside = perpendicular(along);
    const Polygon area{{Vec2(-5.0 * along), Vec2(5.0 * along), Vec2(5.0 * along + aside), Vec2(-5.0 * along + aside)},
                       {}};
    const OneWayZones slanted(std::vector<Zone>{{area, OneWay{std::remainder(angle, kTwoPi), 0.0}}});
    const Vec2 from = 6.0 * along;
    EXPECT_TRUE(slanted.allows_line({from.x(), from.y(), angle + kPi}, 12.0, Gear::kForward)) << i;
    const Vec2 middle = from + 0.5 * aside;
    EXPECT_FALSE(slanted.allows_line({middle.x(), middle.y(), angle + kPi}, 12.0, Gear::kForward)) << i;
    // A tolerance of 0 allows the direction itself.
    EXPECT_TRUE(slanted.allows_line({-middle.x(), -middle.y(), angle}, 12.0, Gear::kForward)) << i;
  }
}

// The middle of a way through a zone touches its border: it is in the zone before and behind.
TEST(OneWayZones, AWayThatTouchesTheBorderFromInsideIsInside) {
  const OneWayZones zones(std::vector<Zone>{{{{{0, 0}, {10, 0}, {10, 4}, {5, 2}, {0, 4}}, {}}, OneWay{0.0, 0.5}}});
  EXPECT_FALSE(zones.allows_line({11, 2, kPi}, 12.0, Gear::kForward));
  EXPECT_FALSE(zones.allows_line({10, 2, kPi}, 10.0, Gear::kForward));
}

// A slit that is thinner than the border leads from the right to the middle: what is left of it is in the zone.
TEST(OneWayZones, ASlitEndsWhereItsTipIs) {
  const Polygon area{{{0, -2}, {10, -2}, {10, -1e-9}, {5, 0}, {10, 1e-9}, {10, 2}, {0, 2}}, {}};
  const OneWayZones zones(std::vector<Zone>{{area, OneWay{0.0, 0.5}}});
  EXPECT_FALSE(zones.allows_line({10, 0, kPi}, 10.0, Gear::kForward));
  EXPECT_TRUE(zones.allows_line({10, 0, kPi}, 5.0, Gear::kForward));
}

TEST(OneWayZones, DirectionsAreThoseOfMotion) {
  const OneWayZones zones(lane());
  EXPECT_TRUE(zones.allows_line({1, 0, 0.2}, 2.0, Gear::kForward));
  EXPECT_FALSE(zones.allows_line({1, 0, 0.21}, 2.0, Gear::kForward));
  EXPECT_FALSE(zones.allows_line({1, 0, 0.0}, 2.0, Gear::kReverse));
  EXPECT_TRUE(zones.allows_line({3, 0, kPi}, 2.0, Gear::kReverse));
  EXPECT_TRUE(zones.allows_line({3, 0, kPi - 0.19 + kTwoPi}, 2.0, Gear::kReverse));
  EXPECT_TRUE(zones.allows_line({3, 0, kPi}, 0.0, Gear::kForward));  // stands
  EXPECT_EQ(zones.zone_against({3, 0, 0}, Gear::kForward), kNone);
  EXPECT_EQ(zones.zone_against({3, 0, 0}, Gear::kReverse), 0u);
  EXPECT_EQ(zones.zone_against({3, 0, 1}, Gear::kForward), 0u);
  EXPECT_EQ(zones.zone_against({3, 1, 1}, Gear::kForward), kNone);
}

TEST(OneWayZones, AreThereOnlyWhereADirectionIsForbidden) {
  EXPECT_EQ(OneWayZones::of(World({})), nullptr);
  EXPECT_EQ(OneWayZones::of(World({}).with_zones({{box(0, 0, 1, 1), OneWay{1.0, kPi}}})), nullptr);
  const auto zones =
      OneWayZones::of(World({}).with_zones({{box(0, 0, 1, 1), KeepOut{}}, {box(0, 0, 1, 1), OneWay{1.0, 0.5}}}));
  ASSERT_NE(zones, nullptr);
  EXPECT_EQ(zones->zones(), std::vector<std::uint32_t>{1});
  EXPECT_FALSE(zones->are_near({5, 5}, 3.0));
  EXPECT_TRUE(zones->are_near({5, 5}, 4.0));
}

}  // namespace
}  // namespace arcway::internal::one_way_zones_test

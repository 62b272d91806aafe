#include "core/search/one_way_routes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stop_token>
#include <vector>

#include "arcway/angle.h"
#include "arcway/stop_clock.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "core/zones/one_way_zones.h"
#include "tests/support/boxes.h"
#include "tests/support/lazy_maps.h"

namespace arcway::internal::one_way_routes_test {
namespace {

using test::box;

const Pose kFrom{5.0, 20.0, 0.0}, kTo{55.0, 20.0, 0.0};

World field(const Polygon& zone, const OneWay& rule) {
  return World({}, test::box_ring(0.0, 0.0, 60.0, 40.0)).with_zones({{zone, rule}});
}

double length_of(const std::vector<Pose>& poses) {
  double length = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) length += (poses[i].position() - poses[i - 1].position()).norm();
  return length;
}

void expect_allowed(const World& world, const std::vector<Pose>& poses) {
  const OneWayZones zones(world.zones());
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const Vec2 d = poses[i + 1].position() - poses[i].position();
    EXPECT_TRUE(zones.allows_line({poses[i].x, poses[i].y, std::atan2(d.y(), d.x())}, d.norm(), Gear::kForward)) << i;
    EXPECT_EQ(zones.zone_against(poses[i], Gear::kForward), kNone) << i;
  }
}

TEST(OneWayRoutes, CrossAZoneInADirectionThatItAllows) {
  const World world = field(box(25.0, -1.0, 30.0, 41.0), {0.5 * kPi, 0.5});
  const Roadmap map = test::lazy_map(world, Vehicle());
  OneWayRoutes routes(map, kFrom, kTo);
  const auto route = routes.find({});
  ASSERT_TRUE(route);
  EXPECT_EQ(route->front(), kFrom);
  EXPECT_EQ(route->back(), kTo);
  expect_allowed(world, *route);
  // Across at an angle to the zone's heading, and as straight as possible before and behind.
  const auto shortest = [](double angle) {
    const double up = 5.0 / std::tan(angle);
    return std::hypot(5.0, up) + std::hypot(45.0, up);
  };
  EXPECT_GE(length_of(*route), shortest(0.5) - 1e-9);
  EXPECT_LE(length_of(*route), shortest(0.45) * 1.001);
}

TEST(OneWayRoutes, LeadAroundAZoneOfTheOtherDirection) {
  const World world = field(box(20.0, 10.0, 40.0, 30.0), {kPi, 0.3});
  const Roadmap map = test::lazy_map(world, Vehicle());
  const auto route = OneWayRoutes(map, kFrom, kTo).find({});
  ASSERT_TRUE(route);
  expect_allowed(world, *route);
  EXPECT_GE(length_of(*route), 20.0 + 2.0 * std::hypot(15.0, 10.0));
  EXPECT_LE(length_of(*route), (20.0 + 2.0 * std::hypot(15.0, 10.0)) * 1.01);
}

TEST(OneWayRoutes, AreOthersWithoutALineUntilNoneIsLeft) {
  const World world = field(box(25.0, 18.0, 30.0, 22.0), {kPi, 0.3});
  const Roadmap map = test::lazy_map(world, Vehicle());
  OneWayRoutes routes(map, kFrom, kTo);
  double longest = 0.0;
  std::size_t count = 0;
  for (auto route = routes.find({}); route && count < 5000; route = routes.find({}), ++count) {
    ASSERT_GT(route->size(), 2u);
    expect_allowed(world, *route);
    longest = std::max(longest, length_of(*route));
    routes.leave_out(0);  // a line from the start: as many as places
  }
  EXPECT_GT(count, 10u);
  EXPECT_LT(count, 5000u);
  EXPECT_GT(longest, 50.1);
}

TEST(OneWayRoutes, LeadAroundAZoneOfManyEdges) {
  const World world = field(Polygon::regular({30.0, 20.0}, 10.0, 64), {kPi, 0.3});
  const Roadmap map = test::lazy_map(world, Vehicle());
  OneWayRoutes routes(map, kFrom, kTo);
  const auto route = routes.find({});
  ASSERT_TRUE(route);
  expect_allowed(world, *route);
  EXPECT_LE(length_of(*route), 60.0);
}

TEST(OneWayRoutes, AreNoneWhereEdgesAreTooMany) {
  const World world = field(Polygon::regular({30.0, 20.0}, 10.0, 20000), {kPi, 0.3});
  const Roadmap map = test::lazy_map(world, Vehicle());
  EXPECT_FALSE(OneWayRoutes(map, kFrom, kTo).find({}));
}

TEST(OneWayRoutes, AreNotFoundWhenTheClockIsOver) {
  std::stop_source source;
  source.request_stop();
  const World world = field(box(25.0, -1.0, 30.0, 41.0), {0.5 * kPi, 0.5});
  const Roadmap map = test::lazy_map(world, Vehicle());
  EXPECT_FALSE(OneWayRoutes(map, kFrom, kTo).find(StopClock(INFINITY, source.get_token())));
}

}  // namespace
}  // namespace arcway::internal::one_way_routes_test

#include "core/search/zone_routes.h"

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
#include "tests/support/boxes.h"
#include "tests/support/lazy_maps.h"

namespace arcway::internal {

using test::box_ring;

namespace {

const Vec2 kFrom(5.0, 20.0), kTo(55.0, 20.0);

// A field of 60 m x 40 m with one zone, whose limit is a share of the top speed.
World field(const Ring& zone, double share, const std::vector<Polygon>& walls = {}) {
  return World(walls, box_ring(0.0, 0.0, 60.0, 40.0))
      .with_zones({{{zone, {}}, SpeedLimit{share * Vehicle().max_speed()}}});
}
World field_with_a_square(double share, const std::vector<Polygon>& walls = {}) {
  return field(box_ring(20.0, 10.0, 40.0, 30.0), share, walls);
}

std::optional<ZoneRoutes::Route> route(const World& world, const Vec2& from, const Vec2& to, double slower = 1.0,
                                       const StopClock& clock = {}) {
  const Vehicle vehicle;
  const Roadmap map = test::lazy_map(world, vehicle);
  return ZoneRoutes(map).find(from, to, slower, clock);
}

double time_of(double free_length, double slow_length, double share) {
  return (free_length + slow_length / share) / Vehicle().max_speed();
}

// Over two corners of the square.
const double kAroundTheSquare = 2.0 * std::hypot(15.0, 10.0) + 20.0;

TEST(ZoneRoutes, LeadAroundAZoneThatIsSlow) {
  const auto around = route(field_with_a_square(0.25), kFrom, kTo);
  ASSERT_TRUE(around);
  EXPECT_GE(around->time, time_of(kAroundTheSquare, 0.0, 1.0) * (1.0 - 1e-9));
  EXPECT_LE(around->time, time_of(kAroundTheSquare, 0.0, 1.0) * 1.004);
  EXPECT_EQ(around->places.front(), kFrom);
  EXPECT_EQ(around->places.back(), kTo);
}

TEST(ZoneRoutes, LeadAcrossAZoneThatIsHardlySlow) {
  const auto across = route(field_with_a_square(0.8), kFrom, kTo);
  ASSERT_TRUE(across);
  EXPECT_NEAR(across->time, time_of(30.0, 20.0, 0.8), 1e-6);
  EXPECT_EQ(across->places.size(), 2U);
}

TEST(ZoneRoutes, LeadAroundItIfItCountsAsSlower) {
  const auto around = route(field_with_a_square(0.8), kFrom, kTo, 3.0);
  ASSERT_TRUE(around);
  EXPECT_GT(around->places.size(), 2U);
}

// Walls from the square to both sides of the field.
TEST(ZoneRoutes, LeadAcrossItWhereWallsLeaveNoOtherWay) {
  const std::vector<Polygon> walls{{box_ring(29.0, 0.0, 31.0, 19.0), {}}, {box_ring(29.0, 21.0, 31.0, 40.0), {}}};
  const auto across = route(field_with_a_square(0.25, walls), kFrom, kTo);
  ASSERT_TRUE(across);
  EXPECT_LE(across->time, time_of(30.0, 20.0, 0.25) * 1.001);
  EXPECT_GE(across->time, time_of(30.0, 20.0, 0.25) * (1.0 - 1e-9));
}

// A lane beside the square, driven against the route: the other side is free.
TEST(ZoneRoutes, AvoidOneWayZones) {
  const World with_lane = field_with_a_square(0.25);
  std::vector<Zone> zones(with_lane.zones().begin(), with_lane.zones().end());
  zones.push_back({{box_ring(20.0, 0.0, 40.0, 10.0), {}}, OneWay{kPi, 0.5}});
  for (const double from_y : {18.0, 22.0}) {  // the lane's side is the shorter one from the first
    const auto around = route(with_lane.with_zones(zones), {5.0, from_y}, {55.0, from_y});
    ASSERT_TRUE(around);
    for (const Vec2& p : around->places) EXPECT_GE(p.y(), from_y - 1e-9);
    EXPECT_LE(around->time, time_of(2.0 * std::hypot(15.0, 30.0 - from_y) + 20.0, 0.0, 1.0) * 1.01);
  }
}

// A strip across the field: the fastest route bends at both of its borders.
TEST(ZoneRoutes, BendAtBorders) {
  const double share = 0.5;
  const Vec2 from(5.0, 5.0), to(55.0, 35.0);
  double best = INFINITY;
  for (double enter = 5.0; enter <= 35.0; enter += 0.05)
    for (double leave = enter; leave <= 35.0; leave += 0.05)
      best = std::min(best, time_of(std::hypot(15.0, enter - 5.0) + std::hypot(15.0, 35.0 - leave),
                                    std::hypot(20.0, leave - enter), share));
  const auto bent = route(field(box_ring(20.0, -1.0, 40.0, 41.0), share), from, to);
  ASSERT_TRUE(bent);
  EXPECT_GE(bent->time, best * (1.0 - 1e-4));
  EXPECT_LE(bent->time, best * 1.0001);
  EXPECT_LT(bent->time, 0.99 * time_of(0.6 * std::hypot(50.0, 30.0), 0.4 * std::hypot(50.0, 30.0), share));
}

TEST(ZoneRoutes, BeginAndEndAnywhereInTheOpen) {
  const World open = World({}).with_zones({{{box_ring(20.0, 10.0, 40.0, 30.0), {}}, SpeedLimit{0.5}}});
  const Vec2 far(-500.0, 20.0), beyond(700.0, 20.0);
  const auto around = route(open, far, beyond);
  ASSERT_TRUE(around);
  EXPECT_LE(around->time, time_of(2.0 * std::hypot(520.0, 10.0) + 160.0, 0.0, 1.0) * 1.01);
}

TEST(ZoneRoutes, AreNoneOnceTheTimeIsUp) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(route(field_with_a_square(0.25), kFrom, kTo, 1.0, StopClock(INFINITY, stop.get_token())));
}

}  // namespace
}  // namespace arcway::internal

#include "core/collision/path_cost.h"

#include <gtest/gtest.h>

#include <memory>

#include "core/model/outlines.h"
#include "tests/support/boxes.h"

namespace arcway::internal::path_cost_test {
namespace {

TEST(PathCost, IsTimeGearChangesAndCloseDriving) {
  const World world =
      World({test::box(4.0, 1.0, 6.0, 2.0)}).with_zones({{test::box(8.0, -5.0, 20.0, 5.0), SpeedLimit{0.4}}});
  const Vehicle vehicle({.max_speed = 1.0, .max_acceleration = 1.0});
  const auto zones = SpeedZones::of(world);
  const ClearanceCost clearance(vehicle, std::make_shared<const Outlines>(world), {.distance = 0.8, .cost = 3.0});
  const Path path{{{0.0, 0.0, 0.0}, 12.0, 0.0}, {{12.0, 0.0, 0.0}, 2.0, 0.0, Gear::kReverse}};
  SpeedProfile profile;
  const double time = travel_time(path, vehicle, {}, profile),
               slow_time = travel_time(path, vehicle, {}, profile, zones.get());
  ASSERT_GT(slow_time, time + 1.0);
  ASSERT_GT(clearance.of(path), 1.0);
  EXPECT_EQ(path_cost(path, vehicle), time);
  EXPECT_EQ(path_cost(path, vehicle, {.cusp_cost = 5.0}), time + 5.0);
  const PathCosts all{.zones = zones.get(), .clearance = &clearance, .cusp_cost = 5.0};
  EXPECT_EQ(path_cost(path, vehicle, all), slow_time + 5.0 + clearance.of(path));
  profile = {};
  EXPECT_EQ(path_cost(path, vehicle, all, profile), path_cost(path, vehicle, all));
  EXPECT_EQ(profile.total_time, slow_time);
}

TEST(PathCost, IsNotKnownBetterThanAskedFor) {
  const World world({test::box(4.0, 1.0, 6.0, 2.0)});
  const Vehicle vehicle;
  const ClearanceCost clearance(vehicle, std::make_shared<const Outlines>(world), {.distance = 0.8, .cost = 3.0});
  const Path path{{{0.0, 0.0, 0.0}, 12.0, 0.0}};
  SpeedProfile profile;
  const double time = path_cost(path, vehicle), whole = path_cost(path, vehicle, {.clearance = &clearance});
  ASSERT_GT(whole, time);
  EXPECT_EQ(path_cost(path, vehicle, {.clearance = &clearance}, profile, time), time);
  EXPECT_EQ(path_cost(path, vehicle, {.clearance = &clearance}, profile, 1.01 * time), whole);
}

TEST(PathCost, IsInfiniteBetweenSpeedsOutOfReach) {
  const Path path{{{0.0, 0.0, 0.0}, 0.1, 0.0}};
  EXPECT_EQ(path_cost(path, Vehicle({.max_acceleration = 1.0}), {.ends = {0.0, 3.0}}), kInfinity);
}

}  // namespace
}  // namespace arcway::internal::path_cost_test

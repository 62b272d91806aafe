#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "arcway/world_change.h"
#include "tests/support/boxes.h"

namespace arcway::internal {
namespace {

using test::box;

Vehicle named(const std::string& name) {
  VehicleParameters parameters;
  parameters.name = name;
  return Vehicle(parameters);
}

// A wall, a keep-out for all, one for two trucks, and a speed limit.
World yard() {
  return World({box(0, 0, 4, 4)}, box(-50, -50, 50, 50).outer)
      .with_zones({{box(10, 0, 14, 4), KeepOut{}, "dock"},
                   {box(20, 0, 24, 4), KeepOut{{"truck", "van"}}, ""},
                   {box(30, 0, 34, 4), SpeedLimit{2.0}, "school"}});
}

std::string error_of(std::vector<Zone> zones) {
  try {
    static_cast<void>(World({}).with_zones(std::move(zones)));
  } catch (const ZoneError& error) {
    return std::to_string(error.zone()) + "; " + error.what();
  }
  return "";
}

TEST(WorldZones, AreKeptAsGiven) {
  const World world = yard();
  ASSERT_EQ(world.zones().size(), 3u);
  EXPECT_EQ(world.zones()[1].rule, ZoneRule(KeepOut{{"truck", "van"}}));
  EXPECT_EQ(world.zones()[2].rule, ZoneRule(SpeedLimit{2.0}));
  EXPECT_EQ(world.zones()[2].name, "school");
  EXPECT_EQ(world.obstacle_count(), 1u);
  EXPECT_TRUE(World({}).zones().empty());
  EXPECT_TRUE(world.with_zones({}).zones().empty());
}

TEST(WorldZones, KeepOutsAreObstaclesOfTheVehiclesTheyAreFor) {
  const World world = yard();
  const World anyones = world.for_vehicle(Vehicle{}), trucks = world.for_vehicle(named("truck"));
  ASSERT_EQ(anyones.obstacle_count(), 2u);
  EXPECT_EQ(anyones.keep_out_of(0), kNone);
  EXPECT_EQ(anyones.keep_out_of(1), 0u);
  EXPECT_EQ(anyones.keep_out_of(2), kNone);  // the bounds
  EXPECT_EQ(anyones.box_of(1).min, Vec2(10, 0));
  ASSERT_EQ(trucks.obstacle_count(), 3u);
  EXPECT_EQ(trucks.keep_out_of(2), 1u);
  EXPECT_EQ(trucks.zones().size(), 3u);
  EXPECT_EQ(world.obstacle_count(), 1u);
}

TEST(WorldZones, AWorldForOneVehicleIsMadeForAnother) {
  const World trucks = yard().for_vehicle(named("truck"));
  EXPECT_EQ(trucks.for_vehicle(named("truck")).vertices().data(), trucks.vertices().data());
  EXPECT_EQ(trucks.for_vehicle(named("van")).vertices().data(), trucks.vertices().data());
  const World cars = trucks.for_vehicle(named("car"));
  EXPECT_EQ(cars.obstacle_count(), 2u);
  EXPECT_EQ(cars.for_vehicle(named("truck")).keep_out_of(2), 1u);
  EXPECT_EQ(trucks.with_zones({}).obstacle_count(), 1u);
}

TEST(WorldZones, StayWhenTheMapChanges) {
  const World before = yard().for_vehicle(named("truck"));
  const std::vector<ObstacleId> wall{0};
  const World after = before.changed(wall, {{{{-9, -9}, {-8, -9}, {-8, -8}}, {}}});
  ASSERT_EQ(after.obstacle_count(), 3u);
  EXPECT_EQ(after.keep_out_of(0), 0u);
  EXPECT_EQ(after.keep_out_of(1), 1u);
  EXPECT_EQ(after.keep_out_of(2), kNone);
  EXPECT_EQ(after.zones().size(), 3u);
  EXPECT_EQ(after.for_vehicle(named("truck")).vertices().data(), after.vertices().data());
  EXPECT_EQ(WorldChange(before, after, wall).added_vertices.front().last, 11u);
}

TEST(WorldZones, AKeepOutGoesWithItsObstacle) {
  const World before = yard().for_vehicle(named("truck"));
  const std::vector<ObstacleId> dock{1};
  const World after = before.changed(dock, {});
  ASSERT_EQ(after.zones().size(), 2u);
  EXPECT_EQ(after.zones()[1].name, "school");
  EXPECT_EQ(after.keep_out_of(0), kNone);
  EXPECT_EQ(after.keep_out_of(1), 0u);
  EXPECT_EQ(after.for_vehicle(named("truck")).obstacle_count(), 2u);
}

// What takes a place is an obstacle of the map, and keep-outs follow all of these.
TEST(WorldZones, NothingTakesThePlaceOfAKeepOut) {
  const World before = yard().for_vehicle(named("truck"));
  const World after = before.changed(std::vector<ObstacleId>{0, 1}, {box(-9, -9, -8, -8), box(-7, -9, -6, -8)});
  ASSERT_EQ(after.obstacle_count(), 3u);
  EXPECT_EQ(after.vertex(0), Vec2(-9, -9));
  EXPECT_EQ(after.keep_out_of(0), kNone);
  EXPECT_EQ(after.keep_out_of(1), 0u);
  EXPECT_EQ(after.keep_out_of(2), kNone);
  EXPECT_EQ(after.zones().size(), 2u);
}

TEST(WorldZones, SurviveSnapshots) {
  const World world = yard().for_vehicle(named("van"));
  const World back = World::from_snapshot(world.snapshot());
  ASSERT_EQ(back.zones().size(), 3u);
  EXPECT_EQ(back.zones()[2].rule, ZoneRule(SpeedLimit{2.0}));
  for (ObstacleId o = 0; o < world.region_count(); ++o) EXPECT_EQ(back.keep_out_of(o), world.keep_out_of(o));
  WorldSnapshot wrong = world.snapshot();
  wrong.keep_outs[2] = 0;
  EXPECT_THROW(World::from_snapshot(wrong), SnapshotError);
  wrong = world.snapshot();
  wrong.keep_outs[0] = 3;  // the bounds
  EXPECT_THROW(World::from_snapshot(wrong), SnapshotError);
  wrong = world.snapshot();
  wrong.keep_outs.pop_back();
  EXPECT_THROW(World::from_snapshot(wrong), SnapshotError);
}

TEST(WorldZones, WrongOnesAreRefusedByNameValueAndLimit) {
  const Polygon area = box(0, 0, 1, 1);
  EXPECT_EQ(error_of({{area, SpeedLimit{1e-50}}, {area, SpeedLimit{1e50}}}), "");
  EXPECT_EQ(error_of({{area, KeepOut{}}, {area, SpeedLimit{0.0}, "yard"}}),
            "1; speed_limit zone \"yard\": max_speed is 0 m/s, must be from 1e-50 to 1e+50; a zone to stay out of is a "
            "keepout");
  EXPECT_EQ(error_of({{area, SpeedLimit{-2.0}}}),
            "0; zone 0 (speed_limit): max_speed is -2 m/s, must be from 1e-50 to 1e+50");
  EXPECT_NE(error_of({{area, SpeedLimit{std::numeric_limits<double>::quiet_NaN()}}}).find("max_speed is nan"),
            std::string::npos);
  EXPECT_NE(error_of({{area, SpeedLimit{INFINITY}}}).find("max_speed is inf"), std::string::npos);
  EXPECT_EQ(error_of({{area, OneWay{-kTwoPi, 0.0}}, {area, OneWay{kTwoPi, kPi}}}), "");
  EXPECT_EQ(error_of({{area, OneWay{90.0, 0.2}, "aisle"}}),
            "0; one_way zone \"aisle\": heading is 90 rad, must be from -2 pi to 2 pi; if 90 is in degrees, write "
            "1.5707963267948966");
  EXPECT_NE(
      error_of({{area, OneWay{0.0, 10.0}}}).find("tolerance is 10 rad, must be from 0 to pi; if 10 is in degrees"),
      std::string::npos);
  EXPECT_EQ(error_of({{area, OneWay{0.0, -INFINITY}}}),
            "0; zone 0 (one_way): tolerance is -inf rad, must be from 0 to pi");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_of({{area, OneWay{nan, 0.0}}}),
            "0; zone 0 (one_way): heading is nan rad, must be from -2 pi to 2 pi");
  EXPECT_NE(error_of({{area, OneWay{0.0, nan}}}).find("tolerance is nan rad, must be from 0 to pi"), std::string::npos);
  EXPECT_EQ(error_of({{area, KeepClear{1e-9, 0.0}}, {area, KeepClear{1e6, 1e6}}}), "");
  EXPECT_EQ(error_of({{area, KeepClear{0.0, 1.0}, "hall"}}),
            "0; clearance zone \"hall\": distance is 0 m, must be above 0 and at most 1e+06; leave the zone out");
  EXPECT_NE(error_of({{area, KeepClear{nan, 1.0}}}).find("distance is nan m, must be above 0"), std::string::npos);
  EXPECT_NE(error_of({{area, KeepClear{2e6, 1.0}}}).find("distance is 2e+06 m, must be above 0"), std::string::npos);
  EXPECT_EQ(error_of({{area, KeepClear{0.5, -1.0}}}), "0; zone 0 (clearance): cost is -1 s/m, must be from 0 to 1e+06");
  EXPECT_NE(error_of({{area, KeepClear{0.5, INFINITY}}}).find("cost is inf s/m"), std::string::npos);
  EXPECT_NE(error_of({{area, KeepOut{{"van", ""}}}}).find("a name of \"vehicles\" is empty"), std::string::npos);
  EXPECT_EQ(error_of({{{{{0, 0}, {1, 0}}, {}}, KeepOut{}, "stub"}}),
            "0; keepout zone \"stub\", ring 0: a ring needs at least 3 vertices, this one has 2");
  EXPECT_NE(error_of({{{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}, KeepOut{}}}).find("zone 0 (keepout), ring 0: edges 0"),
            std::string::npos);
}

}  // namespace
}  // namespace arcway::internal

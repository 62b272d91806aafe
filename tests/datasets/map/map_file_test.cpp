#include "arcway/datasets/map_file.h"

#include <gtest/gtest.h>

#include "arcway/datasets/repair.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

TEST(MapFile, WorldErrorsAreTranslatedToPlaces) {
  MapFile map;
  map.obstacles = {{test::square(0, 0, 4), {}}, {{{0, 0}, {5, 5}, {5, 0}, {0, 5}}, {}}};
  map.places = {"feature 1", "feature 2"};
  try {
    to_world(map, "world.geojson");
    FAIL();
  } catch (const FormatError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("world.geojson: feature 2: ", 0), 0u) << error.what();
  }
}

TEST(MapFile, NamesTheRepairOfRingsThatAreRefused) {
  if (!can_repair()) GTEST_SKIP() << "built without GEOS";
  const auto refusal = [](const Ring& ring) {
    MapFile map;
    map.obstacles = {{ring, {}}};
    try {
      to_world(map, "yard.wkt");
    } catch (const FormatError& error) {
      return std::string(error.what());
    }
    return std::string("taken");
  };
  const std::string repair = "arcway doctor yard.wkt --repair";
  EXPECT_NE(refusal({{0, 0}, {10, 10}, {10, 0}, {0, 12}}).find(repair), std::string::npos);
  for (const Ring& flat : {Ring{{0, 0}, {10, 10}, {5, 5}}, Ring{{0, 0}, {10, 10}}}) {
    EXPECT_NE(refusal(flat).find(repair), std::string::npos);
    EXPECT_NE(refusal(flat).find("--wall-width"), std::string::npos);
  }
  EXPECT_EQ(refusal({{0, 0}, {1e300, 0}, {0, 1}}).find("--repair"), std::string::npos);
}

TEST(MapFile, NamesTheRepairOfZonesWhoseRingsAreRefused) {
  if (!can_repair()) GTEST_SKIP() << "built without GEOS";
  const auto refusal = [](const Ring& ring, double heading) {
    MapFile map;
    map.zones = {{{ring, {}}, OneWay{heading, 0.5}, "lane"}};
    try {
      to_world(map, "yard.geojson");
    } catch (const FormatError& error) {
      return std::string(error.what());
    }
    return std::string("taken");
  };
  EXPECT_NE(refusal({{0, 0}, {10, 10}, {10, 0}, {0, 12}}, 0.0).find("--repair"), std::string::npos);
  const std::string rule = refusal(test::square(0, 0, 4), 90.0);
  EXPECT_NE(rule.find("if 90 is in degrees"), std::string::npos) << rule;
  EXPECT_EQ(rule.find("--repair"), std::string::npos) << rule;
}

TEST(MapFile, WorldGivesItsPolygonsBack) {
  MapFile map;
  map.obstacles = {{{{0, 0}, {0, 9}, {9, 9}, {9, 0}}, {{{2, 5}, {2, 6}, {3, 6}}}}, {test::square(20, 0, 1), {}}};
  map.bounds = test::square(-5, -5, 35);
  const MapFile back = to_map_file(to_world(map, "w"));
  ASSERT_EQ(back.obstacles.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back.obstacles[i].outer, map.obstacles[i].outer);
    EXPECT_EQ(back.obstacles[i].holes, map.obstacles[i].holes);
  }
  EXPECT_EQ(back.bounds, map.bounds);
}

TEST(MapFile, ZonesComeBackAndTheirObstaclesDoNot) {
  MapFile map;
  map.obstacles = {{{{0, 0}, {1, 0}, {1, 1}}, {}}};
  map.zones = {{{{{5, 5}, {6, 5}, {6, 6}}, {}}, KeepOut{}, "dock"}};
  const World world = to_world(map, "w");
  EXPECT_EQ(world.zones().size(), 1u);
  const MapFile back = to_map_file(world.for_vehicle(Vehicle{}));
  EXPECT_EQ(back.obstacles.size(), 1u);
  EXPECT_EQ(back.zones.size(), 1u);
}

}  // namespace
}  // namespace arcway::internal

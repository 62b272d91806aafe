#include "arcway/datasets/wkt.h"

#include <gtest/gtest.h>

#include "arcway/datasets/repair.h"
#include "arcway/polygon.h"
#include "tests/support/format_errors.h"

namespace arcway::internal {
namespace {

MapFile wkt_of(const std::string& text, const VectorOptions& options = {}) {
  return read_wkt(text, "map.wkt", options);
}

std::string wkt_error(const std::string& text) {
  return test::format_error_of([&] { wkt_of(text); });
}

TEST(Wkt, ReadsAllShapesOfPolygons) {
  const Ring triangle{{0, 0}, {4, 0}, {4, 4}};
  for (const char* text : {
           "POLYGON((0 0,4 0,4 4,0 0))",
           "\xEF\xBB\xBFpolygon ( ( 0 0 , 4 0 , 4 4 , 0 0 ) )\r\n\r\n",
           "Polygon Z ((0 0 7, 4 0 7, 4 4 8, 0 0 7))",
           "POLYGON Z ((0 0 nan, 4 0 NaN, 4 4 -nan, 0 0 NAN))",
           "POLYGON ZM ((0 0 7 inf,4 0 NULL 2,4 4 8 -Infinity,0 0 7 nan))",
           "POLYGON M((0 0 nan,4 0 nan,4 4 nan,0 0 nan))",
           "POLYGON ZM ((0 0 7 1, 4 0 7 1, 4 4 8 1, 0 0 7 1))",
           "SRID=25832;POLYGON ((0 0, 4 0,\n 4 4, 4 4, 0 0));",
           "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 0)))",
           "MULTIPOLYGONZ (((0 0 7, 4 0 7, 4 4 8, 0 0 7)))",
           "GEOMETRYCOLLECTIONZM (POLYGONZM ((0 0 7 1, 4 0 7 1, 4 4 8 1, 0 0 7 1)))",
           "POLYGON EMPTY\nGEOMETRYCOLLECTION (MULTIPOLYGON EMPTY, GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 4, 0 "
           "0))))",
       }) {
    const MapFile map = wkt_of(text);
    ASSERT_EQ(map.obstacles.size(), 1u) << text;
    EXPECT_EQ(map.obstacles[0].outer, triangle) << text;
    EXPECT_TRUE(map.obstacles[0].holes.empty());
    EXPECT_TRUE(map.warnings.empty()) << map.warnings.front();
  }
}

TEST(Wkt, KeepsHolesAndPlaces) {
  const MapFile map = wkt_of(
      "POLYGON ((0 0, 9 0, 9 9, 0 0), (5 1, 6 1, 6 2, 5 1))\n"
      "MULTIPOLYGON (((20 0, 21 0, 21 1, 20 0)), ((30 0, 31 0, 31 1, 30 0)))\n");
  ASSERT_EQ(map.obstacles.size(), 3u);
  EXPECT_EQ(map.obstacles[0].holes, (std::vector<Ring>{{{5, 1}, {6, 1}, {6, 2}}}));
  EXPECT_EQ(map.places, (std::vector<std::string>{"line 1", "line 2, polygon 0", "line 2, polygon 1"}));
}

TEST(Wkt, LineStringsAreWallsWhenAsked) {
  const std::string text = "LINESTRING (0 0, 10 0, 10 5)\nPOINT (3 4)\nMULTIPOINT ((1 2), (3 4))\n";
  const MapFile without = wkt_of(text + "POLYGON ((0 0, 9 0, 9 9, 0 0))\n");
  EXPECT_EQ(without.obstacles.size(), 1u);
  ASSERT_EQ(without.warnings.size(), 1u);
  EXPECT_NE(without.warnings[0].find("3 geometries"), std::string::npos);
  const MapFile walls = wkt_of(text, {.wall_width = 2.0});
  ASSERT_EQ(walls.obstacles.size(), 2u);
  EXPECT_EQ(walls.obstacles[0].outer, (Ring{{-1, -1}, {11, -1}, {11, 1}, {-1, 1}}));
}

TEST(Wkt, PolygonsAreFreeSpaceWhenAsked) {
  const VectorOptions free{.free_polygons = true};
  const std::string hall = "POLYGON ((0 0, 20 0, 20 10, 0 10, 0 0), (9 1, 11 1, 11 6, 9 6, 9 1))";
  const MapFile one = wkt_of("GEOMETRYCOLLECTION (" + hall + ")", free);
  EXPECT_EQ(one.bounds, (Ring{{0, 0}, {20, 0}, {20, 10}, {0, 10}}));
  ASSERT_EQ(one.obstacles.size(), 1u);
  EXPECT_EQ(one.obstacles[0].outer, (Ring{{9, 1}, {11, 1}, {11, 6}, {9, 6}}));

  // Where a point is free: in one of the rooms and not on the island in the first.
  const auto is_free = [](const World& world, const Vec2& p) {
    for (ObstacleId o = 0; o < world.region_count(); ++o)
      if (world.locate(p, o) != PointLocation::kOutside) return false;
    return true;
  };
  const World apart = to_world(wkt_of(hall + "\nPOLYGON ((30 0, 40 0, 40 10, 30 10, 30 0))", free), "apart");
  EXPECT_TRUE(apart.has_bounds());
  for (const Vec2& p : {Vec2(1, 1), Vec2(35, 5), Vec2(10, 8)}) EXPECT_TRUE(is_free(apart, p)) << p;
  for (const Vec2& p : {Vec2(25, 5), Vec2(10, 3), Vec2(-0.5, 5), Vec2(41.5, 5), Vec2(60, 60)})
    EXPECT_FALSE(is_free(apart, p)) << p;
  if (can_repair()) {  // rooms that share a wall are one
    const MapFile joined = wkt_of(hall + "\nPOLYGON ((20 0, 30 0, 30 10, 20 10, 20 0))", free);
    ASSERT_TRUE(joined.bounds);
    EXPECT_EQ(joined.bounds->size(), 4u);
    EXPECT_EQ(joined.obstacles.size(), 1u);
  }
  EXPECT_NE(test::format_error_of([&] { wkt_of("POINT (1 2)", free); }).find("no polygons"), std::string::npos);
  EXPECT_THROW(wkt_of("POLYGON EMPTY", free), FormatError);
}

TEST(Wkt, ProjectsDegrees) {
  const std::string text = "SRID=4326;POLYGON ((8 48, 8.01 48, 8.01 48.01, 8 48.01, 8 48))";
  EXPECT_EQ(wkt_of(text).warnings.size(), 1u);
  const MapFile map = wkt_of(text, {.lonlat = true});
  EXPECT_TRUE(map.warnings.empty());
  const Vec2 diagonal = map.obstacles[0].outer[2] - map.obstacles[0].outer[0];
  EXPECT_NEAR(diagonal.norm(), 1339.073432, 1e-4);  // Vincenty
  EXPECT_NEAR((map.obstacles[0].outer[1] - map.obstacles[0].outer[0]).norm(), 746.253535, 1e-4);
  EXPECT_NEAR((map.obstacles[0].outer[3] - map.obstacles[0].outer[0]).norm(), 1111.904199, 1e-4);
  EXPECT_NEAR((map.obstacles[0].outer[2] + map.obstacles[0].outer[0]).norm(), 0.0, 0.1);  // around the middle
}

TEST(Wkt, ErrorsNameLineAndValue) {
  EXPECT_EQ(wkt_error("POLYGON ((0 0, 1 0, 1 1, 0 0))\nCIRCLE (1 2)"),
            "map.wkt: line 2: expected a geometry as POLYGON or MULTIPOLYGON, found \"CIRCLE\"");
  EXPECT_EQ(wkt_error("POLYGON ((0 0,\n1 x, 1 1, 0 0))"), "map.wkt: line 2: expected a number, found \"x,\"");
  EXPECT_EQ(wkt_error("POLYGON ((0 0, 1 nan, 1 1, 0 0))"), "map.wkt: line 1: expected a number, found \"nan,\"");
  EXPECT_EQ(wkt_error("POLYGON ((0 0, 1 0, 1 1"),
            "map.wkt: line 1: expected a number, \",\" or \")\", found the end of the file");
  EXPECT_EQ(wkt_error("POLYGON ((0 0, 1 0, 0 0))"),
            "map.wkt: line 1, ring 0: needs at least 3 different positions, found 2 in 3 positions");
  std::string deep;
  for (int i = 0; i < 10000; ++i) deep += "GEOMETRYCOLLECTION(";
  EXPECT_NE(wkt_error(deep).find("nested more than"), std::string::npos);
}

TEST(Wkt, RoundTripIsExact) {
  MapFile map;
  map.obstacles = {{{{0.1, 1.0 / 3.0}, {1e22, -1e-99}, {-0.0, 9007199254740993.0}}, {}},
                   {{{0, 0}, {100, 0}, {0, 100}}, {{{1, 1}, {1, 2.5}, {2, 1}}}}};
  const std::string text = to_wkt(map);
  const MapFile back = wkt_of(text);
  ASSERT_EQ(back.obstacles.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back.obstacles[i].outer, map.obstacles[i].outer);
    EXPECT_EQ(back.obstacles[i].holes, map.obstacles[i].holes);
  }
  EXPECT_EQ(to_wkt(back), text);
  EXPECT_TRUE(wkt_of(to_wkt({})).obstacles.empty());
}

}  // namespace
}  // namespace arcway::internal

#include "arcway/datasets/geojson.h"

#include <gtest/gtest.h>

#include <cmath>

#include "arcway/closed_spline.h"
#include "arcway/datasets/map_file.h"
#include "arcway/polygon.h"
#include "arcway/zone.h"
#include "core/geometry/predicates.h"
#include "tests/support/format_errors.h"

namespace arcway::internal {
namespace {

constexpr const char* kSquare = "[[0,0],[4,0],[4,4],[0,4],[0,0]]";

MapFile geojson_of(const std::string& text) { return read_geojson(text, "world.geojson"); }

std::string polygon(const std::string& rings) { return R"({"type":"Polygon","coordinates":[)" + rings + "]}"; }
std::string feature(const std::string& geometry, const std::string& properties = "null") {
  return R"({"type":"Feature","properties":)" + properties + R"(,"geometry":)" + geometry + "}";
}
std::string collection(const std::string& features, const std::string& members = "") {
  return R"({"type":"FeatureCollection",)" + members + R"("features":[)" + features + "]}";
}

std::string geojson_error(const std::string& text) {
  return test::format_error_of([&] { geojson_of(text); });
}

TEST(GeoJson, ReadsEveryTopLevelShape) {
  const std::string square = polygon(kSquare);
  for (const std::string& text : {square, feature(square), collection(feature(square)),
                                  R"({"type":"GeometryCollection","geometries":[)" + square + "]}",
                                  "\xEF\xBB\xBF" + collection(feature(square)) + "\r\n\r\n",
                                  feature(square) + "\n" + feature("null") + "\n", "\x1E" + feature(square) + "\n"}) {
    const MapFile map = geojson_of(text);
    ASSERT_EQ(map.obstacles.size(), 1u) << text;
    EXPECT_EQ(map.obstacles[0].outer, (Ring{{0, 0}, {4, 0}, {4, 4}, {0, 4}})) << text;
    EXPECT_TRUE(map.warnings.empty()) << map.warnings.front();
  }
}

TEST(GeoJson, KeepsHolesOrderAndPlaces) {
  const MapFile map = geojson_of(collection(
      feature("null") + "," +
      feature(
          R"({"type":"MultiPolygon","coordinates":[[[[0,0],[0,9],[9,9,7],[9,9],[0,0]],[[2,5],[2,6],[3,6],[2,5]]],[[[20,0],[21,0],[21,1],[20,0]]]]})") +
      "," + feature(R"({"type":"Polygon","coordinates":[]})")));
  ASSERT_EQ(map.obstacles.size(), 2u);
  EXPECT_EQ(map.obstacles[0].outer, (Ring{{0, 0}, {0, 9}, {9, 9}}));
  ASSERT_EQ(map.obstacles[0].holes.size(), 1u);
  EXPECT_EQ(map.obstacles[0].holes[0].size(), 3u);
  EXPECT_EQ(map.places, (std::vector<std::string>{"feature 1, polygon 0", "feature 1, polygon 1"}));
}

TEST(GeoJson, IgnoresHeightsThatAreMissing) {
  for (const char* ring :
       {"[[0,0,null],[4,0,null],[4,4,null],[0,0,null]]", "[[0,0,NaN],[4,0,-Infinity],[4,4,1],[0,0,NaN]]",
        "[[0,0,\"n/a\"],[4,0,1,NaN],[4,4],[0,0, NaN ]]"}) {
    const MapFile map = geojson_of(polygon(ring));
    ASSERT_EQ(map.obstacles.size(), 1u) << ring;
    EXPECT_EQ(map.obstacles[0].outer, (Ring{{0, 0}, {4, 0}, {4, 4}})) << ring;
  }
  EXPECT_NE(geojson_error(polygon("[[0,0,NaN],[4,NaN,0],[4,4],[0,0]]")).find("found NaN"), std::string::npos);
  EXPECT_NE(geojson_error(collection("", R"("properties":{"start":[1,2,NaN]},)")).find("expected a number, found null"),
            std::string::npos);
}

TEST(GeoJson, ReadsRoles) {
  const MapFile map = geojson_of(collection(
      feature(polygon("[[0,0],[90,0],[90,90],[0,90],[0,0]],[[5,5],[5,6],[6,6],[5,5]]"), R"({"role":"boundary"})") +
      "," + feature(R"({"type":"Point","coordinates":[1,2]})", R"({"role":"start","heading":3})") + "," +
      feature(R"({"type":"Point","coordinates":[7,8]})", R"({"role":"goal","heading":-1})")));
  ASSERT_TRUE(map.bounds);
  EXPECT_EQ(map.bounds->size(), 4u);
  EXPECT_EQ(map.obstacles.size(), 1u);
  EXPECT_EQ(map.places.at(0), "feature 0, ring 1");
  ASSERT_TRUE(map.start && map.goal);
  EXPECT_EQ(map.start->heading, 3.0);
  EXPECT_EQ(map.goal->y, 8.0);
}

TEST(GeoJson, ReadsTopLevelProperties) {
  const MapFile map = geojson_of(
      collection("", R"("bbox":[0,0,1,1],"properties":{"bounds":[0,1,20,30],"start":[1,2,3],"goal":[4,5,6]},)"));
  EXPECT_EQ(map.bounds, (Ring{{0, 1}, {20, 1}, {20, 30}, {0, 30}}));
  EXPECT_EQ(map.start->y, 2.0);
  EXPECT_EQ(map.goal->heading, 6.0);
  EXPECT_FALSE(geojson_of(collection("", R"("bbox":[0,0,1,1],"properties":null,)")).bounds);
}

TEST(GeoJson, CollectionsMayBeNestedThirtyTwoDeep) {
  const auto nested = [](int depth) {
    std::string text = R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]})";
    for (; depth > 0; --depth) text = R"({"type":"GeometryCollection","geometries":[)" + text + "]}";
    return text;
  };
  EXPECT_EQ(read_geojson(nested(32), "w").obstacles.size(), 1u);
  EXPECT_NE(geojson_error(nested(33)).find("geometry collections nested more than 32 deep"), std::string::npos)
      << geojson_error(nested(33));
}

TEST(GeoJson, ErrorsNamePlaceAndValue) {
  const auto third = [](const std::string& ring) {
    return collection(feature("null") + "," + feature("null") + "," + feature(polygon(ring)));
  };
  EXPECT_EQ(geojson_error(third("[[0,0],[1,null],[2,2],[0,0]]")),
            "world.geojson: feature 2, ring 0, position 1: expected a number, found null");
  EXPECT_EQ(geojson_error(third("[[0,0],[1],[2,2],[0,0]]")),
            "world.geojson: feature 2, ring 0, position 1: expected a position [x, y], found [1]");
  EXPECT_EQ(geojson_error(third("[[0,0],[1,1],[0,0]]")),
            "world.geojson: feature 2, ring 0: needs at least 3 different positions, found 2 in 3 positions");
  EXPECT_EQ(geojson_error(""), "world.geojson: empty file, expected JSON");
  EXPECT_EQ(geojson_error("[]"), "world.geojson: expected an object, found []");
  EXPECT_EQ(geojson_error("{}"), "world.geojson: missing key \"type\"");
  EXPECT_EQ(geojson_error(R"({"type":"Circle","coordinates":[1]})"),
            "world.geojson: geometry: unknown geometry type \"Circle\"");
  EXPECT_EQ(geojson_error(R"({"type":"Feature\u001b","x":1})"),
            R"(world.geojson: geometry: unknown geometry type "Feature\u001b")");
  EXPECT_LT(geojson_error(R"({"type":")" + std::string(100000, 'x') + R"("})").size(), 200u);
  EXPECT_NE(
      geojson_error("{\"type\":\n\"Polygon\",\n\"coordinates\":[[[0,NaN],[1,1],[2,3]]]}").find("line 3: found NaN"),
      std::string::npos);
  EXPECT_NE(geojson_error("{\"type\":\n\"Polygon\",\n}").find("world.geojson: line 3: syntax error"), std::string::npos)
      << geojson_error("{\"type\":\n\"Polygon\",\n}");
  EXPECT_NE(geojson_error(polygon("[[0,0],[1,1e999],[2,2],[0,0]]")).find("1e999"), std::string::npos);
  EXPECT_NE(geojson_error(feature("null") + "\n{]\n").find("line 2"), std::string::npos);
  EXPECT_NE(geojson_error(collection("", R"("properties":{"bounds":[0,0,-1,1]},)")).find("xmin < xmax"),
            std::string::npos);
  const std::string start = feature(R"({"type":"Point","coordinates":[1,2]})", R"({"role":"start","heading":0})");
  EXPECT_EQ(geojson_error(collection(start + "," + start)), "world.geojson: feature 1: second start");
  std::string deep;
  for (int i = 0; i < 5000; ++i) deep += R"({"type":"GeometryCollection","geometries":[)";
  EXPECT_NE(geojson_error(deep + std::string(5000, ' ')).find("line 1"), std::string::npos);
  for (int i = 0; i < 5000; ++i) deep += "]}";
  EXPECT_NE(geojson_error(deep).find("nested"), std::string::npos);
}

TEST(GeoJson, WarnsOfDegreesAndOtherGeometries) {
  EXPECT_EQ(geojson_of(polygon("[[8.1,48.2],[8.2,48.2],[8.2,48.3],[8.1,48.2]]")).warnings.size(), 1u);
  EXPECT_EQ(geojson_of(polygon("[[0,0],[4,0],[4,4],[0,4]]")).warnings.size(), 1u);
  const std::string line = feature(R"({"type":"LineString","coordinates":[[0,0],[1,1]]})");
  const MapFile map = geojson_of(collection(line + "," + feature(polygon("[[0,0],[4,0],[4,4],[0,4],[0,0]]"))));
  ASSERT_EQ(map.warnings.size(), 1u);
  EXPECT_NE(map.warnings[0].find("feature 0 (LineString); with a wall width"), std::string::npos) << map.warnings[0];
  // Nothing would be left.
  EXPECT_NE(test::format_error_of([&] { (void)geojson_of(collection(line)); }).find("no polygons, but 1 geometry"),
            std::string::npos);
}

TEST(GeoJson, OfRepeatedKeysTheLastOneCounts) {
  const std::string square = feature(polygon(kSquare));
  const MapFile map = geojson_of(R"({"type":"Feature","features":[)" + square + "," + square +
                                 R"(],"type":"FeatureCollection","features":[)" + square + "]}");
  EXPECT_EQ(map.obstacles.size(), 1u);
  EXPECT_EQ(map.places.at(0), "feature 0");
  EXPECT_EQ(geojson_of(R"({"type":"Point","coordinates":[1,2],"type":"Polygon","coordinates":[)" +
                       std::string(kSquare) + "]}")
                .obstacles.size(),
            1u);
}

TEST(GeoJson, MembersComeInAnyOrder) {
  const MapFile map = geojson_of(R"({"features":[{"geometry":{"coordinates":[)" + std::string(kSquare) +
                                 R"(],"type":"Polygon"},"type":"Feature"}],"properties":{"bounds":[-9,-9,9,9]},)"
                                 R"("type":"FeatureCollection"})");
  EXPECT_EQ(map.obstacles.size(), 1u);
  EXPECT_TRUE(map.bounds);
  // A member of that name may be anything in other documents.
  EXPECT_EQ(
      geojson_of(R"({"type":"Polygon","features":7,"coordinates":[)" + std::string(kSquare) + "]}").obstacles.size(),
      1u);
}

TEST(GeoJson, AnOldReferenceSystemSaysWhatCoordinatesAre) {
  const auto crs = [](const std::string& name) {
    return R"("crs":{"type":"name","properties":{"name":")" + name + "\"}},";
  };
  const std::string small = feature(polygon("[[8.1,48.2],[8.2,48.2],[8.2,48.3],[8.1,48.2]]"));
  EXPECT_TRUE(geojson_of(collection(small, crs("urn:ogc:def:crs:EPSG::25832"))).warnings.empty());
  EXPECT_EQ(geojson_of(collection(small, R"("crs":null,)")).warnings.size(), 1u);
  const std::string large = feature(polygon("[[8,48],[12,48],[12,50],[8,48]]"));
  const auto warning = [&](const std::string& member) {
    const MapFile map = geojson_of(collection(large, member));
    return map.warnings.size() == 1 ? map.warnings[0] : std::to_string(map.warnings.size()) + " warnings";
  };
  for (const std::string& member :
       {crs("urn:ogc:def:crs:OGC:1.3:CRS84"), crs("urn:ogc:def:crs:EPSG::4269"), crs("NAD83"),
        std::string(R"("crs":{"type":"EPSG","properties":{"code":4258}},)"), std::string(R"("crs":"EPSG:4326",)"),
        std::string(R"("coordRefSys":"http://www.opengis.net/def/crs/EPSG/0/4283",)"),
        std::string(R"("crs":{"type":"GeographicCRS","id":{"authority":"EPSG","code":4979}},)")})
    EXPECT_NE(warning(member).find("coordinates are degrees of longitude and latitude"), std::string::npos) << member;
  EXPECT_NE(warning(crs("EPSG:3857")).find("units, which are taken as meters"), std::string::npos);
  EXPECT_NE(warning(crs("EPSG:2263")).find("coordinates are not in meters (\"EPSG:2263\")"), std::string::npos);
  EXPECT_NE(warning(crs("hall 7")).find("the coordinate system (\"hall 7\") is not known here"), std::string::npos);
  EXPECT_NE(geojson_error(collection(large, crs("EPSG:4978"))).find("positions in space (\"EPSG:4978\")"),
            std::string::npos);
  EXPECT_TRUE(read_geojson(collection(large, crs("NAD83")), "w", {.planar = true}).warnings.empty());
  // As PostGIS writes it.
  const std::string inside =
      R"({"type":"Polygon",)" + crs("EPSG:4326") + R"("coordinates":[[[8,48],[12,48],[12,50],[8,48]]]})";
  const MapFile in_geometry = geojson_of(collection(feature(inside)));
  ASSERT_EQ(in_geometry.warnings.size(), 1u);
  EXPECT_NE(in_geometry.warnings[0].find("coordinates are degrees"), std::string::npos);
  EXPECT_THROW(read_geojson(collection(large, crs("EPSG:25832")), "w", {.lonlat = true}), FormatError);
}

TEST(GeoJson, ReadsMapsAcrossTheAntimeridianAndOfWebMercator) {
  const auto box = [](const std::string& west, const std::string& east, const std::string& south,
                      const std::string& north) {
    return feature(polygon("[[" + west + "," + south + "],[" + east + "," + south + "],[" + east + "," + north + "],[" +
                           west + "," + north + "],[" + west + "," + south + "]]"));
  };
  const auto width = [](const std::string& features, const std::string& members = "") {
    const MapFile map = read_geojson(collection(features, members), "w", {.lonlat = true});
    EXPECT_TRUE(map.warnings.empty());
    Box all;
    for (const Polygon& polygon : map.obstacles)
      for (const Vec2& p : polygon.outer) all.extend(p);
    EXPECT_NEAR(all.min.x(), -all.max.x(), 1e-3);
    return all.max.x() - all.min.x();
  };
  const double expected =
      width(box("9.999", "9.9995", "-17", "-16.9995") + "," + box("10.0005", "10.001", "-17", "-16.9995"));
  EXPECT_NEAR(expected, 212.97, 0.01);
  for (const std::string& pair :
       {box("179.999", "179.9995", "-17", "-16.9995") + "," + box("-179.9995", "-179.999", "-17", "-16.9995"),
        box("179.999", "179.9995", "-17", "-16.9995") + "," + box("180.0005", "180.001", "-17", "-16.9995"),
        box("359.999", "359.9995", "-17", "-16.9995") + "," + box("0.0005", "0.001", "-17", "-16.9995")})
    EXPECT_NEAR(width(pair), expected, 1e-6) << pair;
  // 10 units of Web Mercator at a latitude of 52.516 degrees, where 1 is 1 / 1.6432 m, by the ellipsoid a little more.
  EXPECT_NEAR(width(box("1492000", "1492010", "6894000", "6894010"),
                    R"("crs":{"type":"name","properties":{"name":"EPSG:3857"}},)"),
              10 / 1.643285 * 1.002114, 1e-3);
  // Around the pole no longitude is the middle one.
  const MapFile pole = read_geojson(feature(polygon("[[-90,89.99],[0,89.99],[90,89.99],[179,89.99],[-90,89.99]]")), "w",
                                    {.lonlat = true});
  EXPECT_NEAR(pole.obstacles[0].outer[0].x(), -1116.9398, 1e-3);
  EXPECT_NEAR(pole.obstacles[0].outer[1].y(), -1116.9398, 1e-3);
  // Bounds from the west to the east.
  const MapFile bounded = read_geojson(collection(box("179.999", "179.9995", "-17", "-16.9995"),
                                                  R"("properties":{"bounds":[179.99,-17.01,-179.99,-16.99]},)"),
                                       "w", {.lonlat = true});
  EXPECT_NEAR((*bounded.bounds)[1].x() - (*bounded.bounds)[0].x(), 2129.7, 0.5);
  // Wide maps say how exact they are, and what no plane shows is refused.
  EXPECT_EQ(read_geojson(box("10", "12", "50", "51"), "w", {.lonlat = true}).warnings.size(), 1u);
  EXPECT_THROW(read_geojson(feature(polygon("[[-120,-80],[0,80],[120,-80],[-120,-80]]")), "w", {.lonlat = true}),
               FormatError);
}

TEST(GeoJson, PolygonsWithoutARoleAreFreeSpaceWhenAsked) {
  const std::string hall = polygon("[[0,0],[90,0],[90,90],[0,90],[0,0]],[[5,5],[5,6],[6,6],[5,5]]");
  const std::string crate = feature(polygon("[[20,20],[30,20],[30,30],[20,20]]"), R"({"role":"obstacle"})");
  const MapFile map = read_geojson(collection(feature(hall) + "," + crate), "w", {.free_polygons = true});
  ASSERT_TRUE(map.bounds);
  EXPECT_EQ(map.bounds->size(), 4u);
  EXPECT_EQ(map.obstacles.size(), 2u);
  EXPECT_NE(test::format_error_of([&] {
              read_geojson(collection(feature(hall), R"("properties":{"bounds":[0,0,9,9]},)"), "w",
                           {.free_polygons = true});
            }).find("and there are bounds in properties.bounds"),
            std::string::npos);
}

TEST(GeoJson, WarnsOfPropertiesThatItDoesNotRead) {
  const auto map_of = [](const std::string& properties) {
    return geojson_of(collection(feature(polygon(kSquare), properties) + "," + feature(polygon(kSquare), properties)));
  };
  for (const char* key :
       {"speed", "max_speed", "maxSpeed", "speed-limit", "cost", "traversable", "walkable", "level"}) {
    const MapFile map = map_of("{\"" + std::string(key) + "\":3}");
    ASSERT_EQ(map.warnings.size(), 1u) << key;
    EXPECT_NE(map.warnings[0].find("feature 0: the property \"" + std::string(key) + "\" (and of 1 more)"),
              std::string::npos)
        << map.warnings[0];
  }
  const MapFile others = map_of(R"({"building":"yes","timestamp":9,"name":"x","id":1,"speed":null})");
  EXPECT_TRUE(others.warnings.empty());
  EXPECT_EQ(others.notes, std::vector<std::string>{"properties not read: \"building\", \"timestamp\""});
  EXPECT_NE(map_of(R"({"role":"free"})").warnings.at(0).find("here are obstacle, boundary, start, goal"),
            std::string::npos);
  EXPECT_NE(map_of(R"({"role":"boundry"})").warnings.at(0).find("unknown role \"boundry\", did you mean \"boundary\"?"),
            std::string::npos);
  EXPECT_NE(map_of(R"({"Role":"boundary"})").warnings.at(0).find("did you mean \"role\"?"), std::string::npos);
  EXPECT_NE(geojson_of(collection("", R"("properties":{"bound":[0,0,1,1]},)"))
                .warnings.at(0)
                .find("did you mean \"bounds\"?"),
            std::string::npos);
  const MapFile beside =
      geojson_of(R"({"type":"Feature","role":"boundary","properties":{},"geometry":)" + polygon(kSquare) + "}");
  EXPECT_NE(beside.warnings.at(0).find("\"role\" is not read beside \"properties\""), std::string::npos);
}

TEST(GeoJson, ProjectsDegreesAndBuildsWallsWhenAsked) {
  const MapFile map = read_geojson(collection(feature(polygon("[[8,48],[8.02,48],[8.02,48.01],[8,48]]")) + "," +
                                              feature(R"({"type":"LineString","coordinates":[[8,48],[8.02,48]]})")),
                                   "w", {.lonlat = true, .wall_width = 0.5});
  ASSERT_EQ(map.obstacles.size(), 2u);
  EXPECT_TRUE(map.warnings.empty());
  EXPECT_EQ(map.notes.size(), 1u);
  EXPECT_NEAR((map.obstacles[0].outer[2] - map.obstacles[0].outer[1]).norm(), 1111.904199, 1e-3);
  EXPECT_NEAR(map.obstacles[1].outer[2].y() - map.obstacles[1].outer[1].y(), 0.5, 1e-9);
  EXPECT_THROW(read_geojson(polygon("[[0,0],[400,0],[4,4],[0,0]]"), "w", {.lonlat = true}), FormatError);
}

TEST(GeoJson, RoundTripIsExact) {
  MapFile map;
  map.obstacles = {{{{0.1, 1.0 / 3.0}, {1e22, -1e-99}, {-0.0, 9007199254740993.0}}, {}},
                   {{{0, 0}, {100, 0}, {0, 100}}, {{{1, 1}, {1, 2.5}, {2, 1}}}}};
  map.bounds = Ring{{-5, -5}, {std::nextafter(7.0, 8.0), 0}, {0, 7}};
  map.start = Pose{0.1, 0.2, 0.3};
  map.goal = Pose{1e-300, 2, -3.14159};
  const std::string text = to_geojson(map);
  const MapFile back = geojson_of(text);
  ASSERT_EQ(back.obstacles.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back.obstacles[i].outer, map.obstacles[i].outer);
    EXPECT_EQ(back.obstacles[i].holes, map.obstacles[i].holes);
  }
  EXPECT_TRUE(std::signbit(back.obstacles[0].outer[2].x()));
  EXPECT_EQ(back.bounds, map.bounds);
  EXPECT_EQ(back.goal->x, 1e-300);
  EXPECT_EQ(back.goal->heading, -3.14159);
  EXPECT_EQ(to_geojson(back), text);
  EXPECT_TRUE(back.warnings.empty());
}

TEST(GeoJson, ReadsSplinesAsRingsThatContainThem) {
  const std::string outer = "[[0,0],[20,0],[22,15],[3,18],[0,0]]", hole = "[[6,5],[14,5],[14,11],[6,11],[6,5]]";
  const std::vector<Vec2> points{{0, 0}, {20, 0}, {22, 15}, {3, 18}}, inner{{6, 5}, {14, 5}, {14, 11}, {6, 11}};
  const ClosedSpline around(points), within(inner);
  const MapFile map = read_geojson(feature(polygon(outer + "," + hole), R"({"curve":"spline"})"), "s.geojson",
                                   {.curve_tolerance = 0.05});
  ASSERT_EQ(map.obstacles.size(), 1u);
  const Polygon& pond = map.obstacles[0];
  EXPECT_NO_THROW(to_world(map, "s.geojson"));
  EXPECT_EQ(winding(pond.outer), 1);
  ASSERT_EQ(pond.holes.size(), 1u);
  EXPECT_EQ(winding(pond.holes[0]), -1);
  for (int i = 0; i < 400; ++i) {
    EXPECT_EQ(locate(around.at(i / 100.0), pond.outer), PointLocation::kInside);
    EXPECT_EQ(locate(within.at(i / 100.0), pond.holes[0]), PointLocation::kOutside);
  }
  // The bounds block what is outside of them.
  const MapFile lake = read_geojson(feature(polygon(outer), R"({"role":"boundary","curve":"spline"})"), "b.geojson");
  ASSERT_TRUE(lake.bounds);
  for (int i = 0; i < 400; ++i) EXPECT_EQ(locate(around.at(i / 100.0), *lake.bounds), PointLocation::kOutside);
}

TEST(GeoJson, RefusesCurvesThatItCannotDraw) {
  const std::string ring = "[[0,0],[5,0],[5,5],[0,0]]";
  const auto message = [&](const std::string& properties, const VectorOptions& options) -> std::string {
    try {
      read_geojson(feature(polygon(ring), properties), "s.geojson", options);
    } catch (const FormatError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(message(R"({"curve":"circle"})", {}),
            "s.geojson: feature 0: unknown curve \"circle\", expected \"spline\"");
  EXPECT_NE(message(R"({"curve":"spline"})", {.lonlat = true}).find("curves need planar coordinates"),
            std::string::npos);
  EXPECT_NE(message(R"({"curve":"spline"})", {.curve_tolerance = 0.0}).find("tolerance is 0"), std::string::npos);
}

TEST(GeoJson, ReadsZones) {
  const MapFile map = geojson_of(
      collection(feature(polygon(kSquare), R"({"role":"keepout","name":"dock"})") + "," +
                 feature(polygon(kSquare), R"({"role":"keepout","vehicles":["van","truck"]})") + "," +
                 feature(R"({"type":"MultiPolygon","coordinates":[[)" + std::string(kSquare) + "],[" + kSquare + "]]}",
                         R"({"role":"speed_limit","max_speed":2.5,"name":7})") +
                 "," + feature(polygon(kSquare), R"({"role":"one_way","heading":1.5,"tolerance":0.25})") + "," +
                 feature(polygon(kSquare), R"({"role":"clearance","distance":0.5,"cost":10})")));
  EXPECT_TRUE(map.obstacles.empty());
  EXPECT_TRUE(map.warnings.empty()) << map.warnings.front();
  ASSERT_EQ(map.zones.size(), 6u);
  EXPECT_EQ(map.zones[5].rule, ZoneRule(KeepClear{0.5, 10.0}));
  EXPECT_EQ(map.zones[4].rule, ZoneRule(OneWay{1.5, 0.25}));
  EXPECT_EQ(map.zones[0].rule, ZoneRule(KeepOut{}));
  EXPECT_EQ(map.zones[0].name, "dock");
  EXPECT_EQ(map.zones[0].area.outer, (Ring{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  EXPECT_EQ(map.zones[1].rule, ZoneRule(KeepOut{{"van", "truck"}}));
  EXPECT_EQ(map.zones[3].rule, ZoneRule(SpeedLimit{2.5}));
  EXPECT_EQ(map.zones[3].name, "7");
  EXPECT_EQ(map.zone_places[3], "feature 2, polygon 1");
}

TEST(GeoJson, ZonesReadBackToTheSame) {
  MapFile map;
  const Ring ring{{0, 0}, {9, 0}, {9, 9}}, hole{{5, 1}, {6, 1}, {6, 2}};
  map.zones = {{{ring, {hole}}, KeepOut{}, "a \"b\""},
               {{ring, {}}, KeepOut{{"x", "y"}}, ""},
               {{ring, {}}, SpeedLimit{0.1}, "c"},
               {{ring, {}}, OneWay{-0.1, 0.7}, "d"},
               {{ring, {}}, KeepClear{0.3, 0.1}, "e"}};
  const MapFile back = geojson_of(to_geojson(map));
  ASSERT_EQ(back.zones.size(), 5u);
  EXPECT_TRUE(back.zones[3].area.holes.empty());
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(back.zones[i].rule, map.zones[i].rule);
    EXPECT_EQ(back.zones[i].name, map.zones[i].name);
    EXPECT_EQ(back.zones[i].area.outer, ring);
    EXPECT_EQ(back.zones[i].area.holes, map.zones[i].area.holes);
  }
  EXPECT_TRUE(back.warnings.empty());
}

TEST(GeoJson, WarnsOfPropertiesThatZonesDoNotHave) {
  const MapFile map = geojson_of(collection(feature(polygon(kSquare), R"({"role":"keepout","max_speed":2})") + "," +
                                            feature(polygon(kSquare), R"({"role":"keepout","max_speed":3})") + "," +
                                            feature(polygon(kSquare), R"({"role":"keepout","vehicle":["van"]})") + "," +
                                            feature(polygon(kSquare), R"({"role":"one_way","heading":1,"tolerance":1,)"
                                                                      R"("max_speed":1})") +
                                            "," +
                                            feature(polygon(kSquare), R"({"role":"clearance","distance":1,"cost":1,)"
                                                                      R"("dist":1})")));
  ASSERT_EQ(map.warnings.size(), 4u);
  EXPECT_EQ(map.warnings[3],
            "world.geojson: feature 4: the property \"dist\" of a zone is not read; did you mean \"distance\"?");
  EXPECT_EQ(map.warnings[2],
            "world.geojson: feature 3: the property \"max_speed\" of a zone is not read; these are: role curve id name "
            "heading tolerance");
  EXPECT_EQ(
      map.warnings[0],
      "world.geojson: feature 0: the property \"max_speed\" (and of 1 more) of a zone is not read; these are: role "
      "curve id name vehicles");
  EXPECT_EQ(map.warnings[1],
            "world.geojson: feature 2: the property \"vehicle\" of a zone is not read; did you mean \"vehicles\"?");
}

TEST(GeoJson, RefusesWrongZones) {
  EXPECT_EQ(geojson_error(feature(polygon(kSquare), R"({"role":"speed_limit","speed":2})")),
            "world.geojson: feature 0: a speed_limit needs the property \"max_speed\" [m/s]");
  EXPECT_EQ(geojson_error(feature(polygon(kSquare), R"({"role":"speed_limit","max_speed":"2"})")),
            "world.geojson: feature 0, max_speed: expected a number, found \"2\"");
  EXPECT_EQ(
      geojson_error(feature(polygon(kSquare), R"({"role":"keepout","vehicles":"van"})")),
      "world.geojson: feature 0: expected \"vehicles\" as an array of names of robots, found \"van\"; leave it out "
      "for all vehicles");
  EXPECT_EQ(geojson_error(feature(R"({"type":"LineString","coordinates":[[0,0],[1,1]]})", R"({"role":"keepout"})")),
            "world.geojson: feature 0: a zone must be a Polygon or MultiPolygon, found \"LineString\"");
  EXPECT_EQ(geojson_error(feature(polygon(kSquare), R"({"role":"one_way","heading":1})")),
            "world.geojson: feature 0: a one_way needs the property \"tolerance\" [rad]");
  EXPECT_EQ(geojson_error(feature(polygon(kSquare), R"({"role":"one_way","heading":"90deg","tolerance":1})")),
            "world.geojson: feature 0, heading: expected a number, found \"90deg\"");
  EXPECT_EQ(geojson_error(feature(polygon(kSquare), R"({"role":"clearance","distance":1})")),
            "world.geojson: feature 0: a clearance needs the property \"cost\" [s/m]");
  EXPECT_EQ(geojson_error(feature(polygon(kSquare), R"({"role":"clearance","cost":1})")),
            "world.geojson: feature 0: a clearance needs the property \"distance\" [m]");
  const std::string wrong = feature(polygon(kSquare), R"({"role":"speed_limit","max_speed":0,"name":"yard"})");
  EXPECT_EQ(test::format_error_of([&] { static_cast<void>(to_world(geojson_of(wrong), "w.geojson")); }).substr(0, 71),
            "w.geojson: feature 0: speed_limit zone \"yard\": max_speed is 0 m/s, must");
}

}  // namespace
}  // namespace arcway::internal

#include <gtest/gtest.h>

#include <string>

#include "tests/support/tool.h"

namespace {

using arcway::internal::test::kAround;
using arcway::internal::test::Tool;

constexpr const char* kMap = "clutter/star/n30/m6/f20/s3";

TEST_F(Tool, ChangesAPreparedMapToTheOnePreparedAnew) {
  const std::string extra =
      put("extra.wkt", "GEOMETRYCOLLECTION(POLYGON((1 1,3 1,3 3,1 1)),POLYGON((10 10,12 10,12 12,10 12,10 10)))");
  for (const std::string kind : {"reduced", "feasible"}) {
    ASSERT_EQ(run("prepare " + std::string(kMap) + " --kind " + kind + " --out " + file("m.arcway")).code, 0);
    for (const std::string backend : {"", " --backend reference"}) {
      const Run result = run("change " + file("m.arcway") + " --remove 3,17 --remove 0 --add " + extra + backend +
                             " --out " + file("changed.arcway"));
      ASSERT_EQ(result.code, 0) << result.err;
      EXPECT_NE(result.out.find("3 obstacles removed, 2 added"), std::string::npos) << result.out;
      ASSERT_EQ(run("convert " + file("changed.arcway") + " " + file("w.geojson")).code, 0);
      ASSERT_EQ(run("prepare " + file("w.geojson") + " --kind " + kind + " --out " + file("anew.arcway")).code, 0);
      EXPECT_TRUE(read("changed.arcway") == read("anew.arcway")) << kind << backend;
    }
  }
}

TEST_F(Tool, PlansOnAChangedMap) {
  ASSERT_EQ(run("prepare " + map_ + " --out " + file("m.arcway")).code, 0);
  ASSERT_EQ(run("change " + file("m.arcway") + " --remove 0 --out " + file("free.arcway")).code, 0);
  const Run around = run("plan " + file("m.arcway") + kAround), straight = run("plan " + file("free.arcway") + kAround);
  EXPECT_EQ(around.code, 0) << around.err;
  EXPECT_EQ(straight.code, 0) << straight.err;
  EXPECT_NE(around.out, straight.out);
}

TEST_F(Tool, PassesOnWhatTheAddedMapsSay) {
  ASSERT_EQ(run("prepare " + map_ + " --out " + file("m.arcway")).code, 0);
  const std::string change = "change " + file("m.arcway") + " --out " + file("n.arcway") + " --add ";
  const Run fence = run(change + put("fence.wkt", "LINESTRING (3 -5, 3 5)\nPOLYGON ((2 2,3 2,3 3,2 2))"));
  EXPECT_EQ(fence.code, 0) << fence.err;
  EXPECT_NE(fence.out.find("fence.wkt: passed over 1 geometry that is not a polygon"), std::string::npos) << fence.out;
  const std::string hall = put("hall.wkt", "POLYGON ((0 0, 60 0, 60 60, 0 60, 0 0), (50 50, 55 50, 55 55, 50 50))");
  const Run free = run(change + hall + " --polygons free");
  EXPECT_NE(free.out.find("0 obstacles removed, 1 added"), std::string::npos) << free.out;
  EXPECT_NE(run("plan " + file("m.arcway") + kAround + " --lonlat").out.find("--lonlat and --polygons are not used"),
            std::string::npos);
  EXPECT_NE(run(change + map_).out.find("its bounds are left out; only obstacles are added"), std::string::npos);
  const std::string ring = R"("type":"Polygon","coordinates":[[[6,50],[6.001,50],[6.001,50.001],[6,50]]]})";
  const std::string named = put("nad83.geojson", R"({"crs":{"type":"name","properties":{"name":"NAD83"}},)" + ring);
  expect_bad_input(change + named, "nad83.geojson has degrees of longitude and latitude");
  const std::string looks = put("looks.geojson", "{" + ring);
  expect_bad_input(change + looks, "looks.geojson seems to have degrees");
  EXPECT_EQ(run(change + looks + " --planar").code, 0);
  // A cone of 30 cm is none.
  EXPECT_EQ(run(change + put("cone.wkt", "POLYGON ((50 50, 50.3 50, 50.3 50.3, 50 50))")).code, 0);
}

TEST_F(Tool, RefusesChangesThatCannotBe) {
  ASSERT_EQ(run("prepare " + map_ + " --out " + file("m.arcway")).code, 0);
  const std::string change = "change " + file("m.arcway") + " --out " + file("n.arcway");
  expect_bad_input(change, "nothing to change");
  expect_bad_input(change + " --remove 1", "obstacle 1 of " + file("m.arcway") + ", which has 1");
  expect_bad_input(change + " --remove 0 --remove 0", "obstacle 0 is named twice");
  expect_bad_input(change + " --remove x", "--remove");
  expect_bad_input(change + " --add " + put("bad.geojson", "{"), "bad.geojson");
  expect_bad_input("change " + map_ + " --remove 0 --out " + file("n.arcway"), "no prepared map");
  EXPECT_FALSE(exists("n.arcway"));
}

}  // namespace

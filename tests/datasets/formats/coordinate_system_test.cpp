#include "datasets/formats/coordinate_system.h"

#include <gtest/gtest.h>

namespace arcway::internal::detail {
namespace {

void expect(CoordinateUnit unit, std::initializer_list<const char*> names) {
  for (const char* name : names) EXPECT_EQ(coordinate_unit(name), unit) << name;
}

TEST(CoordinateSystem, KnowsEveryNotationOfAGeographicSystem) {
  expect(CoordinateUnit::kDegrees, {"urn:ogc:def:crs:OGC:1.3:CRS84",
                                    "OGC:CRS84h",
                                    "http://www.opengis.net/def/crs/OGC/1.3/CRS84",
                                    "CRS83",
                                    "urn:ogc:def:crs:EPSG::4326",
                                    "EPSG:4326",
                                    "epsg:4326",
                                    "4326",
                                    "urn:ogc:def:crs:EPSG:9.8.1:4326",
                                    "http://www.opengis.net/def/crs/EPSG/0/4326",
                                    "http://www.opengis.net/gml/srs/epsg.xml#4326",
                                    "EPSG:4269",
                                    "EPSG:4258",
                                    "EPSG:4283",
                                    "EPSG:7844",
                                    "EPSG:6318",
                                    "EPSG:4490",
                                    "EPSG:4979",
                                    "EPSG:9057",
                                    "ESRI:104199",
                                    "WGS84",
                                    "WGS 84",
                                    "WGS_1984",
                                    "GCS_North_American_1983",
                                    "NAD83(2011)",
                                    "NAD27",
                                    "ETRS89",
                                    "GDA2020",
                                    "+proj=longlat +datum=NAD83 +no_defs",
                                    "proj=latlong",
                                    R"(GEOGCS["GCS_X",DATUM["D",SPHEROID["S",1,2]]])",
                                    R"(GEOGCRS["WGS 84",CS[ellipsoidal,2],ANGLEUNIT["degree",0.017]])",
                                    R"(GEODCRS["WGS 84"])",
                                    "lon/lat",
                                    "longitude and latitude"});
  expect(CoordinateUnit::kGrads, {"EPSG:4807", R"x(GEOGCS["NTF (Paris)",UNIT["grad",0.0157]])x"});
}

TEST(CoordinateSystem, KnowsPlanarSystemsAndTheirUnits) {
  expect(CoordinateUnit::kMeters,
         {"urn:ogc:def:crs:EPSG::25832", "EPSG:32633", "EPSG:2154", "EPSG:27700", "EPSG:3035", "EPSG:31467",
          "urn:ogc:def:crs,crs:EPSG::27700,crs:EPSG::5701", "WGS 84 / UTM zone 32N", "+proj=utm +zone=32 +ellps=GRS80",
          "local", R"(PROJCS["X",GEOGCS["G",UNIT["degree",0.017]],PROJECTION["Transverse_Mercator"],UNIT["meter",1]])",
          R"(LOCAL_CS["yard",UNIT["meter",1]])"});
  expect(CoordinateUnit::kOtherUnit,
         {"EPSG:2263", "EPSG:2225", "EPSG:3361", "NAD83 / New York Long Island (ftUS)", "+proj=lcc +units=us-ft",
          R"(PROJCRS["X",BASEGEOGCRS["G"],LENGTHUNIT["US survey foot",0.304800609601219]])"});
  expect(CoordinateUnit::kWebMercator,
         {"EPSG:3857", "urn:ogc:def:crs:EPSG::900913", "ESRI:102100", "WGS 84 / Pseudo-Mercator", "Web Mercator",
          R"(PROJCS["WGS_1984_Web_Mercator_Auxiliary_Sphere",UNIT["Meter",1.0]])",
          "+proj=merc +a=6378137 +b=6378137 +nadgrids=@null"});
  expect(CoordinateUnit::kMercator, {"EPSG:3395", "WGS 84 / World Mercator", "+proj=merc +datum=WGS84"});
  expect(CoordinateUnit::kStretched, {"EPSG:4087", "EPSG:32662", "EPSG:8857", "ESRI:54009", "+proj=eqc"});
  expect(CoordinateUnit::kGeocentric,
         {"EPSG:4978", "urn:ogc:def:crs:EPSG::4936", "+proj=geocent +datum=WGS84",
          R"(GEOCCS["WGS 84",UNIT["meter",1]])", R"(GEODCRS["WGS 84",CS[Cartesian,3],LENGTHUNIT["meter",1]])"});
  expect(CoordinateUnit::kUnknown, {"", "frame of the hall", "EPSG:99999", "IGNF:LAMB93", "EPSG:12", "EPSG:10176"});
}

TEST(CoordinateSystem, WebMercatorReadsBackward) {
  // Berlin: the tile scheme's own formulae.
  EXPECT_NEAR(web_mercator_longitude(1492000.0), 13.402864, 1e-6);
  EXPECT_NEAR(web_mercator_latitude(6894000.0), 52.516175, 1e-6);
  EXPECT_NEAR(mercator_scale(6894000.0), 1.643284, 1e-6);  // 1 / cos(52.516 degrees)
  EXPECT_EQ(web_mercator_latitude(0.0), 0.0);
}

}  // namespace
}  // namespace arcway::internal::detail

#include "arcway/datasets/doctor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "arcway/datasets/catalog.h"
#include "arcway/datasets/geojson.h"
#include "arcway/datasets/repair.h"
#include "datasets/formats/text_polygons.h"
#include "tests/support/boxes.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {

using test::box_ring;

namespace {

std::vector<FindingKind> kinds(const MapFile& map) {
  std::vector<FindingKind> result;
  for (const Finding& finding : examine(map).findings) result.push_back(finding.kind);
  return result;
}

MapFile of(std::vector<Polygon> obstacles) {
  MapFile map;
  map.obstacles = std::move(obstacles);
  return map;
}

using Kinds = std::vector<FindingKind>;

TEST(Doctor, FindsNothingInACleanMap) {
  const DoctorReport report = examine(of({{box_ring(0, 0, 5, 5), {}}, {box_ring(8, 0, 12, 5), {}}}));
  EXPECT_TRUE(report.findings.empty());
  EXPECT_TRUE(report.plans());
  EXPECT_EQ(report.obstacles, 2u);
  EXPECT_EQ(report.vertices, 8u);
}

TEST(Doctor, FindsWhatIsUnusualInARing) {
  EXPECT_EQ(kinds(of({{{{0, 0}, {5, 0}, {5, 5}, {0, 0}}, {}}})), Kinds{FindingKind::kClosingVertex});
  EXPECT_EQ(kinds(of({{{{0, 0}, {5, 0}, {5, 0}, {5, 5}}, {}}})), Kinds{FindingKind::kRepeatedVertex});
  EXPECT_EQ(kinds(of({{{{0, 0}, {2, 0}, {5, 0}, {5, 5}}, {}}})), Kinds{FindingKind::kCollinearVertex});
  EXPECT_EQ(kinds(of({{{{0, 0}, {5, 5}, {5, 0}}, {}}})), Kinds{FindingKind::kOrientation});
  EXPECT_EQ(kinds(of({{box_ring(0, 0, 9, 9), {box_ring(2, 2, 4, 4)}}})), Kinds{FindingKind::kOrientation});
}

TEST(Doctor, FindsWhatPlanningRefuses) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<Polygon, FindingKind>> cases = {
      {{{{0, 0}, {5, 0}, {5, 0}}, {}}, FindingKind::kTooFewVertices},
      {{{{0, 0}, {5, nan}, {5, 5}}, {}}, FindingKind::kOutOfRange},
      {{{{0, 0}, {5, 1e200}, {5, 5}}, {}}, FindingKind::kOutOfRange},
      {{{{0, 0}, {5, 0}, {8, 0}}, {}}, FindingKind::kZeroArea},
      {{{{0, 0}, {5, 5}, {5, 0}, {0, 5}}, {}}, FindingKind::kSelfCrossing},
      {{{{0, 0}, {5, 0}, {5, 5}, {5, 2}}, {}}, FindingKind::kEdgesOverlap},
      {{box_ring(0, 0, 5, 5), {{{7, 7}, {7, 8}, {8, 8}}}}, FindingKind::kMisplacedHole},
  };
  for (const auto& [polygon, kind] : cases) {
    const DoctorReport report = examine(of({polygon}));
    EXPECT_FALSE(report.plans()) << name_of(kind);
    EXPECT_EQ(report.findings.back().kind, kind) << name_of(report.findings.back().kind);
    EXPECT_THROW(to_world(without_repetitions(of({polygon})), "map"), FormatError) << name_of(kind);
  }
}

TEST(Doctor, FindsWhereAPolygonTouchesItself) {
  const DoctorReport report = examine(of({{box_ring(0, 0, 8, 8),
                                           {{{4, 0}, {2, 3}, {6, 3}},       // inside an edge of the outer ring
                                            {{0, 8}, {3, 7}, {2, 6}},       // at its corner
                                            {{4, 3}, {3, 4}, {5, 4}}}}}));  // inside an edge of the first hole
  EXPECT_TRUE(report.plans());
  ASSERT_EQ(report.findings.size(), 3u);
  for (const Finding& finding : report.findings) EXPECT_EQ(finding.kind, FindingKind::kSelfTouching) << finding.what;
  EXPECT_EQ(report.findings[0].what, "ring 1 vertex 0 lies inside ring 0 edge 0");
  EXPECT_EQ(report.findings[2].what, "ring 0 vertex 3 and ring 2 vertex 0 are in one place");
  const Ring pinched{{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}};
  EXPECT_EQ(examine(of({{pinched, {}}})).findings.at(0).what, "vertex 1 and vertex 4 are in one place");
}

TEST(Doctor, FindsWhatObstaclesDoToEachOther) {
  const Polygon square{box_ring(0, 0, 10, 10), {}};
  EXPECT_EQ(kinds(of({square, {box_ring(10, 0, 15, 5), {}}})), Kinds{FindingKind::kTouching});
  EXPECT_EQ(kinds(of({square, {box_ring(5, 5, 15, 15), {}}})), Kinds{FindingKind::kOverlap});
  EXPECT_EQ(kinds(of({square, {box_ring(5, 5, 7, 7), {}}})), Kinds{FindingKind::kContainment});
  EXPECT_EQ(kinds(of({square, square})), Kinds{FindingKind::kDuplicate});
}

TEST(Doctor, FindsObstaclesBeyondTheBounds) {
  MapFile map = of({{box_ring(1, 1, 3, 3), {}},
                    {box_ring(8, 8, 12, 12), {}},
                    {box_ring(20, 20, 30, 30), {}},
                    {box_ring(0, 5, 1, 6), {}}});
  map.bounds = box_ring(0, 0, 10, 10);
  const auto found = examine(map).findings;
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].kind, FindingKind::kCrossesBounds);
  EXPECT_EQ(found[0].place, "obstacle 1");
  EXPECT_EQ(found[1].kind, FindingKind::kOutsideBounds);
  EXPECT_EQ(found[1].place, "obstacle 2");
  EXPECT_TRUE(examine(map).plans());
}

// 800 squares in each other are 319,600 pairs.
TEST(Doctor, SaysWhereItStopsToListPairs) {
  MapFile map;
  for (int k = 1; k <= 800; ++k) map.obstacles.push_back({box_ring(-k, -k, k, k), {}});
  map.bounds = box_ring(-1e4, -1e4, 1e4, 1e4);
  const auto found = examine(map).findings;
  const auto count = [&](FindingKind kind) { return std::ranges::count(found, kind, &Finding::kind); };
  EXPECT_EQ(count(FindingKind::kUnlistedPairs), 1);
  EXPECT_EQ(count(FindingKind::kOutsideBounds), 0);
  EXPECT_GT(count(FindingKind::kContainment), 100'000);
  EXPECT_LT(count(FindingKind::kContainment), 110'000);
  EXPECT_TRUE(examine(map).plans());
}

TEST(Doctor, FindsCoordinatesThatAreDegreesOrFar) {
  EXPECT_EQ(kinds(of({{box_ring(13.4, 52.5, 13.41, 52.51), {}}})), Kinds{FindingKind::kDegrees});
  EXPECT_TRUE(kinds(of({{box_ring(0, 0, 0.2, 0.15), {}}})).empty());
  EXPECT_TRUE(kinds(of({{box_ring(1, 2, 1.2, 2.2), {}}})).empty());
  MapFile stated = of({{box_ring(13, 52, 20, 59), {}}});
  EXPECT_TRUE(kinds(stated).empty());
  stated.frame = CoordinateFrame::kDegrees;
  EXPECT_EQ(kinds(stated), Kinds{FindingKind::kDegrees});
  stated = of({{box_ring(13.4, 52.5, 13.41, 52.51), {}}});
  stated.frame = CoordinateFrame::kMeters;
  EXPECT_TRUE(kinds(stated).empty());
  EXPECT_EQ(kinds(of({{box_ring(1e7, 0, 1e7 + 5, 5), {}}})), Kinds{FindingKind::kFarFromOrigin});
  EXPECT_TRUE(kinds(of({{box_ring(8e6, 0, 8e6 + 5, 5), {}}})).empty());
}

TEST(Doctor, NamesThePlaceInTheFile) {
  const MapFile map = read_geojson(
      R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":{"type":"MultiPolygon","coordinates":[
      [[[0,0],[9,0],[9,9],[0,9],[0,0]]],
      [[[20,0],[29,0],[29,9],[29,9],[20,9],[20,0]],[[22,2],[24,2],[24,4],[22,4],[22,2]]]]}}]})",
      "two.geojson", {.as_written = true});
  const auto found = examine(map).findings;
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].place, "feature 0, polygon 1, ring 0, vertex 3");
  EXPECT_EQ(*found[0].at, Vec2(29, 9));
  EXPECT_EQ(found[1].place, "feature 0, polygon 1, ring 1");
  EXPECT_EQ(found[1].what, "hole runs counter-clockwise");
}

// What the doctor calls plannable World takes; for what it does not, see AgreesWithWorldOnRings.
TEST(Doctor, AgreesWithWorldOnTheCatalog) {
  for (const CatalogFamily& family : catalog_families()) {
    if (family.name == "paper") continue;
    for (const std::string_view kind : family.kinds.empty() ? std::vector<std::string_view>{""} : family.kinds) {
      const std::string name = std::string(family.name) + (kind.empty() ? "" : "/" + std::string(kind)) + "/s3";
      const MapFile map = catalog_map(name);
      EXPECT_TRUE(examine(map).plans()) << name;
      EXPECT_NO_THROW((void)to_world(map, name));
    }
  }
  const auto count = [](const char* name, FindingKind kind) {
    const std::vector<FindingKind> found = kinds(catalog_map(name));
    return std::count(found.begin(), found.end(), kind);
  };
  EXPECT_GT(count("adversarial/touching/v1000", FindingKind::kTouching), 100);
  EXPECT_EQ(count("adversarial/touching/v1000", FindingKind::kOverlap), 0);
  EXPECT_GT(count("adversarial/overlapping/v1000", FindingKind::kOverlap), 50);
  EXPECT_GT(count("adversarial/overlapping/v1000", FindingKind::kDuplicate), 3);
  EXPECT_GT(count("adversarial/nested/v1000", FindingKind::kContainment), 30);
  EXPECT_EQ(count("adversarial/shared/v1000", FindingKind::kContainment), 0);
}

TEST(Doctor, AgreesWithWorldOnRings) {
  test::RandomInputs random(1);
  int taken = 0, refused = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto ring = [&](std::int64_t size) {
      Ring points;
      for (std::int64_t k = random.integer(3, 6); k > 0; --k)
        points.emplace_back(static_cast<double>(random.integer(0, size)), static_cast<double>(random.integer(0, size)));
      points.erase(std::unique(points.begin(), points.end()), points.end());  // readers drop them
      while (points.size() > 1 && points.back() == points.front()) points.pop_back();
      return points;
    };
    Polygon polygon{ring(6), {}};
    if (i % 3 == 0) polygon.holes.push_back(ring(4));
    const MapFile map = of({polygon});
    bool is_taken = true;
    try {
      (void)to_world(map, "rings");
    } catch (const std::exception&) {
      is_taken = false;
    }
    EXPECT_EQ(examine(map).plans(), is_taken) << i;
    ++(is_taken ? taken : refused);
  }
  EXPECT_GT(taken, 100);
  EXPECT_GT(refused, 100);
}

class Repair : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!can_repair()) GTEST_SKIP() << "built without GEOS";
  }
  static double area(const MapFile& map) {
    double sum = 0.0;
    for (const Polygon& polygon : map.obstacles) {
      sum += signed_area(polygon.outer);
      for (const Ring& hole : polygon.holes) sum += signed_area(hole);
    }
    return sum;
  }
  // World takes the result, and nothing is left to find but contacts in single points, of one region or two.
  static MapFile repair(const MapFile& map) {
    MapFile clean = repaired(map);
    for (const Finding& finding : examine(clean).findings)
      EXPECT_TRUE(finding.kind == FindingKind::kTouching || finding.kind == FindingKind::kSelfTouching)
          << name_of(finding.kind) << ' ' << finding.place;
    EXPECT_NO_THROW(to_world(clean, "repaired"));
    return clean;
  }
};

TEST_F(Repair, MakesBrokenRingsValid) {
  EXPECT_EQ(area(repair(of({{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}, {}}}))), 8.0);  // a bow tie: two triangles
  EXPECT_EQ(area(repair(of({{{{0, 0}, {4, 0}, {4, 4}, {4, 2}, {4, 4}, {0, 4}}, {}}}))), 16.0);  // a spike along an edge
  EXPECT_EQ(area(repair(of({{{{0, 0}, {5, 0}, {9, 0}}, {}}}))), 0.0);                           // no area: gone
  EXPECT_EQ(area(repair(of({{{{0, 0}, {0, 4}, {4, 4}, {4, 4}, {4, 0}, {2, 0}, {0, 0}}, {}}}))), 16.0);
}

TEST_F(Repair, JoinsWhatOverlapsOrSharesEdges) {
  const MapFile joined =
      repair(of({{box_ring(0, 0, 4, 4), {}}, {box_ring(2, 2, 6, 6), {}}, {box_ring(6, 2, 8, 6), {}}}));
  EXPECT_EQ(joined.obstacles.size(), 1u);
  EXPECT_EQ(area(joined), 36.0);
  EXPECT_EQ(repair(of({{box_ring(0, 0, 4, 4), {}}, {box_ring(0, 0, 4, 4), {}}})).obstacles.size(), 1u);
}

TEST_F(Repair, KeepsTheLargestPartOfBrokenBounds) {
  MapFile map = of({{box_ring(1, 1, 2, 2), {}}});
  map.bounds = Ring{{0, 0}, {10, 0}, {10, 10}, {-1, 10}, {-1, 11}, {0, 11}};
  const MapFile clean = repaired(map);
  ASSERT_TRUE(clean.bounds);
  EXPECT_NO_THROW(to_world(clean, "repaired"));
  EXPECT_GT(signed_area(*clean.bounds), 90.0);
}

TEST_F(Repair, LeavesNoBoundsWithoutArea) {
  for (const Ring& bounds : {Ring{}, Ring{{1, 1}}, Ring{{0, 0}, {4, 4}}, Ring{{0, 0}, {4, 4}, {4, 4}, {0, 0}},
                             Ring{{0, 0}, {2, 2}, {4, 4}}}) {
    MapFile map = of({{box_ring(1, 1, 2, 2), {}}});
    map.bounds = bounds;
    EXPECT_FALSE(repair(map).bounds) << bounds.size();
  }
}

TEST_F(Repair, KeepsBoundsThatTouchThemselves) {
  MapFile map;
  map.bounds = Ring{{7, 1}, {5, 3}, {5, 8}, {1, 4}, {5, 3}, {5, 0}};
  EXPECT_EQ(std::abs(signed_area(*repair(map).bounds)), std::abs(signed_area(*map.bounds)));
}

TEST_F(Repair, KeepsHolesThatTouch) {
  const MapFile clean = repair(of({{box_ring(0, 0, 8, 8), {{{4, 0}, {2, 3}, {6, 3}}, {{4, 3}, {3, 4}, {5, 4}}}}}));
  EXPECT_EQ(area(clean), 64.0 - 6.0 - 1.0);
  EXPECT_EQ(to_world(clean, "repaired").self_contacts().size(), 2u);
}

// They name rings by their numbers, which are others now.
TEST_F(Repair, LeavesNoCurves) {
  MapFile map = of({{box_ring(0, 0, 4, 4), {}}, {box_ring(2, 2, 6, 6), {}}});
  map.curves.push_back({1, 0, {}});
  EXPECT_TRUE(repair(map).curves.empty());
}

TEST_F(Repair, TakesTheCatalog) {
  for (const char* name : {"adversarial/touching/v2000", "adversarial/shared/v2000", "adversarial/overlapping/v2000",
                           "adversarial/nested/v2000", "adversarial/contacts/v2000", "adversarial/holes/v2000",
                           "city/v2000", "adversarial/needles/v500"}) {
    SCOPED_TRACE(name);
    repair(catalog_map(name));
  }
}

TEST(Doctor, ListsZonesAndFindsWhatIsWrongWithThem) {
  MapFile map = of({{box_ring(0, 0, 5, 5), {}}});
  map.zones = {{{box_ring(1, 1, 2, 2), {}}, KeepOut{{"van", "truck"}}, "dock"}};
  DoctorReport report = examine(map);
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_EQ(report.findings[0].kind, FindingKind::kZone);
  EXPECT_EQ(report.findings[0].what, "keepout zone \"dock\" for van truck");
  EXPECT_TRUE(report.plans());

  map.zones = {{{box_ring(1, 1, 2, 2), {}}, SpeedLimit{-1.0}, ""}};
  map.zone_places = {"feature 4"};
  report = examine(map);
  ASSERT_EQ(report.findings.size(), 2u);
  EXPECT_EQ(report.findings[0].what, "zone 0 (speed_limit) of -1 m/s");
  EXPECT_EQ(report.findings[1].kind, FindingKind::kZoneRule);
  EXPECT_EQ(report.findings[1].place, "feature 4");
  EXPECT_EQ(report.findings[1].what, "max_speed is -1 m/s, must be from 1e-50 to 1e+50");
  EXPECT_FALSE(report.plans());

  map.zones = {{{box_ring(1, 1, 2, 2), {}}, OneWay{1.5, 0.25}, "aisle"}};
  report = examine(map);
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_EQ(report.findings[0].what, "one_way zone \"aisle\" in direction 1.5 rad, to either side 0.25 rad");
  EXPECT_TRUE(report.plans());

  map.zones = {{{box_ring(1, 1, 2, 2), {}}, KeepClear{0.5, 10.0}, "hall"}};
  report = examine(map);
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_EQ(report.findings[0].what, "clearance zone \"hall\" of 0.5 m; each meter driven closer costs 10 s");
  EXPECT_TRUE(report.plans());

  map.zones = {{{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}, KeepOut{}, ""}};
  report = examine(map);
  ASSERT_EQ(report.findings.size(), 2u);
  EXPECT_EQ(report.findings[1].kind, FindingKind::kSelfCrossing);
  EXPECT_FALSE(report.plans());
}

TEST(Doctor, RepairKeepsZones) {
  if (!can_repair()) GTEST_SKIP() << "without GEOS";
  MapFile map = of({{box_ring(0, 0, 5, 5), {}}, {box_ring(3, 3, 8, 8), {}}});
  map.zones = {{{{{1, 1}, {2, 1}, {2, 1}, {2, 2}, {1, 1}}, {}}, SpeedLimit{1.0}, "yard"}};
  const MapFile clean = repaired(map);
  ASSERT_EQ(clean.zones.size(), 1u);
  EXPECT_EQ(clean.zones[0].area.outer.size(), 3u);
}

}  // namespace
}  // namespace arcway::internal

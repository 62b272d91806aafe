// Real maps, if ARCWAY_SHARED_DATA names the folder that holds them; see its README for sources and counts.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "arcway/datasets/read_map.h"

namespace arcway::internal {
namespace {

namespace fs = std::filesystem;

struct SharedMap {
  const char* file;
  std::size_t obstacles;  ///< of the file's polygon version
  std::size_t vertices;   ///< of the same, which cuts the two free corners off where cells meet at a corner alone
  std::size_t holes;
  std::size_t contacts;  ///< such corners: each takes two vertices here, four there
};

const SharedMap kGrids[] = {
    {"ros/warehouse.yaml", 80, 5570, 320, 76},
    {"ros/tb3_sandbox.yaml", 10, 414, 6, 0},
    {"ros/willow-full.pgm", 1634, 14000, 26, 603},
    {"movingai/Berlin_1_1024.map.gz", 75, 11094, 2, 2},
    {"movingai/maze512-8-0.map", 35, 4770, 0, 0},
    {"movingai/32room_000.map", 198, 2622, 0, 0},
    {"movingai/random512-20-0.map", 18935, 163496, 0, 12130},
    {"movingai/warehouse-20-40-10-2-2.map", 801, 3208, 1, 0},
};

// Files of polygons, as they are.
const SharedMap kPolygons[] = {
    {"svg/parking1.svg", 13, 224, 0, 0},  // two of them touch others
    {"svg/warehouse.svg", 88, 1760, 0, 0},
    {"svg/parking1.geojson", 11, 223, 0, 0},
    {"city/luxembourg.geojson.gz", 10345, 69430, 99, 0},
    {"coast/chile.geojson.gz", 2819, 72243, 2, 0},
    {"movingai/random512-20-0.geojson.gz", 18935, 163496, 0, 0},
    {"parking/Case1.csv", 3, 12, 0, 0},
    {"parking/Case3.csv", 3, 12, 0, 0},
    {"parking/Case5.csv", 53, 212, 0, 0},
    {"parking/Case7.csv", 3, 12, 0, 0},
    {"parking/Case9.csv", 2, 8, 0, 0},
    {"parking/Case11.csv", 5, 25, 0, 0},
    {"parking/Case13.csv", 4, 16, 0, 0},
    {"parking/Case15.csv", 4, 16, 0, 0},
    {"parking/Case17.csv", 10, 67, 0, 0},
    {"parking/Case19.csv", 37, 163, 0, 0},
};

class SharedMaps : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("ARCWAY_SHARED_DATA");
    if (folder == nullptr || !fs::is_directory(folder)) GTEST_SKIP() << "ARCWAY_SHARED_DATA names no folder of maps";
    folder_ = folder;
  }
  void expect_counts(const SharedMap& expected) const {
    SCOPED_TRACE(expected.file);
    const MapFile map = read_map(folder_ / expected.file);
    std::size_t vertices = 0, holes = 0;
    for (const Polygon& polygon : map.obstacles) {
      vertices += polygon.outer.size();
      holes += polygon.holes.size();
      for (const Ring& hole : polygon.holes) vertices += hole.size();
    }
    EXPECT_EQ(map.obstacles.size(), expected.obstacles);
    EXPECT_EQ(holes, expected.holes);
    EXPECT_EQ(vertices + 2 * expected.contacts, expected.vertices);
    EXPECT_EQ(to_world(map, expected.file).obstacle_count(), expected.obstacles);
  }
  fs::path folder_;
};

TEST_F(SharedMaps, GridsHaveTheirObstaclesAndCorners) {
  for (const SharedMap& map : kGrids) expect_counts(map);
}

TEST_F(SharedMaps, PolygonsHaveTheirObstaclesAndVertices) {
  for (const SharedMap& map : kPolygons) expect_counts(map);
}

TEST_F(SharedMaps, ScenariosAndParkingCasesBringStartAndGoal) {
  for (const char* file : {"movingai/32room_000.map.scen.gz", "movingai/Berlin_1_1024.map.scen.gz",
                           "movingai/maze512-8-0.map.scen.gz", "parking/Case7.csv", "parking/Case15.csv"}) {
    const MapFile map = read_map(folder_ / file, {.task = 7});
    EXPECT_TRUE(map.start && map.goal && map.bounds) << file;
  }
}

}  // namespace
}  // namespace arcway::internal

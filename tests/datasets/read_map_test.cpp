#include "datasets/read_map.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace arcway {
namespace {

namespace fs = std::filesystem;

class ReadMap : public ::testing::Test {
 protected:
  ReadMap() { fs::create_directories(folder_); }
  ~ReadMap() override { fs::remove_all(folder_); }
  fs::path put(const std::string& name, const std::string& text) const {
    write_file_atomically(folder_ / name, text);
    return folder_ / name;
  }
  std::string error_of(const fs::path& path, const MapReadOptions& options = {}) const {
    try {
      read_map(path, options);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "no error";
  }
  fs::path folder_ = fs::path(::testing::TempDir()) /
                     ("arcway_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST(DetectFormat, GoesByContent) {
  const auto expect = [](std::string_view content, MapFormat format) {
    EXPECT_STREQ(name_of(detect_format(content, "x")), name_of(format)) << content;
  };
  expect("\xEF\xBB\xBF\r\n {\"type\":\"Polygon\"}", MapFormat::kGeoJson);
  expect("\x1E{}\n", MapFormat::kGeoJson);
  expect("polygon((0 0,1 0,1 1,0 0))", MapFormat::kWkt);
  expect("SRID=4326;POLYGON EMPTY", MapFormat::kWkt);
  expect("MultiPolygonZM EMPTY", MapFormat::kWkt);
  expect("# a comment\n0 0 1 0 1 1\n", MapFormat::kTextPolygons);
  expect("1.5,2,0,2,3,0,0", MapFormat::kTpcap);
  expect("-1\n2\n0\n", MapFormat::kTpcap);
  expect("type octile\nheight 1\n", MapFormat::kMovingAiMap);
  expect("version 1\n", MapFormat::kMovingAiScenario);
  expect("# saved\nmode: raw\nimage: a.pgm\n", MapFormat::kRosMap);
  expect("%YAML 1.2\n---\nimage: a.pgm\n", MapFormat::kRosMap);
  expect("---\r\nimage: a.pgm\r\n", MapFormat::kRosMap);
  expect("--- # saved\n\"image\": a.pgm\n", MapFormat::kRosMap);
  EXPECT_THROW(detect_format("", "x"), FormatError);
  EXPECT_THROW(detect_format("\x7F"
                             "ELF",
                             "x"),
               FormatError);
}

TEST_F(ReadMap, AScenarioBringsStartAndGoal) {
  put("a.map", "type octile\nheight 2\nwidth 3\nmap\n...\n.@.\n");
  const fs::path scenario =
      put("a.map.scen", "version 1\n0\tmaps/far/a.map\t3\t2\t0\t0\t2\t1\t3\n0\ta.map\t6\t4\t5\t0\t0\t3\t9\n");
  const MapFile map = read_map(scenario);
  ASSERT_EQ(map.obstacles.size(), 1u);
  EXPECT_EQ(map.obstacles[0].outer, (Ring{{1, 0}, {2, 0}, {2, 1}, {1, 1}}));
  EXPECT_EQ(map.bounds, (Ring{{0, 0}, {3, 0}, {3, 2}, {0, 2}}));
  EXPECT_EQ(map.start->position(), Vec2(0.5, 1.5));
  EXPECT_EQ(map.goal->position(), Vec2(2.5, 0.5));
  // The second task is on a map of twice the size.
  const MapFile scaled = read_map(scenario, {.grid = {.cell_size = 0.5}, .task = 1});
  EXPECT_EQ(scaled.bounds, (Ring{{0, 0}, {3, 0}, {3, 2}, {0, 2}}));
  EXPECT_EQ(scaled.start->position(), Vec2(2.75, 1.75));
  EXPECT_NE(error_of(scenario, {.task = 2}).find("there is no task 2, the file has 2"), std::string::npos);
  fs::remove(folder_ / "a.map");
  EXPECT_EQ(error_of(scenario), scenario.string() + " needs another file: cannot read " +
                                    (folder_ / "maps/far/a.map").string() + ": No such file or directory");
}

TEST_F(ReadMap, ErrorsNameTheFile) {
  EXPECT_NE(error_of(put("x.bin", "nothing")).find("x.bin: line 1: this is no map of a known format"),
            std::string::npos);
  EXPECT_NE(error_of(put("x.bin", "# of\nnothing\n")).find("x.bin: line 2: this is no map"), std::string::npos);
  EXPECT_NE(error_of(put("empty", "\n")).find("empty: empty file"), std::string::npos);
  EXPECT_NE(error_of(put("empty", "# nothing\n")).find("empty: empty file"), std::string::npos);
  EXPECT_NE(error_of(folder_ / "none").find("none: No such file"), std::string::npos);
}

}  // namespace
}  // namespace arcway

#include "arcway/datasets/read_map.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

namespace arcway::internal {
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
  expect("0,0,0,9,9,0,1,3,1,1,2,1,2,2", MapFormat::kTpcap);
  expect("0\n0\n0\n9\n9\n0\n1\n3\n1\n1\n2\n1\n2\n2\n", MapFormat::kTpcap);
  expect("0,0\n1,0\n1,1\n", MapFormat::kVertexList);
  expect("0 0\n1 0\n1 1\n", MapFormat::kVertexList);
  expect("1,0,0\n1,1,0\n1,1,1\n", MapFormat::kVertexList);
  expect("x,y\n0,0\n1,0\n1,1\n", MapFormat::kVertexList);
  expect("polygon;lon;lat\n1;8;48\n", MapFormat::kVertexList);
  expect("0,0 1,0 1,1\n5,5 6,5 6,6\n", MapFormat::kTextPolygons);
  expect("0,0,1,0,1,1\n5,5,6,5,6,6\n", MapFormat::kTextPolygons);
  expect("-1\n2\n0\n", MapFormat::kTpcap);
  expect("type octile\nheight 1\n", MapFormat::kMovingAiMap);
  expect("width 4\nheight 1\nmap\n", MapFormat::kMovingAiMap);
  expect("3,4\n....\n.@@.\n....\n", MapFormat::kMovingAiMap);
  expect("2 4\n7\n..E.\n.@@.\n", MapFormat::kMovingAiMap);
  expect("2,4\n7\n3\n1000\n..E.\n.@@.\n", MapFormat::kMovingAiMap);
  expect("####\n#..#\n####\n", MapFormat::kMovingAiMap);
  expect("42,61000000000000000000000000000\n.\n", MapFormat::kVertexList);  // no width that a row could have
  expect("version 1\n", MapFormat::kMovingAiScenario);
  expect("0\ta.map\t3\t2\t0\t0\t2\t1\t3\n", MapFormat::kMovingAiScenario);
  expect("version: 1\nimage: a.pgm\n", MapFormat::kRosMap);
  expect("type: occupancy\nimage: a.pgm\n", MapFormat::kRosMap);
  expect("{image: m.pgm, resolution: 0.05}", MapFormat::kRosMap);
  expect("{\"resolution\": 0.05,\n \"image\": \"m.pgm\"}", MapFormat::kRosMap);
  expect("{\"type\":\"Polygon\",\"image\":1,\"resolution\":2}", MapFormat::kGeoJson);
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

TEST(DetectFormat, NamesFormatsThatAreNotRead) {
  const auto error = [](std::string_view content) {
    try {
      detect_format(content, "x");
    } catch (const FormatError& refusal) {
      return std::string(refusal.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(error("\xFF\xD8\xFF\xE0"), "x: this is a JPEG image; save it as PNG; it is not read as a map");
  EXPECT_NE(error("P6\n1 1\n255\n").find("a PPM image"), std::string::npos);
  EXPECT_NE(error("PK\x03\x04").find("a ZIP archive"), std::string::npos);
  EXPECT_NE(error("0\nSECTION\n").find("a DXF drawing"), std::string::npos);
  EXPECT_NE(error(R"({"format":"arcway-robot","version":1})").find("of the format arcway-robot, not a map"),
            std::string::npos);
  EXPECT_NE(error("costmap:\n  width: 3\n").find("looks like YAML, but has no key \"image\""), std::string::npos);
  EXPECT_NE(error("s,x,y,yaw\n").find("a table without columns x and y"), std::string::npos);
  EXPECT_NE(error("WKT,id\n\"POLYGON EMPTY\",1\n").find("a table without columns x and y"), std::string::npos);
  EXPECT_EQ(error(R"({"type":"Topology","objects":{}})"), "x: this is TopoJSON; export it as GeoJSON");
}

TEST(DetectFormat, FormatsHaveWords) {
  for (const std::string_view word : format_words()) EXPECT_STRNE(name_of(format_of_word(word).value()), "?") << word;
  EXPECT_FALSE(format_of_word("shp"));
}

TEST_F(ReadMap, AGuessIsNamedAndCanBeForced) {
  const fs::path odd = put("odd.txt", "0,0\n1,0\n1,1\n7,x\n");
  EXPECT_NE(error_of(odd).find("was taken for a "), std::string::npos) << error_of(odd);
  EXPECT_NE(error_of(odd).find("--format NAME reads it as another"), std::string::npos);
  EXPECT_EQ(error_of(odd, {.format = MapFormat::kWkt}).find("--format"), std::string::npos);
  EXPECT_NE(error_of(put("odd2.txt", "0 0 1 0 1 x\n2 2 3 2 3 3\n")).find("was taken for a text of polygons"),
            std::string::npos);
  const fs::path list = put("list.csv", "0 0\n9 0\n9 9\n0 0 1 0 1 1\n");
  EXPECT_EQ(read_map(put("p.txt", "0 0 1 0 1 1\n")).obstacles.size(), 1u);
  EXPECT_NE(error_of(list, {.format = MapFormat::kTextPolygons}).find("line 1: needs at least 3"), std::string::npos);
  const fs::path map = put("a.map", "type octile\nheight 1\nwidth 3\nmap\n.E.\n");
  EXPECT_NE(error_of(map).find("--free-letters"), std::string::npos);
  const MapFile free = read_map(map, {.grid = {.free_letters = "E"}});
  EXPECT_TRUE(free.obstacles.empty());
  EXPECT_NE(free.notes.back().find("cells of the letters E are free"), std::string::npos);
  EXPECT_NE(read_map(map, {.vector = {.lonlat = true}, .grid = {.free_letters = "E"}}).warnings.at(0).find("--lonlat"),
            std::string::npos);
}

TEST_F(ReadMap, PathsOfWindowsAreFound) {
  put("a.map", "type octile\nheight 2\nwidth 3\nmap\n...\n.@.\n");
  const fs::path scenario = put("a.scen", "version 1\n0\tmaps\\dao\\a.map\t3\t2\t0\t0\t2\t1\t3\n");
  EXPECT_EQ(read_map(scenario).obstacles.size(), 1u);
  fs::create_directories(folder_ / "sub");
  put("sub/b.map", "type octile\nheight 2\nwidth 3\nmap\n...\n...\n");
  EXPECT_TRUE(read_map(put("b.scen", "0\tsub\\b.map\t3\t2\t0\t0\t2\t1\t3\n")).obstacles.empty());
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
                                    (folder_ / "maps/far/a.map").string() +
                                    ": No such file or directory, nor is a.map beside it");
}

TEST_F(ReadMap, APipeBesideTheFileIsRefused) {
  put("a.yaml",
      "image: a.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n");
  ASSERT_EQ(::mkfifo((folder_ / "a.pgm").c_str(), 0600), 0);
  EXPECT_EQ(error_of(folder_ / "a.yaml"), (folder_ / "a.yaml").string() +
                                              " needs another file: " + (folder_ / "a.pgm").string() +
                                              " is a pipe; write what comes out of it to a file");
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
}  // namespace arcway::internal

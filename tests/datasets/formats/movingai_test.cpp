#include "datasets/formats/movingai.h"

#include <gtest/gtest.h>

#include "arcway/datasets/file_io.h"
#include "tests/support/format_errors.h"

namespace arcway::internal {
namespace {

std::string map_error(const std::string& text, const GridOptions& options = {}) {
  return test::format_error_of([&] { read_movingai_map(text, "a.map", options); });
}

TEST(MovingAi, RowsAreFromTheTop) {
  const std::string text = "type octile\r\nheight 2\r\nwidth 4\r\nmap\r\n@OTW\r\n.GS@\r\n\r\n";
  const OccupancyGrid grid = read_movingai_map(text, "a.map");
  ASSERT_EQ(grid.width, 4u);
  ASSERT_EQ(grid.height, 2u);
  const Cell f = Cell::kFree, b = Cell::kOccupied;
  EXPECT_EQ(grid.cells, (std::vector<Cell>{f, f, b, b, b, b, b, b}));
  EXPECT_EQ(grid.cell_size, 1.0);
  const OccupancyGrid swamp = read_movingai_map(text, "a.map", {.cell_size = 2.5, .swamp_is_free = true});
  EXPECT_EQ(swamp.at(2, 0), Cell::kFree);
  EXPECT_EQ(swamp.cell_size, 2.5);
}

TEST(MovingAi, MapErrorsNameThePlace) {
  EXPECT_EQ(
      map_error("type octile\nheight 2\nwidth 3\nmap\n...\n.x.\n"),
      "a.map: line 6, column 2: unknown cell \"x\"; name the letters that are free with --free-letters, others are "
      "obstacles then");
  EXPECT_EQ(map_error("type octile\nheight 2\nwidth 3\nmap\n...\n..\n"), "a.map: line 6: expected 3 cells, found 2");
  EXPECT_EQ(map_error("type octile\nheight 2\nwidth 3\nmap\n...\n"), "a.map: line 6: the map ends after 1 of 2 rows");
  EXPECT_EQ(map_error("type octile\nheight 2\nwidth -3\nmap\n...\n"),
            "a.map: line 3: expected width as a whole number above 0, found \"-3\"");
  EXPECT_EQ(map_error("type octile\nheight 1\nwidth 3\nmap\n...\n...\n"),
            "a.map: line 6: expected the end of the file after 1 rows, found \"...\"");
  EXPECT_NE(map_error("type octile\nheight 4294967296\nwidth 4294967297\nmap\n").find("at most 100000000"),
            std::string::npos);
}

TEST(MovingAi, HeadersVary) {
  const std::string rows = "..e@\n.@T.\n";
  const GridOptions options{.free_letters = "e"};
  const OccupancyGrid grid = read_movingai_map("type octile\nheight 2\nwidth 4\nmap\n" + rows, "a.map", options);
  for (const char* header :
       {"type octile\nwidth 4\nheight 2\nmap\n", "height 2\nwidth 4\nmap\n", "2,4\n", "2 4\n", "2,4\r\n7\n12\n", ""}) {
    const OccupancyGrid other = read_movingai_map(header + rows, "a.map", options);
    EXPECT_EQ(other.cells, grid.cells) << header;
    EXPECT_EQ(other.width, 4u) << header;
  }
  EXPECT_NE(map_error("type octile\nheight 2\nheight 2\nmap\n").find("line 3: expected \"width\""), std::string::npos);
  EXPECT_NE(map_error("").find("at most"), std::string::npos);
}

TEST(MovingAi, LettersAreFreeOrObstaclesAsTold) {
  const std::string text = "type octile\nheight 1\nwidth 6\nmap\n.eXS#@\n";
  const Cell f = Cell::kFree, b = Cell::kOccupied;
  EXPECT_EQ(read_movingai_map(text, "a", {.free_letters = "e"}).cells, (std::vector<Cell>{f, f, b, b, b, b}));
  EXPECT_EQ(read_movingai_map(text, "a", {.free_letters = "SX"}).cells, (std::vector<Cell>{f, b, f, f, b, b}));
}

TEST(MovingAi, ReadsTasks) {
  const auto tasks = read_movingai_scenario(
      "version 1\n0\tmaps/dao/arena.map\t49\t48\t1\t11\t2\t12\t1.41421356\r\n"
      "37 a map.map 49 48 48 47 0 0 150\n\n",
      "a.scen");
  ASSERT_EQ(tasks.size(), 2u);
  EXPECT_EQ(tasks[0].map, "maps/dao/arena.map");
  EXPECT_EQ(tasks[0].width, 49u);
  EXPECT_EQ(tasks[0].height, 48u);
  EXPECT_EQ(tasks[0].start_y, 11u);
  EXPECT_EQ(tasks[0].goal_x, 2u);
  EXPECT_EQ(tasks[0].optimal_length, 1.41421356);
  EXPECT_EQ(tasks[1].map, "a map.map");
  EXPECT_EQ(tasks[1].line, 3u);
}

TEST(MovingAi, TaskErrorsNameTheLine) {
  const auto error = [](const std::string& text) {
    return test::format_error_of([&] { read_movingai_scenario(text, "a.scen"); });
  };
  EXPECT_EQ(error("version 2\n"), "a.scen: line 1: expected \"version 1\", found \"version\"");
  EXPECT_NE(error("version 1\n0 a.map 9 9 1 1 2 2\n").find("a.scen: line 2: expected 9 fields"), std::string::npos);
  EXPECT_EQ(error("version 1.0\n0 a.map 9 9 9 1 2 2 1\n"),
            "a.scen: line 2: cell 9 is outside of the map of 9 x 9 cells");
  EXPECT_EQ(error("version 1\n0 a.map 9 5 8 1 2 5 1\n"), "a.scen: line 2: cell 5 is outside of the map of 9 x 5 cells");
  EXPECT_EQ(error("version 1\n0 a.map 5 9 1 8 5 2 1\n"), "a.scen: line 2: cell 5 is outside of the map of 5 x 9 cells");
  EXPECT_EQ(error("version 1\n0 a.map 9 9 1.5 1 2 2 1\n"),
            "a.scen: line 2: expected start x as a whole number, found \"1.5\"");
  // In 64 bits as high for its width as a map of 4 x 3 cells.
  EXPECT_EQ(error("version 1\n0 a.map 4 4611686018427387907 1 1 2 2 1\n"),
            "a.scen: line 2: a map of 4 x 4611686018427387907 cells, at most 1000000000 are read along a side");
}

TEST(MovingAi, HeadingsFollowSeedAndTask) {
  const TaskHeadings a = draw_headings(1, 0), b = draw_headings(1, 1), c = draw_headings(2, 0);
  EXPECT_EQ(a.start, draw_headings(1, 0).start);
  EXPECT_NE(a.start, b.start);
  EXPECT_NE(a.start, c.start);
  EXPECT_NE(a.start, a.goal);
}

}  // namespace
}  // namespace arcway::internal

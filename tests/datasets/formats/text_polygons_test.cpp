#include "datasets/formats/text_polygons.h"

#include <gtest/gtest.h>

#include "tests/support/format_errors.h"

namespace arcway::internal {
namespace {

std::string polygons_error(const std::string& text) {
  return test::format_error_of([&] { read_text_polygons(text, "map.txt"); });
}

TEST(TextPolygons, ReadsOnePolygonALine) {
  const MapFile map = read_text_polygons("# x y\r\n0 0 4 0 4 4 0 4\r\n\r\n  +1.5\t2 3e1 2 -.5 7  \n", "map.txt");
  ASSERT_EQ(map.obstacles.size(), 2u);
  EXPECT_EQ(map.obstacles[0].outer, (Ring{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  EXPECT_EQ(map.obstacles[1].outer, (Ring{{1.5, 2}, {30, 2}, {-0.5, 7}}));
  EXPECT_EQ(map.places, (std::vector<std::string>{"line 2", "line 4"}));
  EXPECT_TRUE(map.warnings.empty());
}

TEST(TextPolygons, CommasMayStandBetweenNumbers) {
  for (const char* text : {"0,0 4,0 4,4", "0,0,4,0,4,4", "0, 0; 4, 0; 4, 4\n", "0 0, 4 0, 4 4"}) {
    const MapFile map = read_text_polygons(text, "map.txt");
    ASSERT_EQ(map.obstacles.size(), 1u) << text;
    EXPECT_EQ(map.obstacles[0].outer, (Ring{{0, 0}, {4, 0}, {4, 4}})) << text;
  }
}

TEST(TextPolygons, ErrorsNameLineAndValue) {
  EXPECT_EQ(polygons_error("0 0 1 0 1 1\n0 0 1 0 1\n"),
            "map.txt: line 2: expected a number, as positions are x y, found the end of the line");
  EXPECT_EQ(polygons_error("0 0 1 0 1 one\n"),
            "map.txt: line 1: expected a number, as positions are x y, found \"one\"");
  EXPECT_EQ(polygons_error("0 0 1 0 1 inf\n"),
            "map.txt: line 1: expected a number, as positions are x y, found \"inf\"");
  EXPECT_EQ(polygons_error("0 0 1 0\n"),
            "map.txt: line 1: needs at least 3 different positions, found 2 in 2 positions");
}

}  // namespace
}  // namespace arcway::internal

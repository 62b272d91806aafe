#include "datasets/formats/vertex_list.h"

#include <gtest/gtest.h>

#include "tests/support/format_errors.h"

namespace arcway::internal {
namespace {

MapFile vertices_of(const std::string& text, const VectorOptions& options = {}) {
  return read_vertex_list(text, "map.csv", options);
}
std::string vertices_error(const std::string& text) {
  return test::format_error_of([&] { vertices_of(text); });
}

TEST(VertexList, ReadsPolygonsHoweverTheyAreParted) {
  const Ring first{{0, 0}, {1, 0}, {1, 1}}, second{{5, 5}, {6, 5}, {6, 6}};
  for (const char* text :
       {"0,0\n1,0\n1,1\n\n5,5\n6,5\n6,6\n", "0 0\r\n1 0\r\n1 1\r\n\r\n# the other\r\n5 5\r\n6 5\r\n6 6",
        "0;0\n1;0\n1;1\nnan;nan\n5;5\n6;5\n6;6\n", "0\t0\n1\t0\n1\t1\n0\t0\n5\t5\n6\t5\n6\t6\n5\t5\n",
        "x,y\n0,0\n1,0\n1,1\n,\n5,5\n6,5\n6,6\n", "id,x,y\na,0,0\na,1,0\na,1,1\nb,5,5\nb,6,5\nb,6,6\n",
        "\"Y\";\"X\";\"obstacle\"\n0;0;1\n0;1;1\n1;1;1\n5;5;2\n5;6;2\n6;6;2\n",
        "\xEF\xBB\xBF x , y \n 0 , 0 \n1, 0\n1, 1\n\n5,5\n6,5\n6,6"}) {
    const MapFile map = vertices_of(text);
    ASSERT_EQ(map.obstacles.size(), 2u) << text;
    EXPECT_EQ(map.obstacles[0].outer, first) << text;
    EXPECT_EQ(map.obstacles[1].outer, second) << text;
    EXPECT_TRUE(map.warnings.empty()) << text;
  }
  EXPECT_EQ(vertices_of("0,0\n1,0\n1,1\n\n5,5\n6,5\n6,6\n").places, (std::vector<std::string>{"line 1", "line 5"}));
}

TEST(VertexList, ReadsDecimalCommasBelowAHeaderWithSemicolons) {
  EXPECT_EQ(vertices_of("x;y\n0,5;0\n1,25;0\n1;1,75\n").obstacles.at(0).outer,
            (Ring{{0.5, 0.0}, {1.25, 0.0}, {1.0, 1.75}}));
  EXPECT_EQ(vertices_of("x;y\n0.5;0\n1.25;0\n1;1.75\n").obstacles.at(0).outer,
            (Ring{{0.5, 0.0}, {1.25, 0.0}, {1.0, 1.75}}));
  EXPECT_EQ(vertices_error("x;y\n0;0\n1,000,5;0\n1;1\n"), "map.csv: line 3: expected a number, found \"1,000,5\"");
  EXPECT_NE(vertices_error("0,5;0\n1,25;0\n1;1,75\n").find("allows decimal commas"), std::string::npos);
}

TEST(VertexList, SaysWhatItLeavesOut) {
  EXPECT_EQ(vertices_of("x,y,z\n0,0,7\n1,0,7\n1,1,7\n").warnings.at(0),
            "map.csv: line 1: columns that are not read: \"z\"");
  EXPECT_NE(vertices_of("lat,lon\n48,8\n48,9\n49,9\n").warnings.at(0).find("are degrees"), std::string::npos);
  EXPECT_EQ(vertices_error("0,0\n1,0\n1\n"),
            "map.csv: line 3: expected 2 numbers, found 1 in \"1\"; a first line as \"id,x,y\" names columns, "
            "one as \"id;x;y\" allows decimal commas");
  EXPECT_EQ(vertices_error("0,0\n1,b\n"), "map.csv: line 2: expected a number, found \"b\"");
  EXPECT_NE(vertices_error("0,0\n1,0\n").find("line 1: needs at least 3 different positions"), std::string::npos);
}

}  // namespace
}  // namespace arcway::internal

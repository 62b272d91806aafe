#include "datasets/formats/tpcap.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/format_errors.h"

namespace arcway::internal {
namespace {

constexpr const char* kCase = "1,2,0.5,20,3,-1,2,3,4,10,10,12,10,12,12,0,20,0,22,2,22,2,20";

std::string tpcap_error(const std::string& text) {
  return test::format_error_of([&] { read_tpcap(text, "Case.csv"); });
}

TEST(Tpcap, ReadsACaseWithItsPoses) {
  std::string column = kCase;
  std::replace(column.begin(), column.end(), ',', '\n');
  for (const std::string& text : {std::string(kCase), column, std::string(kCase) + "\r\n"}) {
    const MapFile map = read_tpcap(text, "Case.csv");
    ASSERT_EQ(map.obstacles.size(), 2u) << text;
    EXPECT_EQ(map.obstacles[0].outer, (Ring{{10, 10}, {12, 10}, {12, 12}}));
    EXPECT_EQ(map.obstacles[1].outer, (Ring{{0, 20}, {0, 22}, {2, 22}, {2, 20}}));
    EXPECT_EQ(map.start->x, 1);
    EXPECT_EQ(map.start->heading, 0.5);
    EXPECT_EQ(map.goal->y, 3);
    EXPECT_EQ(map.goal->heading, -1);
    EXPECT_EQ(map.bounds, (Ring{{-11, -10}, {32, -10}, {32, 22}, {-11, 22}}));
  }
}

TEST(Tpcap, FarCasesAreMovedWithoutRounding) {
  const MapFile map = read_tpcap(
      "4484378811.2464499,-354286007.5,0,4484378820,-354286000,0,1,3,"
      "4484378811.25,-354286007.5,4484378812.25,-354286007.5,4484378812.25,-354286006.5",
      "Case.csv");
  ASSERT_EQ(map.notes.size(), 1u);
  EXPECT_EQ(map.notes[0], "moved by (-4484378811, 354286008) m");
  EXPECT_EQ(map.start->x, 4484378811.2464499 - 4484378811.0);
  EXPECT_EQ(map.obstacles[0].outer, (Ring{{0.25, 0.5}, {1.25, 0.5}, {1.25, 1.5}}));
}

TEST(Tpcap, ErrorsNameWhatIsMissing) {
  EXPECT_EQ(tpcap_error("1,2"), "Case.csv: line 1: expected heading of the start, found the end of the file");
  EXPECT_EQ(tpcap_error("1,2,0,\n2,3,0,1.5"),
            "Case.csv: line 2: expected the number of obstacles as a whole number, found \"1.5\"");
  EXPECT_EQ(tpcap_error("1,2,0,2,3,0,1,3,1,1,2,1"),
            "Case.csv: line 1: expected x of a vertex of obstacle 0, found the end of the file");
  EXPECT_EQ(tpcap_error(std::string(kCase) + ",7"),
            "Case.csv: line 1: expected the end of the file after all obstacles, found \"7\"");
  EXPECT_EQ(tpcap_error("1,2,0,2,3,0,1,2,1,1,2,1"),
            "Case.csv: obstacle 0: needs at least 3 different positions, found 2 in 2 positions");
  EXPECT_NE(tpcap_error("1,2,0,2,3,0,1e300").find("whole number"), std::string::npos);
  EXPECT_NE(tpcap_error("1,2,0,2,3,0,9999999,9999999").find("vertices of obstacle 1"), std::string::npos);
}

}  // namespace
}  // namespace arcway::internal

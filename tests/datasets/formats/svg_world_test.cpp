#include "datasets/formats/svg_world.h"

#include <gtest/gtest.h>

namespace arcway {
namespace {

std::string svg(const std::string& body) { return "<svg viewBox=\"1 2 30 20\">\n" + body + "\n</svg>"; }
std::string path(const std::string& d) { return svg("<path id=\"a\" d=\"" + d + "\"/>"); }
MapFile read(const std::string& text) { return read_svg_world(text, "w.svg"); }
std::string error_of(const std::string& text) {
  try {
    read(text);
  } catch (const FormatError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SvgWorld, ReadsAllCommandsWithYUp) {
  const Ring square{{1, -1}, {5, -1}, {5, -5}, {1, -5}};
  for (const char* d : {"M1,1 L5,1 L5,5 L1,5 Z", "m 1 1 h 4 v 4 h -4 z", "M1 1H5V5H1", "M1 1 5 1 5 5 1 5",
                        "m1,1 4,0 0,4-4,0 0-4", "M 1e0 +1 l4 0l0 4.l-4.0.0 v 0"}) {
    const MapFile map = read(path(d));
    ASSERT_EQ(map.obstacles.size(), 1u) << d;
    EXPECT_EQ(map.obstacles[0].outer, square) << d;
  }
  EXPECT_EQ(read(path("M0 0H1V1Z")).bounds, (Ring{{1, -22}, {31, -22}, {31, -2}, {1, -2}}));
}

TEST(SvgWorld, AppliesNestedTransforms) {
  const MapFile map =
      read(svg("<g transform='translate(10,-3)'><g transform='scale(2) translate(1)'><path d='M0 0H1V1Z' "
               "transform='scale(1,3)'/></g></g>"));
  ASSERT_EQ(map.obstacles.size(), 1u);
  EXPECT_EQ(map.obstacles[0].outer, (Ring{{12, 3}, {14, 3}, {14, -3}}));
}

TEST(SvgWorld, SubpathsInsideAreHoles) {
  const MapFile map = read(path("M0 0H9V9H0Z M1 1h7v7h-7z m1 1h3v3h-3z M20 0h1v1z"));
  ASSERT_EQ(map.obstacles.size(), 3u);
  EXPECT_EQ(map.obstacles[0].holes.size(), 1u);
  EXPECT_EQ(map.obstacles[1].outer[0], Vec2(2, -2));
  EXPECT_TRUE(map.obstacles[1].holes.empty());
}

TEST(SvgWorld, ClosesOutlinesThatRoundingLeftOpen) {
  const MapFile map = read(path("m0 0h10v10h-10l0.0001-9.9999"));
  ASSERT_EQ(map.obstacles.size(), 1u);
  EXPECT_EQ(map.obstacles[0].outer.size(), 4u);
  EXPECT_EQ(map.notes.size(), 1u);
}

TEST(SvgWorld, PassesOverWhatIsNotDrawn) {
  const MapFile map =
      read(svg("<defs><circle/></defs><metadata/><sodipodi:namedview/><title>t</title><path d='M1 1'/>"));
  EXPECT_TRUE(map.obstacles.empty());
  EXPECT_EQ(map.warnings.size(), 1u);
}

TEST(SvgWorld, OthersAreRejectedByName) {
  EXPECT_EQ(error_of(path("M0 0 C 1 1 2 2 3 3")),
            "w.svg: line 2, path \"a\": path command \"C\" is not supported, only M L H V Z and m l h v z are");
  EXPECT_NE(error_of(svg("<circle r='3'/>")).find("line 2, circle: element <circle> is not supported"),
            std::string::npos);
  EXPECT_NE(error_of(svg("<g transform='rotate(3)'/>")).find("transform \"rotate(3)\" is not supported"),
            std::string::npos);
  EXPECT_NE(error_of(path("M0 0 L1")).find("expected a number after path command"), std::string::npos);
  EXPECT_NE(error_of(path("L1 1")).find("begins with M"), std::string::npos);
  EXPECT_NE(error_of("<svg>\n<g>\n</svg>").find("w.svg: line 3"), std::string::npos) << error_of("<svg>\n<g>\n</svg>");
  EXPECT_NE(error_of("<html/>").find("expected <svg>"), std::string::npos);
  std::string deep;
  for (int i = 0; i < 5000; ++i) deep += "<g>";
  for (int i = 0; i < 5000; ++i) deep += "</g>";
  EXPECT_NE(error_of(svg(deep)).find("nested"), std::string::npos);
}

}  // namespace
}  // namespace arcway

#include "datasets/formats/svg_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "arcway/polygon.h"
#include "tests/support/format_errors.h"

namespace arcway::internal {
namespace {

std::string svg(const std::string& body) { return "<svg viewBox=\"1 2 30 20\">\n" + body + "\n</svg>"; }
std::string path(const std::string& d) { return svg("<path id=\"a\" d=\"" + d + "\"/>"); }
MapFile svg_of(const std::string& text) { return read_svg_world(text, "w.svg"); }
std::string svg_error(const std::string& text) {
  return test::format_error_of([&] { svg_of(text); });
}

TEST(SvgWorld, ReadsAllCommandsWithYUp) {
  const Ring square{{1, -1}, {5, -1}, {5, -5}, {1, -5}};
  for (const char* d : {"M1,1 L5,1 L5,5 L1,5 Z", "m 1 1 h 4 v 4 h -4 z", "M1 1H5V5H1", "M1 1 5 1 5 5 1 5",
                        "m1,1 4,0 0,4-4,0 0-4", "M 1e0 +1 l4 0l0 4.l-4.0.0 v 0"}) {
    const MapFile map = svg_of(path(d));
    ASSERT_EQ(map.obstacles.size(), 1u) << d;
    EXPECT_EQ(map.obstacles[0].outer, square) << d;
  }
  EXPECT_EQ(svg_of(path("M0 0H1V1Z")).bounds, (Ring{{1, -22}, {31, -22}, {31, -2}, {1, -2}}));
}

// What the ring must be off the outline: outside of it, or on it but for rounding, and within the tolerance.
void expect_round(const Ring& ring, const Vec2& center, double radius, double tolerance) {
  ASSERT_EQ(winding(ring), 1);
  ASSERT_FALSE(find_conflict({ring, {}}));
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const double t = std::clamp((center - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    EXPECT_GE((a + t * (b - a) - center).norm(), radius * (1.0 - 1e-8));
    EXPECT_LE((a - center).norm(), radius * (1.0 + 1e-8) + 2.0 * tolerance);
  }
}

TEST(SvgWorld, CurvesBecomeRingsAroundThem) {
  constexpr double kTolerance = 0.01;
  const auto ring_of = [&](const std::string& d) {
    const MapFile map = read_svg_world(path(d), "w.svg", {.curve_tolerance = kTolerance});
    EXPECT_EQ(map.obstacles.size(), 1u) << d;
    return map.obstacles[0].outer;
  };
  // A circle of radius 5 around (10, 10), by arcs either way round, of any share, with flags that stand together.
  for (const char* d : {"M5 10 A5 5 0 0 1 15 10 A5 5 0 0 1 5 10Z", "M5 10a5 5 0 1 0 10 0a5 5 0 1 0-10 0z",
                        "M15 10a5,5 30 01-10 0 5 5 0 0110 0z", "M5 10 A1 1 0 0 1 15 10 A1 1 0 0 1 5 10"}) {
    SCOPED_TRACE(d);
    expect_round(ring_of(d), {10, -10}, 4.999, 0.1);
  }
  expect_round(ring_of("M5 10 A5 5 0 0 1 15 10 A5 5 0 0 1 5 10Z"), {10, -10}, 5.0, kTolerance);
  // One curve, drawn by each command: absolute, relative, with the smooth ones, quadratic.
  const Ring wave = ring_of("M0 0 C1 2 3 2 4 0 C5 -2 7 -2 8 0 V9 H0Z");
  EXPECT_EQ(ring_of("m0 0 c1 2 3 2 4 0 s3-2 4 0 v9 h-8z"), wave);
  EXPECT_EQ(ring_of("M0 0 C1 2 3 2 4 0 S7 -2 8 0 L8 9 0 9z"), wave);
  EXPECT_NE(std::find(wave.begin(), wave.end(), Vec2(8, -9)), wave.end());
  const Ring bump = ring_of("M0 0 Q2 3 4 0 Q6 -3 8 0 V9 H0Z");
  EXPECT_EQ(ring_of("M0 0 Q2 3 4 0 T8 0 V9 H0Z"), bump);
  EXPECT_EQ(ring_of("m0 0 q2 3 4 0 t4 0 v9 h-8z"), bump);
  // Without one before, the smooth ones begin straight on.
  EXPECT_EQ(ring_of("M0 0 S5 5 8 0 V9H0Z"), ring_of("M0 0 C0 0 5 5 8 0 V9H0Z"));
  EXPECT_EQ(read_svg_world(path("M0 0 T8 0 V9H0Z"), "w").obstacles[0].outer.size(), 4u);
  // An arc without a radius is a line.
  EXPECT_EQ(ring_of("M0 0 A0 3 0 0 1 8 0 V9 H0 Z"), ring_of("M0 0 H8 V9 H0 Z"));
}

TEST(SvgWorld, CurvedHolesLieInsideTheirOutline) {
  const MapFile map = svg_of(path("M0 0H20V20H0Z M5 10a5 5 0 1 0 10 0a5 5 0 1 0-10 0z"));
  ASSERT_EQ(map.obstacles.size(), 1u);
  ASSERT_EQ(map.obstacles[0].holes.size(), 1u);
  for (const Vec2& p : map.obstacles[0].holes[0]) EXPECT_LE((p - Vec2(10, -10)).norm(), 5.0 + 1e-8);
  EXPECT_EQ(winding(map.obstacles[0].holes[0]), -1);
}

TEST(SvgWorld, AppliesNestedTransforms) {
  const MapFile map =
      svg_of(svg("<g transform='translate(10,-3)'><g transform='scale(2) translate(1)'><path d='M0 0H1V1Z' "
                 "transform='scale(1,3)'/></g></g>"));
  ASSERT_EQ(map.obstacles.size(), 1u);
  EXPECT_EQ(map.obstacles[0].outer, (Ring{{12, 3}, {14, 3}, {14, -3}}));
}

TEST(SvgWorld, SubpathsInsideAreHoles) {
  const MapFile map = svg_of(path("M0 0H9V9H0Z M1 1h7v7h-7z m1 1h3v3h-3z M20 0h1v1z"));
  ASSERT_EQ(map.obstacles.size(), 3u);
  EXPECT_EQ(map.obstacles[0].holes.size(), 1u);
  EXPECT_EQ(map.obstacles[1].outer[0], Vec2(2, -2));
  EXPECT_TRUE(map.obstacles[1].holes.empty());
}

TEST(SvgWorld, ClosesOutlinesThatRoundingLeftOpen) {
  const MapFile map = svg_of(path("m0 0h10v10h-10l0.0001-9.9999"));
  ASSERT_EQ(map.obstacles.size(), 1u);
  EXPECT_EQ(map.obstacles[0].outer.size(), 4u);
  EXPECT_EQ(map.notes.size(), 1u);
}

TEST(SvgWorld, PassesOverWhatIsNotDrawn) {
  const MapFile map =
      svg_of(svg("<defs><circle/></defs><metadata/><sodipodi:namedview/><title>t</title><path d='M1 1'/>"));
  EXPECT_TRUE(map.obstacles.empty());
  EXPECT_EQ(map.warnings.size(), 1u);
}

// Two paths: at x = 1 what may be hidden, at x = 5 what never is.
std::vector<double> shown(const std::string& hidden, const std::string& style = "") {
  const MapFile map =
      svg_of(svg((style.empty() ? "" : "<style>" + style + "</style>") + hidden + "<path d='M5 0h1v1z'/>"));
  std::vector<double> result;
  for (const Polygon& polygon : map.obstacles) result.push_back(polygon.outer[0].x());
  EXPECT_EQ(map.notes.size(), result.size() == 1 ? 1u : 0u);
  return result;
}
constexpr const char* kPath = "<path d='M1 0h1v1z'/>";

TEST(SvgWorld, HiddenShapesAreNoObstacles) {
  const std::vector<double> one{5}, both{1, 5};
  const std::string path = kPath;
  const auto with = [](const std::string& attributes) { return "<path d='M1 0h1v1z' " + attributes + "/>"; };
  for (const std::string& hidden : std::vector<std::string>{
           "<g style='display:none'>" + path + "</g>", "<g style='fill:red; display : none ;'><g>" + path + "</g></g>",
           "<g display='none'>" + path + "</g>", "<g visibility='hidden'><g>" + path + "</g></g>",
           with("style='visibility:hidden'"), with("visibility='collapse'"), with("display='none'"),
           "<g style='display:none'><g style='display:inline'><path visibility='visible' d='M1 0h1v1z'/></g></g>",
           "<g xmlns:inkscape='i' inkscape:groupmode='layer' inkscape:label='old' style='display:none'>" + path +
               "</g>",
           "<g display='none'><path d='M1 0h1v1z'/><rect/><image transform='rotate(3)'/></g>",
           "<svg visibility='hidden'>" + path + "</svg>"})
    EXPECT_EQ(shown(hidden), one) << hidden;
  for (const std::string& drawn :
       std::vector<std::string>{"<g visibility='hidden'><path visibility='visible' d='M1 0h1v1z'/></g>",
                                with("style='display:inline' display='none'"), with("style='fill:none;stroke:none'"),
                                with("display='inline'")})
    EXPECT_EQ(shown(drawn), both) << drawn;
}

TEST(SvgWorld, RulesHideShapes) {
  const std::vector<double> one{5}, both{1, 5};
  const std::string path = "<g id='old' class='a b'><g class='c'><path class='x y' d='M1 0h1v1z'/></g></g>";
  for (const char* rule :
       {".a{display:none}", "g.b { visibility: hidden }", "#old{display:none}", ".x.y{display:none}",
        ".z, .y{display:none}", "g .x{display:none}", "g>g>path{display:none}", "#old path{display:none}",
        "/* . */.x{fill:red;display:none;}", "@media screen{.x{display:none}}", "@import url(a); .x{display:none}",
        ".x{display:inline}.x{display:none}", ".x{display:none!important}path.x.y{display:inline}"})
    EXPECT_EQ(shown(path, rule), one) << rule;
  for (const char* rule : {".d{display:none}", "svg>path.x{display:none}", "@media print{.x{display:none}}",
                           ".x{display:none}.x{display:inline}", "#old .x{display:inline}.x{display:none}",
                           "rect{display:none}", "/*.x{display:none}*/", "}", "{", "@"})
    EXPECT_EQ(shown(path, rule), both) << rule;
  EXPECT_EQ(shown("<path class='x' style='display:inline' d='M1 0h1v1z'/>", ".x{display:none}"), both);
  EXPECT_EQ(shown("<path class='x' style='display:inline' d='M1 0h1v1z'/>", ".x{display:none !important}"), one);
  const MapFile map = svg_of(svg("<style>path[id=\"a\"]{display:none}</style>" + std::string(kPath)));
  EXPECT_EQ(map.obstacles.size(), 1u);
  std::string selector, deep = kPath;  // of which every choice of ancestors fails
  for (int i = 0; i < 40; ++i) selector += "g ";
  for (int i = 0; i < 90; ++i) deep = "<g>" + deep + "</g>";
  EXPECT_EQ(svg_of(svg("<style>.a " + selector + "path{display:none}</style>" + deep)).obstacles.size(), 1u);
  EXPECT_NE(map.warnings.at(0).find("is not understood; what it may hide is kept"), std::string::npos);
}

TEST(SvgWorld, PathsAreFreeSpaceWhenAsked) {
  const MapFile map = read_svg_world(path("M0 0H9V9H0Z M1 1h2v2h-2z"), "w.svg", {.free_polygons = true});
  EXPECT_EQ(map.bounds, (Ring{{0, 0}, {9, 0}, {9, -9}, {0, -9}}));
  EXPECT_EQ(map.obstacles.size(), 1u);
}

TEST(SvgWorld, PassesOverWhatIsDrawnElsewhereOnly) {
  EXPECT_EQ(svg_of(svg("<clipPath><path d='M1 0h1v1z'/></clipPath><symbol><rect/></symbol>" + std::string(kPath)))
                .obstacles.size(),
            1u);
}

TEST(SvgWorld, OthersAreRejectedByName) {
  EXPECT_EQ(svg_error(path("M0 0 R 1 1 2 2 3 3")), "w.svg: line 2, path \"a\": path command \"R\" is not known");
  EXPECT_NE(svg_error(path("M0 0 A 1 1 0 2 0 3 3")).find("expected a flag, 0 or 1"), std::string::npos);
  EXPECT_NE(svg_error(path("M0 0 C 1 1 2 2 3")).find("expected a number after path command \"C\""), std::string::npos);
  EXPECT_NE(svg_error(path("M0 0 C 9e99 0 9e99 9e99 0 9e99z")).find("line 2, path \"a\": circumscribed ring: piece 0"),
            std::string::npos);
  EXPECT_NE(svg_error(svg("<circle r='3'/>")).find("line 2, circle: element <circle> is not supported"),
            std::string::npos);
  EXPECT_NE(svg_error(svg("<g transform='rotate(3)'/>")).find("transform \"rotate(3)\" is not supported"),
            std::string::npos);
  EXPECT_NE(svg_error(path("M0 0 L1")).find("expected a number after path command"), std::string::npos);
  EXPECT_NE(svg_error(path("L1 1")).find("begins with M"), std::string::npos);
  EXPECT_NE(svg_error("<svg>\n<g>\n</svg>").find("w.svg: line 3"), std::string::npos)
      << svg_error("<svg>\n<g>\n</svg>");
  EXPECT_NE(svg_error("<html/>").find("expected <svg>"), std::string::npos);
  EXPECT_NE(svg_error("<kml/>").find("this is a KML document"), std::string::npos);
  EXPECT_LT(svg_error(svg("<" + std::string(100'000, 'q') + "/>")).size(), 300u);
  EXPECT_LT(svg_error("<" + std::string(100'000, 'q') + "/>").size(), 300u);
  std::string deep;
  for (int i = 0; i < 5000; ++i) deep += "<g>";
  for (int i = 0; i < 5000; ++i) deep += "</g>";
  EXPECT_NE(svg_error(svg(deep)).find("nested"), std::string::npos);
}

}  // namespace
}  // namespace arcway::internal

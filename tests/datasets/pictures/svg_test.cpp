#include "arcway/datasets/svg.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "arcway/datasets/file_io.h"
#include "arcway/datasets/paper_example.h"
#include "arcway/planner.h"
#include "arcway/trajectory.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "arcway/zone.h"

namespace arcway::internal {
namespace {

std::size_t count(const std::string& text, std::string_view part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Svg, DrawsLayersWithYUp) {
  const World world({{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{2, 2}, {2, 3}, {3, 3}}}}},
                    Ring{{-10, -10}, {90, -10}, {90, 40}, {-10, 40}});
  SvgPicture picture(world, 1000.0);
  const std::vector<LineSegment> edges{{{0, 0}, {10, 10}}, {{0, 10}, {20, 20}}};
  picture.add_edges(edges);
  const Path path{{{20, 20, 0}, 10, 0}, {{30, 20, 0}, 3, 0.5}};
  picture.add_path(path, Footprint{.front = 1.4, .rear = 0.1, .left = 0.4, .right = 0.4});
  picture.add_caption("a < b & \"c\"");
  picture.set_title("T<1>", "D");
  const std::string svg = picture.str();
  for (const char* part : {"<g id=\"bounds\"", "<g id=\"obstacles\" fill-rule=\"evenodd\"", "<g id=\"graph\"",
                           "<g id=\"path\"", "<g id=\"robot\"", "<g id=\"markers\"", "<title>T&lt;1&gt;</title>",
                           "<desc>D</desc>", "a &lt; b &amp; &quot;c&quot;"})
    EXPECT_EQ(count(svg, part), 1u) << part;
  // 10 px a meter below a border of 16 px: (0, 0) is 40 m below the top.
  EXPECT_NE(svg.find("<g id=\"map\" transform=\"matrix(10 0 0 -10 116 416)\">"), std::string::npos) << svg;
  EXPECT_NE(svg.find("M0 0L10 0L10 10L0 10ZM2 2"), std::string::npos) << svg;
  EXPECT_NE(svg.find("M0 0L10 10M0 10L20 20"), std::string::npos);
  EXPECT_EQ(count(svg, "<g"), count(svg, "</g>"));
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(Svg, DrawsTheSweptArea) {
  SvgPicture picture(World({}, Ring{{0, 0}, {100, 0}, {100, 50}, {0, 50}}), 1000.0);
  EXPECT_EQ(count(picture.str(), "id=\"swept\""), 0u);
  const Footprint body{.front = 2, .rear = 1, .left = 1, .right = 1};
  picture.add_swept_area(Path{{{20, 20, 0}, 10, 0}}, body);
  // One rectangle for a line.
  EXPECT_NE(picture.str().find("M19 19L32 19L32 21L19 21Z"), std::string::npos) << picture.str();
  picture.add_swept_area(Path{{{20, 20, 0}, 10, 0}}, Footprint{.front = 2, .rear = 1, .left = 3, .right = 0.5});
  EXPECT_NE(picture.str().find("M19 19.5L32 19.5L32 23L19 23Z"), std::string::npos) << picture.str();
  picture.add_swept_area(Path{{{20, 20, 0}, 5, 0.2}}, body);
  // The farthest corner is hypot(2, 6) from the turning center: outlines a pixel apart over one radian.
  EXPECT_GE(count(picture.str(), "Z"), 63u);
}

// A body of two parts, one of them with a notch: its outline has no lines between convex pieces.
TEST(Svg, DrawsBodiesOfAnyOutline) {
  VehicleParameters parameters;
  parameters.footprint = {{{-1, -1}, {2, -1}, {1, 0}, {2, 1}, {-1, 1}}, {{3, 0}, {4, 0}, {4, 1}}};
  const Vehicle vehicle(parameters);
  SvgPicture picture(World({}, Ring{{0, 0}, {100, 0}, {100, 50}, {0, 50}}), 1000.0);
  const PathSegment line{{20, 20, 0}, 10, 0};
  picture.add_bodies(std::vector{line.start}, vehicle.body());
  EXPECT_NE(picture.str().find("M19 19L22 19L21 20L22 21L19 21ZM23 20L24 20L24 21Z"), std::string::npos)
      << picture.str();
  picture.add_swept_area(Path{line}, vehicle.body());
  EXPECT_EQ(count(picture.str(), "Z"), 6u);  // bounds, two parts, and the way of three pieces
  EXPECT_NE(picture.str().find("M23 20L34 20L34 21L24 21Z"), std::string::npos) << picture.str();
}

TEST(Svg, DrawsReverseDashed) {
  SvgPicture picture(World({}, Ring{{0, 0}, {100, 0}, {100, 50}, {0, 50}}), 1000.0);
  const Footprint body{.front = 2, .rear = 1, .left = 1, .right = 1};
  const PathSegment ahead{{20, 20, 0}, 10, 0};
  const Path path{ahead, {ahead.end(), 5, 0, Gear::kReverse}, {ahead.at(5), 5, 0}};
  picture.add_path(path, body, "a text");
  EXPECT_EQ(count(picture.str(), "stroke-dasharray"), 1u);
  EXPECT_NE(picture.str().find("forwards, <tspan fill=\"#1f6fd1\">\u25A0</tspan> backwards</text>"), std::string::npos);
  EXPECT_LT(picture.str().find(">a text</text>"), picture.str().find("forwards"));
  EXPECT_NE(picture.str().find("M30 20L25 20\" stroke=\"#1f6fd1\""), std::string::npos) << picture.str();
  picture.add_swept_area(Path{path[1]}, body);  // x from 24 to 32
  EXPECT_NE(picture.str().find("M24 19L32 19L32 21L24 21Z"), std::string::npos);
}

TEST(Svg, AlternativesDifferInColorAndHaveALegend) {
  const Path path{{{1, 1, 0}, 4.0, 0.0}}, back{{{1, 2, 0}, 4.0, 0.0, Gear::kReverse}};
  SvgPicture svg(World({}, Ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}}));
  svg.add_alternative(path, {1.0, 0.5, 0.4, 0.4}, "second & so on");
  svg.add_alternative(back, {1.0, 0.5, 0.4, 0.4}, "third");
  svg.add_path(path, {1.0, 0.5, 0.4, 0.4}, "first");
  const std::string text = svg.str();
  EXPECT_LT(text.find("first</text>"), text.find("second &amp;"));
  EXPECT_NE(text.find(">dashed: backwards</text>"), std::string::npos);
  for (const char* color : {"#e4572e", "#0072b2", "#009e73"}) {
    EXPECT_NE(text.find(std::string("stroke=\"") + color), std::string::npos) << color;
    EXPECT_NE(text.find(std::string("<tspan fill=\"") + color), std::string::npos) << color;
  }
  EXPECT_NE(text.find("second &amp; so on"), std::string::npos);
  EXPECT_NE(text.find("stroke-dasharray"), std::string::npos);
}

TEST(Svg, ExplainsGearsOnlyWhereBothAreDriven) {
  SvgPicture svg(World({}, Ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}}));
  svg.add_path(Path{{{1, 1, 0}, 4.0, 0.0}}, {1.0, 0.5, 0.4, 0.4}, "text");
  EXPECT_EQ(svg.str().find("backwards"), std::string::npos);
  EXPECT_EQ(svg.str().find("tspan"), std::string::npos);
}

TEST(Svg, MarksPlacesOnTheWay) {
  SvgPicture svg(World({}, Ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}}), 100.0);
  svg.add_place({5, 5}, "waypoint 1");
  EXPECT_NE(svg.str().find("<circle cx=\"66\" cy=\"66\""), std::string::npos) << svg.str();
  EXPECT_NE(svg.str().find(">waypoint 1</text>"), std::string::npos);
}

TEST(Svg, LabelsLieBesideTheArrows) {
  const auto label_of = [](double heading) {
    SvgPicture svg(World({}, Ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}}));
    svg.add_poses({5, 5, heading}, {1, 1, 0}, Footprint{.front = 1.0, .rear = 0.5, .left = 0.4, .right = 0.4});
    const std::string text = svg.str();
    const std::size_t at = text.find(" y=\"", text.find("<text x="));
    return std::stod(text.substr(at + 4));
  };
  const double middle = 608.0;  // of the picture
  EXPECT_LT(label_of(0.0), middle);
  EXPECT_LT(label_of(-0.4), middle);
  EXPECT_GT(label_of(0.4), middle);
  EXPECT_GT(label_of(1.57), middle);
}

TEST(Svg, MarksAGap) {
  SvgPicture svg(World({}, Ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}}));
  svg.add_gap({5, 4}, {5, 4.5}, "0.5 m");
  EXPECT_NE(svg.str().find(">0.5 m</text>"), std::string::npos);
  EXPECT_NE(svg.str().find("<g id=\"markers\""), std::string::npos);
}

TEST(Svg, MarksMetersAndHasAScaleBar) {
  SvgPicture picture(World({}, Ring{{-20, 100}, {80, 100}, {80, 150}, {-20, 150}}), 1000.0);
  picture.add_axes();
  const std::string svg = picture.str();
  // 10 px a meter: marks each 10 m, and a bar of 10 m.
  for (const char* label : {">0</text>", ">10</text>", ">70</text>", ">110</text>", ">140</text>", ">10 m</text>"})
    EXPECT_EQ(count(svg, label), 1u) << label;
  const std::size_t bar = svg.find("id=\"scale\"");
  const std::string line = svg.substr(svg.find(" d=\"M", bar) + 5);
  const double begin = std::stod(line), end = std::stod(line.substr(line.find('L') + 1));
  EXPECT_NEAR(end - begin, 100.0, 0.11);
  // The mark of x = 10 m is 30 m right of the view's edge.
  const std::size_t ten = svg.find(">10</text>");
  EXPECT_NEAR(std::stod(svg.substr(svg.rfind(" x=\"", ten) + 4)), 16.0 + 300.0, 0.11);
}

TEST(Svg, NumbersObstaclesAsMessagesDo) {
  const World world({{{{0, 0}, {10, 0}, {10, 10}}, {}}, {{{20, 0}, {40, 0}, {40, 10}, {20, 10}}, {}}});
  SvgPicture picture(world, 400.0);
  picture.add_obstacle_numbers(world);
  const std::string svg = picture.str();
  const std::size_t one = svg.find(">1</text>");
  ASSERT_NE(one, std::string::npos);
  EXPECT_NEAR(std::stod(svg.substr(svg.rfind(" x=\"", one) + 4)), 16.0 + 300.0, 0.11);
  EXPECT_EQ(count(svg, ">0</text>"), 1u);
}

TEST(Svg, ColorsThePathBySpeed) {
  const Path path{{{0, 0, 0}, 30.0, 0.0}, {{30, 0, 0}, 10.0, 0.0, Gear::kReverse}};
  SvgPicture picture(World({}, Ring{{-5, -10}, {50, -10}, {50, 10}, {-5, 10}}));
  picture.add_path(path, Vehicle{}.footprint());
  picture.add_speeds(Trajectory(path, Vehicle{}));
  const std::string svg = picture.str();
  EXPECT_NE(svg.find(">12 m/s</text>"), std::string::npos);
  EXPECT_NE(svg.find("fill=\"url(#speeds)\""), std::string::npos);
  EXPECT_GE(count(svg, "stroke=\"#fde725\""), 1u);  // the highest speed
  EXPECT_GE(count(svg, "stroke-dasharray"), 1u);    // backwards
  EXPECT_EQ(count(svg, "#e4572e"), 0u);
  EXPECT_EQ(svg.find("{y}"), std::string::npos);
}

TEST(Svg, MagnifiesAPlaceInTheCornerThatThePathLeavesFree) {
  const Path path{{{5, 5, 0}, 90.0, 0.0}, {{95, 5, kPi / 2}, 90.0, 0.0}, {{95, 95, kPi}, 45.0, 0.0}};
  SvgPicture picture(World({}, Ring{{0, 0}, {100, 0}, {100, 100}, {0, 100}}), 1000.0);
  picture.add_path(path, {1.4, 0.1, 0.4, 0.4});
  picture.add_inset({95, 5}, 4.0, "2 < 3");
  const std::string svg = picture.str();
  // The place: 4 m of 10 px each about (95, 5), whose pixel is 16 + 950, 16 + 950.
  EXPECT_NE(svg.find("viewBox=\"946 946 40 40\""), std::string::npos);
  EXPECT_NE(svg.find("<use href=\"#map\"/>"), std::string::npos);
  // Its corner is the upper left one: the path runs through the others, or nearly to the middle of that side.
  EXPECT_NE(svg.find("<svg x=\"44\" y=\"44\""), std::string::npos);
  EXPECT_NE(svg.find(">2 &lt; 3</text>"), std::string::npos);
  SvgPicture plain(World({}, Ring{{0, 0}, {100, 0}, {100, 100}, {0, 100}}), 1000.0);
  EXPECT_EQ(plain.str().find("inset"), std::string::npos);
}

TEST(Svg, IsWrittenOfAPlan) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "arcway_plan.svg";
  const Planner planner(World({Polygon::rectangle({8, -4}, {12, 4})}), Vehicle{});
  write_svg(path, planner.plan({0, 0, 0}, {20, 0, 0}));
  const std::string solved = read_file(path);
  for (const char* layer : {"obstacles", "swept", "path", "axes", "legend"})
    EXPECT_EQ(count(solved, "id=\"" + std::string(layer) + "\""), 1u) << layer;
  write_svg(path, planner.plan({0, 0, 0}, {10, 0, 0}));
  EXPECT_NE(read_file(path).find("goal in collision (proved)"), std::string::npos);
  std::filesystem::remove(path);
  EXPECT_THROW(write_svg(path, PlanResult{}), std::invalid_argument);
}

TEST(Svg, KeepsTextsOnThePage) {
  const std::string label = "waypoint 12 of the second tour";
  const double room = 8.0 * static_cast<double>(label.size());
  for (const double x : {0.0, 3.0, 5.0, 9.0, 10.0}) {
    SvgPicture picture(World({}, Ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}}), 400.0);
    picture.add_place({x, 5}, label);
    const std::string svg = picture.str();
    const std::size_t text = svg.rfind("<text", svg.find(label));
    const double at = std::stod(svg.substr(svg.find(" x=\"", text) + 4));
    const bool to_the_left = svg.find("text-anchor=\"end\"", text) < svg.find(label);
    EXPECT_GE(to_the_left ? at - room : at, 0.0) << x;
    EXPECT_LE(to_the_left ? at : at + room, 432.0) << x;
  }
  SvgPicture picture(World({}, Ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}}), 400.0);
  std::string reason;
  for (int i = 0; i < 40; ++i) reason += "no gap & ";
  picture.add_caption(reason);
  const std::string svg = picture.str();
  EXPECT_EQ(count(svg, "no gap &amp;"), 40u);
  for (std::size_t at = svg.find("<text", svg.find("id=\"caption\"")); at != std::string::npos;
       at = svg.find("<text", at + 1)) {
    const std::string line = svg.substr(at, svg.find("</text>", at) - at);
    EXPECT_LT(count(line, "no gap"), 7u) << line;
  }
}

TEST(Svg, ShowsTheLayersAskedFor) {
  const World world = World({{{{0, 0}, {10, 0}, {10, 10}}, {}}}, Ring{{-10, -10}, {90, -10}, {90, 40}})
                          .with_zones({{{{{20, 0}, {30, 0}, {30, 9}}, {}}, SpeedLimit{2.5}}});
  const auto drawn = [&](const std::vector<std::string>& layers) {
    SvgPicture picture(world);
    picture.add_edges(std::vector<LineSegment>{{{0, 0}, {10, 10}}});
    const Path path{{{20, 20, 0}, 10, 0}};
    picture.add_path(path, Footprint{.front = 1.4, .rear = 0.1, .left = 0.4, .right = 0.4});
    picture.add_swept_area(path, Footprint{.front = 1.4, .rear = 0.1, .left = 0.4, .right = 0.4});
    picture.add_axes();
    picture.add_obstacle_numbers(world);
    picture.show(layers);
    return picture.str();
  };
  for (const std::string_view layer : SvgPicture::layers()) {
    const std::string svg = drawn({std::string(layer)});
    for (const std::string_view other : SvgPicture::layers())
      EXPECT_EQ(count(svg, "id=\"" + std::string(other) + "\""), layer == other ? 1u : 0u) << layer << ' ' << other;
    EXPECT_EQ(count(svg, "2.5 m/s"), layer == "zones" ? 1u : 0u) << layer;
  }
  EXPECT_THROW(drawn({"paths"}), std::invalid_argument);
}

TEST(Svg, KeepsDigitsFarFromTheOrigin) {
  const Vec2 far(5e6, -4e6);
  Ring box{{0.25, 0}, {10, 0}, {10, 10}, {0.25, 10}};
  for (Vec2& p : box) p += far;
  const std::string svg = SvgPicture(World({{box, {}}})).str();
  EXPECT_NE(svg.find("M0.25 0L10 0L10 10"), std::string::npos) << svg;
}

TEST(Svg, DrawsWorldsWithoutExtent) {
  EXPECT_EQ(SvgPicture(World({})).str().find("nan"), std::string::npos);
  Box point;
  point.extend(Vec2(3, 3));
  EXPECT_EQ(SvgPicture(World({}), point).str().find("inf"), std::string::npos);
}

TEST(PaperExample, HasEightObstaclesClearOfBothEnds) {
  const PaperExample example = paper_example();
  EXPECT_EQ(example.world.obstacle_count(), 8u);
  ASSERT_TRUE(example.world.has_bounds());
  EXPECT_EQ(example.world.box().max, Vec2(900, 600));
  for (ObstacleId o = 0; o < example.world.region_count(); ++o)
    for (const Pose& pose : {example.start, example.goal})
      EXPECT_EQ(example.world.locate(pose.position(), o), PointLocation::kOutside);
}

TEST(Svg, HatchesZonesWithALegend) {
  const World world =
      World({{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}}}, Ring{{-10, -10}, {90, -10}, {90, 40}, {-10, 40}})
          .with_zones({{{{{20, 0}, {30, 0}, {30, 9}}, {{{28, 2}, {29, 2}, {29, 3}}}}, KeepOut{}, "a<b"},
                       {{{{40, 0}, {50, 0}, {50, 9}}, {}}, KeepOut{{"van", "car"}}, ""},
                       {{{{60, 0}, {70, 0}, {70, 9}}, {}}, SpeedLimit{2.5}, "school"}});
  const std::string open = SvgPicture(world, 1000.0).str(),
                    closed = SvgPicture(world.for_vehicle(Vehicle{}), 1000.0).str();
  EXPECT_EQ(open, closed);
  for (const char* part :
       {"<g id=\"zones\" fill-rule=\"evenodd\"", "<pattern id=\"hatch-keepout\"", "<pattern id=\"hatch-speed_limit\"",
        "M20 0L30 0L30 9ZM28 2L29 2L29 3Z", "keepout: a&lt;b, zone 1 for van and car", "speed_limit: school 2.5 m/s"})
    EXPECT_EQ(count(open, part), 1u) << part;
  EXPECT_EQ(count(open, "fill=\"url(#hatch-keepout)\""), 2u);
  EXPECT_EQ(SvgPicture(world.with_zones({}), 1000.0).str().find("zone"), std::string::npos);
}

TEST(Svg, HatchesClearanceZonesWithTheirNumbers) {
  const World world = World({}, Ring{{0, 0}, {100, 0}, {100, 50}, {0, 50}})
                          .with_zones({{{{{20, 0}, {30, 0}, {30, 9}}, {}}, KeepClear{0.5, 10.0}, "hall"},
                                       {{{{40, 0}, {50, 0}, {50, 9}}, {}}, KeepClear{0.25, 0.0}, ""}});
  const std::string svg = SvgPicture(world, 1000.0).str();
  for (const char* part : {"<pattern id=\"hatch-clearance\"", "patternTransform=\"rotate(0)\"",
                           "clearance: hall 0.5 m, 10 s/m, zone 1 0.25 m, 0 s/m"})
    EXPECT_EQ(count(svg, part), 1u) << part << "\n" << svg;
  EXPECT_EQ(count(svg, "fill=\"url(#hatch-clearance)\""), 2u);
}

TEST(Svg, FillsOneWayZonesWithArrowsInTheirDirections) {
  const World world = World({}, Ring{{0, 0}, {100, 0}, {100, 50}, {0, 50}})
                          .with_zones({{{{{20, 0}, {30, 0}, {30, 9}}, {}}, OneWay{0.5 * kPi, 0.25}, "aisle"},
                                       {{{{40, 0}, {50, 0}, {50, 9}}, {}}, OneWay{-0.25, 0.0}, ""}});
  const std::string svg = SvgPicture(world, 1000.0).str();
  for (const char* part :
       {"<pattern id=\"hatch-one_way-0\"", "patternTransform=\"rotate(90)\"", "<pattern id=\"hatch-one_way-1\"",
        "patternTransform=\"rotate(-14.324)\"", "fill=\"url(#hatch-one_way-1)\"",
        "one_way: aisle 1.571 \u00B1 0.25 rad, zone 1 -0.25 \u00B1 0 rad"})
    EXPECT_NE(svg.find(part), std::string::npos) << part << "\n" << svg;
}

}  // namespace
}  // namespace arcway::internal

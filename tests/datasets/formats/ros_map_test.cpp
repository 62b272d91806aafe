#include "datasets/formats/ros_map.h"

#include <gtest/gtest.h>

#include "arcway/angle.h"
#include "arcway/datasets/file_io.h"
#include "tests/support/format_errors.h"

namespace arcway::internal {
namespace {

constexpr const char* kYaml =
    "image: a.pgm\nresolution: 0.05\norigin: [-1e1, 2, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

std::string with(const std::string& key, const std::string& value) {
  std::string text = kYaml;
  const std::size_t at = text.find(key + ":");
  if (at == std::string::npos) return text + key + ": " + value + "\n";
  return text.replace(at, text.find('\n', at) - at, key + ": " + value);
}
std::string ros_error(const std::string& text) {
  return test::format_error_of([&] { read_ros_map(text, "a.yaml"); });
}

GrayImage image_of(std::vector<std::uint16_t> samples, std::size_t width) {
  GrayImage image;
  image.width = width;
  image.height = samples.size() / width;
  image.samples = std::move(samples);
  return image;
}
std::vector<Cell> cells(const RosMap& map, const GrayImage& image) {
  std::vector<std::string> warnings;
  return to_grid(map, image, "a.yaml", warnings).cells;
}

constexpr Cell kFree = Cell::kFree, kOccupied = Cell::kOccupied, kUnknown = Cell::kUnknown;

TEST(RosMap, ReadsTheFile) {
  const RosMap map = read_ros_map(kYaml, "a.yaml");
  EXPECT_EQ(map.image, "a.pgm");
  EXPECT_EQ(map.resolution, 0.05);
  EXPECT_EQ(map.origin.x, -10.0);
  EXPECT_EQ(map.origin.y, 2.0);
  EXPECT_FALSE(map.negate);
  EXPECT_EQ(map.mode, RosMap::Mode::kTrinary);
  EXPECT_TRUE(read_ros_map(with("negate", "true"), "a").negate);
  EXPECT_EQ(read_ros_map(with("mode", "raw"), "a").mode, RosMap::Mode::kRaw);
  EXPECT_EQ(read_ros_map(with("origin", "\n  - 1.5\n  - 2 # y\n  - 0.5"), "a").origin.heading, 0.5);
}

TEST(RosMap, ThresholdsAreReached) {
  RosMap map = read_ros_map(kYaml, "a.yaml");
  map.occupied_thresh = 1.0;
  map.free_thresh = 0.0;
  EXPECT_EQ(cells(map, image_of({0, 128, 255}, 3)), (std::vector{kOccupied, kUnknown, kFree}));
}

TEST(RosMap, ErrorsNameLineAndValue) {
  EXPECT_EQ(ros_error(with("resolution", "fine")), "a.yaml: line 2: resolution: expected a number, found \"fine\"");
  EXPECT_EQ(ros_error(with("resolution", "0")), "a.yaml: line 2: resolution: expected a number above 0, found \"0\"");
  EXPECT_EQ(ros_error(with("origin", "[1, 2]")),
            "a.yaml: line 3: origin: expected three numbers [x, y, yaw], found a list of 2");
  EXPECT_EQ(ros_error(with("origin", "[1, .nan, 2]")), "a.yaml: line 3: origin[1]: expected a number, found \".nan\"");
  EXPECT_EQ(ros_error(with("negate", "maybe")),
            "a.yaml: line 4: negate: expected 0, 1, true or false, found \"maybe\"");
  EXPECT_EQ(ros_error(with("mode", "shades")),
            "a.yaml: line 7: mode: expected trinary, scale or raw, found \"shades\"");
  EXPECT_EQ(ros_error("image: a.pgm\n"), "a.yaml: missing key \"resolution\"");
  EXPECT_EQ(ros_error("image: a.pgm\nresolutoin: 1\n"),
            "a.yaml: missing key \"resolution\"; is it meant by \"resolutoin\"?");
  EXPECT_NE(ros_error("image: [\n"), "no error");
  EXPECT_NE(ros_error("just words"), "no error");
}

TEST(RosMap, NamesKeysThatItDoesNotRead) {
  const RosMap map = read_ros_map(std::string(kYaml) + "version: 1\nmod: raw\nfloor: 3\n", "a.yaml");
  std::vector<std::string> warnings;
  to_grid(map, image_of({0}, 1), "a.yaml", warnings);
  EXPECT_EQ(warnings, (std::vector<std::string>{"a.yaml: key \"mod\" is not read; did you mean \"mode\"?",
                                                "a.yaml: key \"floor\" is not read"}));
  EXPECT_EQ(read_ros_map("{image: m.pgm, resolution: 0.05, origin: [0,0,0], negate: 0, occupied_thresh: 0.65, "
                         "free_thresh: 0.196}",
                         "a")
                .resolution,
            0.05);
}

TEST(RosMap, ThresholdsDecide) {
  const RosMap map = read_ros_map(kYaml, "a.yaml");
  // 1 - 89/255 is 0.651, 1 - 90/255 is 0.647; 1 - 205/255 is 0.19608, 1 - 206/255 is 0.192.
  EXPECT_EQ(cells(map, image_of({0, 89, 90, 205, 206, 254}, 6)),
            (std::vector<Cell>{kOccupied, kOccupied, kUnknown, kUnknown, kFree, kFree}));
  RosMap negated = map;
  negated.negate = true;
  EXPECT_EQ(cells(negated, image_of({0, 255}, 2)), (std::vector<Cell>{kFree, kOccupied}));
  RosMap raw = map;
  raw.mode = RosMap::Mode::kRaw;
  EXPECT_EQ(cells(raw, image_of({0, 1, 100, 101, 255}, 5)),
            (std::vector<Cell>{kFree, kUnknown, kOccupied, kUnknown, kUnknown}));
  GrayImage masked = image_of({254, 254}, 2);
  masked.transparent = {true, false};
  EXPECT_EQ(cells(map, masked), (std::vector<Cell>{kUnknown, kFree}));
  GrayImage deep = image_of({65535, 100}, 2);
  deep.max_value = 65535;
  EXPECT_EQ(cells(map, deep), (std::vector<Cell>{kFree, kOccupied}));
}

TEST(RosMap, RowsAreFromTheTopAndTheOriginIsTheLowerLeftCorner) {
  std::vector<std::string> warnings;
  RosMap map = read_ros_map(kYaml, "a.yaml");
  map.resolution = 0.5;
  const OccupancyGrid grid = to_grid(map, image_of({0, 254, 254, 254}, 2), "a.yaml", warnings);
  EXPECT_EQ(grid.at(0, 1), kOccupied);
  EXPECT_EQ(grid.at(0, 0), kFree);
  EXPECT_EQ(grid.to_world({2, 1}), Vec2(-9.0, 2.5));
  EXPECT_TRUE(warnings.empty());
  map.origin.heading = kPi / 2.0;
  const OccupancyGrid turned = to_grid(map, image_of({0, 254, 254, 254}, 2), "a.yaml", warnings);
  EXPECT_NEAR((turned.to_world({2, 1}) - Vec2(-10.5, 3.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(warnings.size(), 1u);
}

TEST(RosMap, WarnsWhenUnknownGrayReadsAsFree) {
  std::vector<std::string> warnings;
  RosMap map = read_ros_map(with("free_thresh", "0.25"), "a.yaml");
  to_grid(map, image_of({0, 205}, 2), "a.yaml", warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("gray 205"), std::string::npos);
  warnings.clear();
  to_grid(map, image_of({0, 204}, 2), "a.yaml", warnings);
  map.free_thresh = 0.196;
  to_grid(map, image_of({0, 205}, 2), "a.yaml", warnings);
  EXPECT_TRUE(warnings.empty());
}

}  // namespace
}  // namespace arcway::internal

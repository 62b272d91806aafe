#include "arcway/datasets/filter_mask.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "arcway/datasets/file_io.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"

namespace arcway::internal::filter_mask_test {
namespace {

namespace fs = std::filesystem;

class FilterMasks : public ::testing::Test {
 protected:
  FilterMasks() { fs::create_directories(folder_); }
  ~FilterMasks() override { fs::remove_all(folder_); }
  // A mask of half a meter a cell from (10, 20) on, by the gray values of its rows from the top.
  [[nodiscard]] fs::path mask(const std::string& size, const std::string& grays, const std::string& mode) const {
    write_file_atomically(folder_ / "mask.pgm", "P2\n" + size + "\n255\n" + grays + "\n");
    write_file_atomically(folder_ / "mask.yaml",
                          "image: mask.pgm\nresolution: 0.5\norigin: [10, 20, 0]\nnegate: 0\noccupied_thresh: 1.0\n"
                          "free_thresh: 0.0\nmode: " +
                              mode + "\n");
    return folder_ / "mask.yaml";
  }
  [[nodiscard]] static std::string error_of(const fs::path& path, const FilterMaskOptions& options) {
    try {
      read_filter_mask(path, options);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "no error";
  }
  fs::path folder_ = fs::path(::testing::TempDir()) /
                     ("arcway_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

bool has(const std::vector<std::string>& texts, std::string_view part) {
  return std::ranges::any_of(texts, [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

TEST_F(FilterMasks, KeepOutsAreTheCellsOfAHundred) {
  // Black is occupied. 128 of 255 is 50 percent.
  const FilterMask read = read_filter_mask(mask("4 3", "255 255 255 0  0 0 255 255  0 0 128 255", "scale"), {});
  ASSERT_EQ(read.zones.size(), 2u);
  EXPECT_EQ(read.zones[0].rule, ZoneRule(KeepOut{}));
  EXPECT_EQ(read.zones[0].name, "mask");
  EXPECT_EQ(read.zones[0].area.outer, (Ring{{10, 20}, {11, 20}, {11, 21}, {10, 21}}));
  EXPECT_EQ(read.zones[1].area.outer, (Ring{{11.5, 21}, {12, 21}, {12, 21.5}, {11.5, 21.5}}));
  ASSERT_EQ(read.warnings.size(), 1u);
  EXPECT_TRUE(has(read.warnings, "mask.yaml: 1 of 12 cells have the value 50, a cost in Nav2 and no keep-out"))
      << read.warnings[0];
  EXPECT_EQ(read.files.size(), 2u);
  EXPECT_NO_THROW(static_cast<void>(World({}).with_zones(read.zones)));
}

TEST_F(FilterMasks, SpeedsAreBaseAndMultiplierTimesTheValue) {
  // 40 and 70 percent of gray limit the speed to 60 and 30 percent: a row of 0, 40, 70, 70.
  const fs::path file = mask("4 1", "255 153 76 77", "scale");
  const FilterMask percent = read_filter_mask(
      file, {.type = FilterMaskType::kSpeedPercent, .base = 100.0, .multiplier = -1.0, .max_speed = 2.0});
  ASSERT_EQ(percent.zones.size(), 2u);
  EXPECT_EQ(percent.zones[0].area.outer, (Ring{{10.5, 20}, {11, 20}, {11, 20.5}, {10.5, 20.5}}));
  EXPECT_NEAR(std::get<SpeedLimit>(percent.zones[0].rule).max_speed, 1.2, 1e-12);
  EXPECT_NEAR(std::get<SpeedLimit>(percent.zones[1].rule).max_speed, 0.6, 1e-12);
  EXPECT_EQ(percent.zones[1].area.outer, (Ring{{11, 20}, {12, 20}, {12, 20.5}, {11, 20.5}}));
  EXPECT_TRUE(percent.warnings.empty());
  const FilterMask absolute = read_filter_mask(file, {.type = FilterMaskType::kSpeed, .base = 0.5, .multiplier = 0.01});
  ASSERT_EQ(absolute.zones.size(), 2u);
  EXPECT_NEAR(std::get<SpeedLimit>(absolute.zones[0].rule).max_speed, 0.9, 1e-12);
  EXPECT_NEAR(std::get<SpeedLimit>(absolute.zones[1].rule).max_speed, 1.2, 1e-12);
}

TEST_F(FilterMasks, LimitsThatAreNoneForNav2AreWarnedOf) {
  const fs::path file = mask("3 1", "0 50 200", "raw");  // the last one is unknown
  const FilterMask none =
      read_filter_mask(file, {.type = FilterMaskType::kSpeedPercent, .base = 0.0, .multiplier = 3.0, .max_speed = 2.0});
  EXPECT_TRUE(none.zones.empty());
  EXPECT_TRUE(has(none.warnings, "1 of 3 cells have the value 50, a limit of 150 %, which is none for Nav2"))
      << none.warnings[0];
  EXPECT_TRUE(has(none.warnings, "1 of 3 cells are unknown, which no speed mask may be"));
  const FilterMask zero = read_filter_mask(file, {.type = FilterMaskType::kSpeed, .base = 5.0, .multiplier = -0.1});
  EXPECT_TRUE(zero.zones.empty());
  EXPECT_TRUE(has(zero.warnings, "a limit of 0 m/s")) << zero.warnings[0];
}

TEST_F(FilterMasks, TrinaryMasksHaveZonesWhereTheyAreOccupied) {
  const FilterMask read = read_filter_mask(mask("3 1", "0 205 255", "trinary"), {});
  ASSERT_EQ(read.zones.size(), 1u);
  EXPECT_TRUE(read.warnings.empty());  // unknown is nothing for keep-outs
  EXPECT_EQ(read.zones[0].area.outer.size(), 4u);
}

TEST_F(FilterMasks, HolesAndTouchingCornersAreKept) {
  const FilterMask read = read_filter_mask(mask("4 3", "0 0 0 255  0 255 0 255  0 0 0 0", "trinary"), {});
  ASSERT_EQ(read.zones.size(), 1u);
  EXPECT_EQ(read.zones[0].area.holes.size(), 1u);
  const FilterMask corners = read_filter_mask(mask("2 2", "0 255  255 0", "trinary"), {});
  EXPECT_FALSE(corners.zones.empty());
  EXPECT_NO_THROW(static_cast<void>(World({}).with_zones(corners.zones).for_vehicle(Vehicle{})));
}

TEST_F(FilterMasks, WrongNumbersAndFilesAreNamed) {
  const fs::path file = mask("1 1", "0", "trinary");
  EXPECT_EQ(error_of(file, {.type = FilterMaskType::kSpeedPercent}),
            "filter mask: the robot's top speed is 0, must be above 0 m/s, for limits in percent");
  EXPECT_EQ(error_of(file, {.type = FilterMaskType::kSpeed, .multiplier = INFINITY}),
            "filter mask: multiplier is inf, must be finite");
  EXPECT_NE(error_of(file, {.max_cells = 0}).find("mask.pgm"), std::string::npos) << error_of(file, {.max_cells = 0});
  EXPECT_NE(error_of(folder_ / "other.yaml", {}).find("other.yaml"), std::string::npos);
  fs::remove(folder_ / "mask.pgm");
  EXPECT_NE(error_of(file, {}).find("mask.yaml needs another file: cannot read "), std::string::npos);
}

}  // namespace
}  // namespace arcway::internal::filter_mask_test

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "arcway/datasets/file_io.h"
#include "arcway/datasets/filter_mask.h"
#include "arcway/datasets/map_file.h"
#include "arcway/world.h"
#include "core/geometry/distance.h"
#include "tests/support/boxes.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal::filter_mask_writer_test {
namespace {

namespace fs = std::filesystem;
using test::box;

class WrittenMasks : public ::testing::Test {
 protected:
  WrittenMasks() { fs::create_directories(folder_); }
  ~WrittenMasks() override { fs::remove_all(folder_); }
  // The zones of a map after they were written and read.
  [[nodiscard]] std::vector<Zone> written_and_read(const MapFile& map, const FilterMaskWriteOptions& options) const {
    const FilterMaskFiles files = to_filter_mask(map, "mask", options);
    write_file_atomically(folder_ / "mask.yaml", files.mask);
    write_file_atomically(folder_ / "mask.pgm", files.image);
    const FilterMask read = read_filter_mask(
        folder_ / "mask.yaml", {.type = options.type, .base = files.base, .multiplier = files.multiplier});
    EXPECT_TRUE(read.warnings.empty()) << read.warnings.front();
    return read.zones;
  }
  fs::path folder_ = fs::path(::testing::TempDir()) /
                     ("arcway_written_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

// Zones and their limits: 0 of keep-outs.
class Limits {
 public:
  explicit Limits(const std::vector<Zone>& zones) {
    for (const Zone& zone : zones) {
      const auto* limit = std::get_if<SpeedLimit>(&zone.rule);
      areas_.push_back({World({zone.area}), limit == nullptr ? 0.0 : limit->max_speed});
    }
  }

  // The lowest one at a point; infinity where there is none.
  [[nodiscard]] double at(const Vec2& p) const {
    double lowest = INFINITY;
    for (const Area& area : areas_)
      if (area.limit < lowest && area.world.locate(p, 0) != PointLocation::kOutside) lowest = area.limit;
    return lowest;
  }

  // The distance of a point from the nearest zone with a limit of at least this.
  [[nodiscard]] double distance_to(double limit, const Vec2& p) const {
    double least = INFINITY;
    for (const Area& area : areas_) {
      if (area.limit < limit) continue;
      if (area.world.locate(p, 0) != PointLocation::kOutside) return 0.0;
      for (const LineSegment& edge : area.world.edges()) least = std::min(least, internal::distance(p, edge));
    }
    return least;
  }

 private:
  struct Area {
    World world;
    double limit;
  };
  std::vector<Area> areas_;
};

double limit_at(const std::vector<Zone>& zones, const Vec2& p) { return Limits(zones).at(p); }

MapFile random_map(test::RandomInputs& random, bool keep_outs) {
  MapFile map;
  map.bounds = box(-8.3, -5.1, 9.7, 7.9).outer;
  for (int i = 0; i < 6; ++i) {
    const Vec2 p(random.uniform(-6, 7), random.uniform(-3, 6));
    Polygon area{test::random_star(random, p, 0.7, 2.0, 7), {}};
    if (i == 0) area = {box(-7, -4, -2, 2).outer, {box(-5, -3, -3, 1).outer}};
    const ZoneRule rule = keep_outs ? ZoneRule(KeepOut{}) : ZoneRule(SpeedLimit{random.uniform(0.2, 1.5)});
    map.zones.push_back({area, rule, "z"});
  }
  return map;
}

// What a zone asks is asked everywhere in it, and nowhere further away than a cell is wide.
TEST_F(WrittenMasks, HoldTheirZonesAndNotMuchMore) {
  test::RandomInputs random(4);
  for (const bool keep_outs : {true, false})
    for (const double resolution : {0.1, 0.37}) {
      const MapFile map = random_map(random, keep_outs);
      const std::vector<Zone> back = written_and_read(
          map, {.type = keep_outs ? FilterMaskType::kKeepOut : FilterMaskType::kSpeed, .resolution = resolution});
      const Limits asked_for(map.zones), read(back);
      int inside = 0, outside = 0;
      for (int i = 0; i < 2000; ++i) {
        const Vec2 p(random.uniform(-8.3, 9.7), random.uniform(-5.1, 7.9));
        const double asked = asked_for.at(p), found = read.at(p);
        EXPECT_LE(found, asked * (1.0 + 1e-9)) << p.transpose();
        // The zone of the limit found, or one that was rounded to it, reaches into the cell.
        if (std::isfinite(found)) {
          EXPECT_LE(asked_for.distance_to(found * (1.0 - 1e-9), p), std::sqrt(2.0) * resolution + 1e-9)
              << p.transpose();
        }
        ++(std::isfinite(asked) ? inside : outside);
      }
      EXPECT_GT(inside, 100);
      EXPECT_GT(outside, 100);
    }
}

TEST_F(WrittenMasks, OfWholeCellsComeBackAsTheyAre) {
  MapFile map;
  map.zones = {{box(0.1, 0.2, 0.7, 0.3), KeepOut{}}, {box(1.1, -0.3, 1.2, 0.4), KeepOut{}}};
  const std::vector<Zone> back = written_and_read(map, {.resolution = 0.1});
  ASSERT_EQ(back.size(), 2u);
  double width = 0.0;
  for (const Zone& zone : back) {
    ASSERT_EQ(zone.area.outer.size(), 4u);
    Box around;
    for (const Vec2& p : zone.area.outer) around.extend(p);
    width += around.max.x() - around.min.x();
  }
  EXPECT_NEAR(width, 0.7, 1e-9);
}

TEST_F(WrittenMasks, HaveLimitsInStepsOfAHundredth) {
  MapFile map;
  map.zones = {
      {box(0, 0, 1, 1), SpeedLimit{0.5}}, {box(2, 0, 3, 1), SpeedLimit{1.5}}, {box(4, 0, 5, 1), SpeedLimit{0.9}}};
  const std::vector<Zone> back = written_and_read(map, {.type = FilterMaskType::kSpeed, .resolution = 0.25});
  EXPECT_NEAR(limit_at(back, {0.5, 0.5}), 0.5, 1e-12);
  EXPECT_NEAR(limit_at(back, {2.5, 0.5}), 1.5, 1e-12);
  EXPECT_LE(limit_at(back, {4.5, 0.5}), 0.9);
  EXPECT_GT(limit_at(back, {4.5, 0.5}), 0.9 - 1.0 / 99.0);
  map.zones.resize(1);
  EXPECT_NEAR(limit_at(written_and_read(map, {.type = FilterMaskType::kSpeed}), {0.5, 0.5}), 0.5, 1e-12);
}

TEST_F(WrittenMasks, LeaveOutZonesOfOtherRolesAndVehicles) {
  MapFile map;
  map.zones = {{box(0, 0, 1, 1), KeepOut{{"van"}}},
               {box(2, 0, 3, 1), SpeedLimit{1.5}},
               {box(4, 0, 5, 1), OneWay{0.0, 1.0}},
               {box(6, 0, 7, 1), KeepClear{0.5, 1.0}}};
  EXPECT_EQ(written_and_read(map, {}).size(), 1u);
  EXPECT_EQ(written_and_read(map, {.vehicle = "van"}).size(), 1u);
  EXPECT_EQ(written_and_read(map, {.vehicle = "car"}).size(), 0u);
  EXPECT_EQ(to_filter_mask(map, "m", {.vehicle = "car"}).zones, 0u);
  const FilterMaskFiles files = to_filter_mask(map, "m", {.type = FilterMaskType::kSpeed});
  EXPECT_EQ(files.zones, 1u);
  for (const char* part :
       {"yaml_filename: \"m.yaml\"", "type: 2", "mask_topic: /speed_filter_mask", "base: 1.5", "multiplier: 0.0\n"})
    EXPECT_NE(files.parameters.find(part), std::string::npos) << part << "\n" << files.parameters;
}

std::string error_of(const MapFile& map, const FilterMaskWriteOptions& options) {
  try {
    static_cast<void>(to_filter_mask(map, "m", options));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST_F(WrittenMasks, TooLargeOnesNameAResolutionThatFits) {
  MapFile map;
  map.bounds = box(0, 0, 1000, 300).outer;
  EXPECT_EQ(error_of(map, {.resolution = 0.1, .max_cells = 1'000'000}),
            "filter mask: 10000 x 3000 cells of 0.1 m, at most 1000000 fit; give a resolution of at least 0.55 m");
  EXPECT_EQ(error_of(map, {.resolution = 0.55, .max_cells = 1'000'000}), "");
  EXPECT_NE(error_of(map, {.resolution = 1e-300}).find("cells of 1e-300 m, at most"), std::string::npos);
  EXPECT_EQ(error_of(map, {.resolution = 0.0}), "filter mask: resolution is 0 m, must be above 0 and finite");
  EXPECT_NE(error_of(map, {.resolution = NAN}).find("resolution is nan m"), std::string::npos);
  EXPECT_NE(error_of(map, {.type = FilterMaskType::kSpeedPercent}).find("not in percent"), std::string::npos);
}

}  // namespace
}  // namespace arcway::internal::filter_mask_writer_test

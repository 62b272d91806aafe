// The small worlds of tests/data, one for each format.

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <optional>
#include <string_view>

#include "arcway/datasets/geojson.h"
#include "arcway/datasets/plan_io.h"
#include "arcway/datasets/read_map.h"
#include "arcway/datasets/svg.h"
#include "arcway/datasets/wkt.h"
#include "arcway/planner.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

namespace fs = std::filesystem;

struct SmallWorld {
  const char* file;
  std::size_t obstacles, vertices;  ///< vertices without the bounds
  Pose start, goal;                 ///< those of the file where it has them
  std::optional<double> cell_size = std::nullopt;
  std::size_t task = 0;
};

const SmallWorld kWorlds[] = {
    {"yard.geojson", 3, 14, {4, 4, 0}, {36, 26, kPi / 2}},
    {"yard.wkt", 3, 14, {4, 4, 0}, {36, 26, kPi / 2}},
    {"yard.txt", 3, 10, {4, 4, 0}, {36, 26, kPi / 2}},
    {"yard.csv", 3, 10, {4, 4, 0}, {36, 26, kPi / 2}},
    {"yard.svg", 3, 14, {4, -26, 0}, {36, -4, kPi / 2}},
    {"ponds.svg", 3, 498, {4, -26, 0}, {36, -4, kPi / 2}},
    {"parking_case.csv", 3, 11, {2, 10, 0}, {24, 10, 0}},
    {"rooms.map", 5, 42, {3.5, 12.5, 0}, {20.5, 3.5, 0}},
    {"rooms.map.scen", 5, 42, {3.5, 3.5, 0}, {20.5, 3.5, 0}, std::nullopt, 1},
    {"room.yaml", 2, 18, {0, 2.5, 0}, {4, 6, kPi}},
    {"room_png.yaml", 2, 18, {0, 2.5, 0}, {4, 6, kPi}},
    {"room.pgm", 2, 16, {2, 1.5, 0}, {6, 5, kPi}, 0.5},
    {"room_binary.pgm", 2, 16, {2, 1.5, 0}, {6, 5, kPi}, 0.5},
    {"room.png", 2, 16, {2, 1.5, 0}, {6, 5, kPi}, 0.5},
    {"yard.arcway", 3, 14, {4, 4, 0}, {36, 26, kPi / 2}},
};

fs::path path_of(const SmallWorld& world) { return fs::path(ARCWAY_SOURCE_DIR) / "tests/data" / world.file; }

MapReadOptions options_of(const SmallWorld& world) {
  MapReadOptions options;
  options.grid.cell_size = world.cell_size;
  options.task = world.task;
  return options;
}

std::size_t vertex_count(const MapFile& map) {
  std::size_t count = 0;
  for (const Polygon& polygon : map.obstacles) {
    count += polygon.outer.size();
    for (const Ring& hole : polygon.holes) count += hole.size();
  }
  return count;
}

void expect_same(const MapFile& a, const MapFile& b, bool with_bounds) {
  ASSERT_EQ(a.obstacles.size(), b.obstacles.size());
  for (std::size_t i = 0; i < a.obstacles.size(); ++i) {
    EXPECT_EQ(a.obstacles[i].outer, b.obstacles[i].outer);
    EXPECT_EQ(a.obstacles[i].holes, b.obstacles[i].holes);
  }
  if (!with_bounds) return;
  EXPECT_EQ(a.bounds, b.bounds);
  EXPECT_EQ(a.start.has_value(), b.start.has_value());
  if (a.start && b.start) {
    EXPECT_EQ(a.start->position(), b.start->position());
    EXPECT_EQ(a.start->heading, b.start->heading);
  }
}

TEST(SmallWorlds, HaveTheirObstaclesAndPlan) {
  VehicleParameters parameters;
  parameters.max_speed = 2.0;
  parameters.turn_speed = ConstantTurnSpeed{1.0};
  parameters.max_acceleration = 1.0;
  const Vehicle vehicle(parameters);
  for (const SmallWorld& sample : kWorlds) {
    SCOPED_TRACE(sample.file);
    const MapFile map = read_map(path_of(sample), options_of(sample));
    EXPECT_EQ(map.obstacles.size(), sample.obstacles);
    EXPECT_EQ(vertex_count(map), sample.vertices);
    const World world = to_world(map, sample.file);
    EXPECT_EQ(map.start.value_or(sample.start).position(), sample.start.position());
    EXPECT_EQ(map.goal.value_or(sample.goal).position(), sample.goal.position());
    const Planner planner(world, vehicle);
    const PlanResult result = planner.plan({.start = sample.start, .goal = sample.goal});
    ASSERT_TRUE(result.solved()) << result.reason;
    test::expect_valid(planner, result);
  }
}

TEST(SmallWorlds, RoundTripsAreExact) {
  for (const SmallWorld& sample : kWorlds) {
    SCOPED_TRACE(sample.file);
    const MapFile map = read_map(path_of(sample), options_of(sample));
    const std::string geojson = to_geojson(map), wkt = to_wkt(map);
    const MapFile from_geojson = read_geojson(geojson, "g"), from_wkt = read_wkt(wkt, "w");
    expect_same(map, from_geojson, /*with_bounds=*/true);
    expect_same(map, from_wkt, /*with_bounds=*/false);
    EXPECT_EQ(to_geojson(from_geojson), geojson);
    EXPECT_EQ(to_wkt(from_wkt), wkt);
  }
}

TEST(SmallWorlds, TheSameRoomInEveryImageFormat) {
  const auto room = [](std::string_view file) {
    const auto world =
        std::ranges::find(kWorlds, file, [](const SmallWorld& one) { return std::string_view(one.file); });
    return read_map(path_of(*world), options_of(*world));
  };
  expect_same(room("room.yaml"), room("room_png.yaml"), true);
  expect_same(room("room.pgm"), room("room_binary.pgm"), true);
  expect_same(room("room.pgm"), room("room.png"), true);
}

// Sets the process's locale to one with a decimal comma, made for the purpose if none is installed.
class CommaLocale {
 public:
  explicit CommaLocale(const fs::path& folder) {
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "nl_NL.UTF-8"})
      if (set(name)) return;
    fs::create_directories(folder);
    const std::string command =
        "localedef -i de_DE -f UTF-8 '" + (folder / "de_DE.UTF-8").string() + "' >/dev/null 2>&1";
    if (std::system(command.c_str()) != 0) return;
    setenv("LOCPATH", folder.c_str(), 1);
    set("de_DE.UTF-8");
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;
  ~CommaLocale() {
    std::setlocale(LC_ALL, "C");
    std::locale::global(std::locale::classic());
    unsetenv("LOCPATH");
  }
  [[nodiscard]] bool set() const { return set_; }

 private:
  bool set(const char* name) {
    if (std::setlocale(LC_ALL, name) == nullptr || *std::localeconv()->decimal_point != ',') return false;
    std::locale::global(std::locale(name));
    return set_ = true;
  }
  bool set_ = false;
};

// A world as every writer has it.
std::string written(const SmallWorld& sample) {
  const MapFile map = read_map(path_of(sample), options_of(sample));
  return to_geojson(map) + to_wkt(map) + SvgPicture(to_world(map, sample.file)).str();
}

// The world has a plan, too.
std::string written_plan() {
  PlanResult plan;
  plan.status = PlanStatus::kSolved;
  const Trajectory trajectory(Path{{{0.5, 1.25, 0.75}, 2.5, 0.125}}, Vehicle{});
  plan.segments.assign(trajectory.segments().begin(), trajectory.segments().end());
  return plan_to_json(plan, 0) + path_to_csv(trajectory) + path_to_nav_msgs(trajectory);
}

TEST(SmallWorlds, ReadAndWriteTheSameInACommaLocale) {
  std::vector<std::string> expected;
  for (const SmallWorld& sample : kWorlds) expected.push_back(written(sample));
  const std::string expected_plan = written_plan();
  const fs::path folder = fs::path(::testing::TempDir()) / "arcway_locale";
  {
    const CommaLocale locale(folder);
    if (!locale.set()) GTEST_SKIP() << "no locale with a decimal comma is installed, and localedef could not make one";
    for (std::size_t i = 0; i < std::size(kWorlds); ++i) EXPECT_EQ(written(kWorlds[i]), expected[i]) << kWorlds[i].file;
    EXPECT_EQ(written_plan(), expected_plan);
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace arcway::internal

#include "tests/fuzz/targets.h"

#include <string>
#include <vector>

#include "arcway/datasets/geojson.h"
#include "arcway/datasets/plan_io.h"
#include "arcway/datasets/prepared_map.h"
#include "arcway/datasets/read_map.h"
#include "arcway/datasets/robot.h"
#include "arcway/datasets/wkt.h"
#include "arcway/planner.h"
#include "datasets/formats/gray_image.h"
#include "datasets/formats/movingai.h"
#include "datasets/formats/ros_map.h"
#include "datasets/formats/svg_world.h"
#include "datasets/formats/text_polygons.h"
#include "datasets/formats/tpcap.h"
#include "datasets/formats/vertex_list.h"
#include "datasets/grid/grid_map.h"
#include "datasets/io/gzip.h"
#include "tests/support/prepared_bytes.h"

namespace arcway::internal::test {
namespace {

constexpr std::size_t kMaxCells = 1 << 16;
constexpr const char* kName = "input";

// A reader's map must be one that World takes or refuses with a FormatError, and be writable.
void use(const MapFile& map) {
  static_cast<void>(to_geojson(map));
  static_cast<void>(to_world(map, kName));
}
void use(const OccupancyGrid& grid) {
  for (const double tolerance : {0.0, 1.0}) use(to_map_file(grid, {.tolerance = tolerance}));
}
void use(const GrayImage& image) {
  std::vector<std::string> warnings;
  use(to_grid(RosMap{}, image, kName, warnings));
}

void geojson(std::string_view bytes) {
  use(read_geojson(bytes, kName, {.wall_width = 0.5}));
  use(read_geojson(bytes, kName, {.lonlat = true}));
  use(read_geojson(bytes, kName, {.free_polygons = true}));
}
void wkt(std::string_view bytes) {
  use(read_wkt(bytes, kName, {.wall_width = 0.5}));
  use(read_wkt(bytes, kName, {.lonlat = true, .free_polygons = true}));
}
void vertex_list(std::string_view bytes) { use(read_vertex_list(bytes, kName)); }
void text_polygons(std::string_view bytes) { use(read_text_polygons(bytes, kName)); }
void tpcap(std::string_view bytes) { use(read_tpcap(bytes, kName)); }
void movingai_map(std::string_view bytes) {
  use(read_movingai_map(bytes, kName, {.free_letters = "E", .max_cells = kMaxCells}));
}
void movingai_scenario(std::string_view bytes) { static_cast<void>(read_movingai_scenario(bytes, kName)); }
void pgm(std::string_view bytes) { use(read_pgm(bytes, kName, kMaxCells)); }
void png(std::string_view bytes) { use(read_png(bytes, kName, kMaxCells)); }
void ros_map(std::string_view bytes) {
  const RosMap map = read_ros_map(bytes, kName);
  GrayImage image;
  image.width = image.height = 1;
  image.samples = {205};
  std::vector<std::string> warnings;
  use(to_map_file(to_grid(map, image, kName, warnings)));
}
void svg_world(std::string_view bytes) { use(read_svg_world(bytes, kName)); }
void gzip(std::string_view bytes) { static_cast<void>(expand_gzip(bytes, kName, 1 << 20)); }
void detect(std::string_view bytes) { static_cast<void>(detect_format(bytes, kName)); }
void robot(std::string_view bytes) { static_cast<void>(read_robot(bytes, kName)); }
void scenario(std::string_view bytes) { static_cast<void>(read_scenario(bytes, kName)); }
// Of a map that is taken, the graphs must be such that a planner takes them or refuses them, and written again it must
// have the same bytes. A robot may be written in several ways; then those of the second time must be those of the
// first.
void use(PreparedMap map, const std::string& bytes) {
  constexpr std::uint32_t kRobot = 103;
  const PreparedSection robot = section_of(bytes, kRobot);
  const std::string written = to_bytes(map);
  const bool own_words = !map.robot || bytes.substr(robot.offset, robot.count) == to_json(map.robot->parameters);
  if (written != (own_words ? bytes : to_bytes(read_prepared_map(written, kName))))
    throw std::logic_error("other bytes when written again");
  if (!map.robot) return;
  try {
    static_cast<void>(
        Planner::restored(map.world, Vehicle(map.robot->parameters), reference_backend(map.world),
                          {std::move(map.reduced_graph), map.robot->radii, std::move(map.robot->feasible)}));
  } catch (const std::invalid_argument&) {
  }
}
void prepared_map(std::string_view bytes) {
  std::string mended(bytes);
  test::mend_checksums(mended);  // else no change gets past them
  use(read_prepared_map(mended, kName), mended);
}
void plan(std::string_view bytes) { static_cast<void>(parse_plans(bytes, kName)); }

constexpr FuzzTarget kTargets[] = {
    {"geojson", geojson},
    {"wkt", wkt},
    {"text_polygons", text_polygons},
    {"vertex_list", vertex_list},
    {"tpcap", tpcap},
    {"movingai_map", movingai_map},
    {"movingai_scenario", movingai_scenario},
    {"pgm", pgm},
    {"png", png},
    {"ros_map", ros_map},
    {"svg_world", svg_world},
    {"gzip", gzip},
    {"detect", detect},
    {"robot", robot},
    {"scenario", scenario},
    {"plan", plan},
    {"prepared_map", prepared_map},
};

}  // namespace

std::span<const FuzzTarget> fuzz_targets() { return kTargets; }

void run_fuzz_target(const FuzzTarget& target, std::string_view bytes) {
  try {
    target.read(bytes);
  } catch (const FormatError&) {
  }
}

}  // namespace arcway::internal::test

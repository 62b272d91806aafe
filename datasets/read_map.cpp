#include "datasets/read_map.h"

#include <algorithm>
#include <array>
#include <string>

#include "datasets/file_io.h"
#include "datasets/formats/geojson.h"
#include "datasets/formats/movingai.h"
#include "datasets/formats/text_polygons.h"
#include "datasets/formats/text_scanner.h"
#include "datasets/formats/tpcap.h"
#include "datasets/formats/wkt.h"
#include "datasets/grid/grid_map.h"

namespace arcway {
namespace {

namespace fs = std::filesystem;

MapFile read_movingai_task(std::string_view text, const fs::path& path, const MapReadOptions& options) {
  const std::string name = path.string();
  const std::vector<MovingAiTask> tasks = read_movingai_scenario(text, name);
  if (options.task >= tasks.size())
    throw FormatError(name + ": there is no task " + std::to_string(options.task) + ", the file has " +
                      std::to_string(tasks.size()));
  const MovingAiTask& task = tasks[options.task];
  // The path is as on its author's disk.
  fs::path map_path = path.parent_path() / task.map;
  if (!fs::exists(map_path)) map_path = path.parent_path() / fs::path(task.map).filename();
  OccupancyGrid grid = read_movingai_map(read_file(map_path), map_path.string(), options.grid);
  // A scenario of another size is on the map scaled to it.
  if (task.width * grid.height != task.height * grid.width)
    throw FormatError(name + ": line " + std::to_string(task.line) + ": a map of " + std::to_string(task.width) +
                      " x " + std::to_string(task.height) + " cells, but " + map_path.string() + " has " +
                      std::to_string(grid.width) + " x " + std::to_string(grid.height));
  const double cell = grid.cell_size;
  grid.cell_size *= static_cast<double>(task.width) / static_cast<double>(grid.width);

  MapFile map = to_map_file(grid, options.grid);
  const TaskHeadings headings = draw_headings(options.heading_seed, options.task);
  const auto pose = [&](std::size_t x, std::size_t y, double heading) {
    return Pose{(static_cast<double>(x) + 0.5) * cell, (static_cast<double>(task.height - 1 - y) + 0.5) * cell,
                heading};
  };
  map.start = pose(task.start_x, task.start_y, headings.start);
  map.goal = pose(task.goal_x, task.goal_y, headings.goal);
  map.notes.push_back("task " + std::to_string(options.task) + " of " + std::to_string(tasks.size()) +
                      ", headings drawn with seed " + std::to_string(options.heading_seed));
  return map;
}

bool is_wkt_keyword(std::string_view word) {
  std::string upper(word);
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  for (const std::string_view keyword : {"SRID", "POINT", "MULTIPOINT", "LINESTRING", "MULTILINESTRING", "POLYGON",
                                         "POLYGONZ", "POLYGONM", "POLYGONZM", "MULTIPOLYGON", "GEOMETRYCOLLECTION"})
    if (upper == keyword) return true;
  return false;
}

// Whether the text's first numbers are one a line or between commas, as in a parking case.
bool is_number_list(detail::TextScanner scanner) {
  const std::string_view line = scanner.rest_of_line();
  return line.find(',') != std::string_view::npos || detail::split_at_blanks(line).size() == 1;
}

}  // namespace

const char* name_of(MapFormat format) {
  switch (format) {
    case MapFormat::kGeoJson:
      return "GeoJSON";
    case MapFormat::kWkt:
      return "WKT";
    case MapFormat::kTextPolygons:
      return "plain text polygons";
    case MapFormat::kTpcap:
      return "TPCAP case";
    case MapFormat::kMovingAiMap:
      return "MovingAI map";
    case MapFormat::kMovingAiScenario:
      return "MovingAI scenario";
  }
  return "?";
}

MapFormat detect_format(std::string_view content, std::string_view name) {
  detail::TextScanner scanner(content, name);
  if (scanner.peek() == '\x1E') return MapFormat::kGeoJson;
  scanner.skip_space();
  if (scanner.at_end()) throw FormatError(std::string(name) + ": empty file, expected a map");
  while (scanner.peek() == '#') {
    scanner.rest_of_line();
    scanner.skip_space();
  }
  if (scanner.peek() == '{' || scanner.peek() == '[') return MapFormat::kGeoJson;
  detail::TextScanner ahead = scanner;
  const std::string_view word = ahead.word("(=;,:0123456789");
  if (word == "type") return MapFormat::kMovingAiMap;
  if (word == "version") return MapFormat::kMovingAiScenario;
  if (is_wkt_keyword(word)) return MapFormat::kWkt;
  if (const char c = scanner.peek(); (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.')
    return is_number_list(scanner) ? MapFormat::kTpcap : MapFormat::kTextPolygons;
  scanner.fail("this is no map of a known format, it begins with " + detail::quoted(scanner.rest_of_line()));
}

MapFile read_map(const fs::path& path, const MapReadOptions& options) {
  const std::string text = read_file(path);
  const std::string name = path.string();
  switch (detect_format(text, name)) {
    case MapFormat::kGeoJson:
      return read_geojson(text, name, options.vector);
    case MapFormat::kWkt:
      return read_wkt(text, name, options.vector);
    case MapFormat::kTextPolygons:
      return read_text_polygons(text, name, options.vector);
    case MapFormat::kTpcap:
      return read_tpcap(text, name);
    case MapFormat::kMovingAiMap:
      return to_map_file(read_movingai_map(text, name, options.grid), options.grid);
    case MapFormat::kMovingAiScenario:
      return read_movingai_task(text, path, options);
  }
  return {};
}

}  // namespace arcway

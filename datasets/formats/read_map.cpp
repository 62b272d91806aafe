#include "arcway/datasets/read_map.h"

#include <string>
#include <utility>

#include "arcway/datasets/file_io.h"
#include "arcway/datasets/geojson.h"
#include "arcway/datasets/prepared_map.h"
#include "arcway/datasets/wkt.h"
#include "core/base/shortest_text.h"
#include "datasets/formats/gray_image.h"
#include "datasets/formats/movingai.h"
#include "datasets/formats/ros_map.h"
#include "datasets/formats/svg_world.h"
#include "datasets/formats/text_polygons.h"
#include "datasets/formats/tpcap.h"
#include "datasets/formats/vertex_list.h"
#include "datasets/grid/grid_map.h"
#include "datasets/io/input_files.h"

namespace arcway {

using namespace internal;
namespace {

namespace fs = std::filesystem;

MapFile read_grid_map(const RosMap& map, const GrayImage& image, const fs::path& path, const GridOptions& options) {
  std::vector<std::string> warnings;
  const OccupancyGrid grid = to_grid(map, image, path.string(), warnings);
  MapFile result = to_map_file(grid, options);
  result.warnings = std::move(warnings);
  return result;
}

MapFile read_ros_files(std::string_view yaml, const fs::path& path, const GridOptions& options) {
  const RosMap map = read_ros_map(yaml, path.string());
  const fs::path image_path = find_beside(path, map.image);
  MapFile result = read_grid_map(
      map, read_gray_image(read_expanded(image_path), image_path.string(), options.max_cells), path, options);
  result.files.push_back(image_path);
  return result;
}

MapFile read_bare_image(std::string_view bytes, const fs::path& path, const GridOptions& options) {
  RosMap map;
  map.occupied_thresh = map.free_thresh = 0.5;
  map.resolution = options.cell_size.value_or(map.resolution);
  MapFile result = read_grid_map(map, read_gray_image(bytes, path.string(), options.max_cells), path, options);
  if (!options.cell_size)
    result.warnings.push_back(path.string() + ": an image without a YAML file does not say how large its pixels are; " +
                              shortest_text(map.resolution) + " m is assumed (--cell)");
  return result;
}

MapFile read_letters(std::string_view text, std::string_view name, const GridOptions& options) {
  MapFile map = to_map_file(read_movingai_map(text, name, options), options);
  if (options.free_letters)
    map.notes.push_back("cells of the letters " + *options.free_letters +
                        " are free, those of letters that are not known are obstacles");
  return map;
}

MapFile read_movingai_task(std::string_view text, const fs::path& path, const MapReadOptions& options) {
  const std::string name = path.string();
  const std::vector<MovingAiTask> tasks = read_movingai_scenario(text, name);
  if (options.task >= tasks.size())
    throw FormatError(name + ": there is no task " + std::to_string(options.task) + ", the file has " +
                      std::to_string(tasks.size()));
  const MovingAiTask& task = tasks[options.task];
  const fs::path map_path = find_beside(path, task.map);  // the name is as on its author's disk
  OccupancyGrid grid = read_movingai_map(read_expanded(map_path), map_path.string(), options.grid);
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
  map.files.push_back(map_path);
  map.notes.push_back("task " + std::to_string(options.task) + " of " + std::to_string(tasks.size()) +
                      ", headings drawn with seed " + std::to_string(options.heading_seed));
  return map;
}

MapFile read_prepared(std::string_view bytes, std::string_view name) {
  const PreparedMap prepared = read_prepared_map(bytes, name);
  MapFile map = to_map_file(prepared.world);
  map.start = prepared.start;
  map.goal = prepared.goal;
  return map;
}

MapFile read_as(MapFormat format, std::string_view text, const fs::path& path, const MapReadOptions& options) {
  const std::string name = path.string();
  switch (format) {
    case MapFormat::kGeoJson:
      return read_geojson(text, name, options.vector);
    case MapFormat::kWkt:
      return read_wkt(text, name, options.vector);
    case MapFormat::kTextPolygons:
      return read_text_polygons(text, name, options.vector);
    case MapFormat::kVertexList:
      return read_vertex_list(text, name, options.vector);
    case MapFormat::kTpcap:
      return read_tpcap(text, name);
    case MapFormat::kMovingAiMap:
      return read_letters(text, name, options.grid);
    case MapFormat::kMovingAiScenario:
      return read_movingai_task(text, path, options);
    case MapFormat::kRosMap:
      return read_ros_files(text, path, options.grid);
    case MapFormat::kPgm:
    case MapFormat::kPng:
      return read_bare_image(text, path, options.grid);
    case MapFormat::kSvg:
      return read_svg_world(text, name, options.vector);
    case MapFormat::kPrepared:
      return read_prepared(text, name);
  }
  return {};
}

// Options that say what coordinates of polygons are.
void warn_of_vain_options(MapFormat format, const std::string& name, const VectorOptions& options, MapFile& map) {
  if (has_polygons(format)) return;
  for (const auto& [given, what] : {std::pair{options.lonlat, "degrees (--lonlat)"},
                                    {options.free_polygons, "polygons that are free (--polygons)"},
                                    {options.wall_width > 0.0, "widths of walls (--wall-width)"}})
    if (given) map.warnings.push_back(name + ": a " + name_of(format) + " has no " + what + "; the option is not used");
}

}  // namespace

MapFile read_map(const fs::path& path, const MapReadOptions& options) {
  const std::string text = read_expanded(path), name = path.string();
  const MapFormat format = options.format ? *options.format : detect_format(text, name);
  try {
    MapFile map = read_as(format, text, path, options);
    map.files.push_back(path);
    warn_of_vain_options(format, name, options.vector, map);
    return map;
  } catch (const FormatError& error) {
    if (options.format || !is_guess(format)) throw;
    throw FormatError(std::string(error.what()) + "; by its content the file was taken for a " + name_of(format) +
                      ", --format NAME reads it as another");
  }
}

World read_world(const std::filesystem::path& path, const MapReadOptions& options) {
  return to_world(read_map(path, options), path.string());
}

}  // namespace arcway

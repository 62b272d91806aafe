#include <filesystem>
#include <memory>
#include <string>

#include "arcway/datasets/geojson.h"
#include "arcway/datasets/svg.h"
#include "arcway/datasets/wkt.h"
#include "bench/cli/arguments.h"
#include "bench/cli/output_files.h"

namespace arcway::internal::cli {
namespace {

struct ConvertArguments {
  std::string map, out;
  MapOptions reading;
};

std::string picture(const MapFile& map, const std::string& name) {
  SvgPicture svg(to_world(map, name));
  if (map.start && map.goal) svg.add_poses(*map.start, *map.goal, Vehicle{}.footprint());
  svg.set_title(name);
  return svg.str();
}

int run_convert(const ConvertArguments& arguments, std::string& out) {
  const std::string ending = std::filesystem::path(arguments.out).extension().string();
  if (ending != ".geojson" && ending != ".json" && ending != ".wkt" && ending != ".svg")
    throw UsageError("OUT: expected a name that ends in .geojson, .json, .wkt or .svg, got " +
                     in_quotes(arguments.out));
  OutputFiles files({arguments.out}, {arguments.map});
  const MapFile map = read_named_map(arguments.map, arguments.reading);
  files.protect(map.files);

  if (ending == ".wkt") {
    files.add(arguments.out, to_wkt(map));
  } else if (ending == ".svg") {
    files.add(arguments.out, picture(map, arguments.map));
  } else {
    files.add(arguments.out, to_geojson(map));
  }

  std::size_t vertices = 0;
  for (const Polygon& polygon : map.obstacles) {
    vertices += polygon.outer.size();
    for (const Ring& hole : polygon.holes) vertices += hole.size();
  }
  out += arguments.map + ": converted\n";
  out += row("obstacles", count_text(map.obstacles.size()));
  out += row("vertices", count_text(vertices));
  for (const std::string& note : map.notes) out += row("read", note);
  for (const std::string& warning : map.warnings) out += row("warning", warning);
  if (ending == ".wkt" && (map.bounds || map.start || map.goal))
    out += row("warning", "WKT has no place for bounds, start and goal; they are left out");
  files.write();
  out += files.summary();
  return kExitSolved;
}

}  // namespace

void add_convert_command(CLI::App& app, Action& action) {
  CLI::App& command = *app.add_subcommand("convert", "Write a map in another format, told by the ending of OUT");
  const auto arguments = std::make_shared<ConvertArguments>();
  command.add_option("WORLD", arguments->map, kMapHelp)->required();
  command.add_option("OUT", arguments->out, "Map to write: .geojson, .wkt, or .svg, a picture")->required();
  arguments->reading.add_to(command);
  command.callback(
      [arguments, &action] { action = [arguments](std::string& out) { return run_convert(*arguments, out); }; });
}

}  // namespace arcway::internal::cli

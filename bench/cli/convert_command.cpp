#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "arcway/datasets/filter_mask.h"
#include "arcway/datasets/geojson.h"
#include "arcway/datasets/svg.h"
#include "arcway/datasets/wkt.h"
#include "bench/cli/arguments.h"
#include "bench/cli/output_files.h"
#include "core/base/shortest_text.h"

namespace arcway::internal::cli {
namespace {

struct ConvertArguments {
  std::string map, out;
  MapOptions reading;
  std::string filter_mask, resolution = "0.05", robot;
};

bool writes_mask(const ConvertArguments& arguments) {
  const std::string ending = std::filesystem::path(arguments.out).extension().string();
  return ending == ".yaml" || ending == ".yml";
}

// The files of a mask: that of map_server, its image, and parameters of Nav2's servers.
std::vector<std::string> mask_files(const std::string& out) {
  std::filesystem::path image = out, parameters = out;
  image.replace_extension(".pgm");
  parameters.replace_filename(std::filesystem::path(out).stem().string() + "_parameters.yaml");
  return {out, image.string(), parameters.string()};
}

void require_mask_options(const ConvertArguments& arguments) {
  if (writes_mask(arguments)) {
    if (arguments.filter_mask != "keepout" && arguments.filter_mask != "speed")
      throw UsageError("--filter-mask: expected keepout or speed for OUT.yaml, got " +
                       in_quotes(arguments.filter_mask));
  } else if (!arguments.filter_mask.empty()) {
    throw UsageError("--filter-mask: OUT is a mask if its name ends in .yaml, got " + in_quotes(arguments.out));
  }
}

std::string add_mask(const MapFile& map, const ConvertArguments& arguments, OutputFiles& files) {
  const bool is_speed = arguments.filter_mask == "speed";
  FilterMaskWriteOptions options{.type = is_speed ? FilterMaskType::kSpeed : FilterMaskType::kKeepOut};
  options.resolution = parse_number(arguments.resolution, "--mask-resolution");
  options.vehicle = arguments.robot;
  const FilterMaskFiles mask = to_filter_mask(map, std::filesystem::path(arguments.out).stem().string(), options);
  const std::vector<std::string> names = mask_files(arguments.out);
  files.add(names[0], mask.mask);
  files.add(names[1], mask.image);
  files.add(names[2], mask.parameters);
  std::string rows = row("zones", count_text(mask.zones) + " of a " + arguments.filter_mask + " mask");
  if (is_speed)
    rows += row("read by", "--speed-mask " + arguments.out + " --mask-type absolute --mask-base " +
                               shortest_text(mask.base) + " --mask-multiplier " + shortest_text(mask.multiplier));
  if (mask.zones == 0)
    rows += row("warning", "the map has no zone of the role " + std::string(is_speed ? "speed_limit" : "keepout") +
                               (arguments.robot.empty() ? "" : " for " + arguments.robot));
  return rows;
}

std::string picture(const MapFile& map, const std::string& name) {
  SvgPicture svg(to_world(map, name));
  if (map.start && map.goal) svg.add_poses(*map.start, *map.goal, Vehicle{}.footprint());
  svg.set_title(name);
  return svg.str();
}

int run_convert(const ConvertArguments& arguments, std::string& out) {
  const std::string ending = std::filesystem::path(arguments.out).extension().string();
  if (ending != ".geojson" && ending != ".json" && ending != ".wkt" && ending != ".svg" && !writes_mask(arguments))
    throw UsageError("OUT: expected a name that ends in .geojson, .json, .wkt, .svg or .yaml, got " +
                     in_quotes(arguments.out));
  require_mask_options(arguments);
  OutputFiles files(writes_mask(arguments) ? mask_files(arguments.out) : std::vector{arguments.out}, {arguments.map});
  const MapFile map = read_named_map(arguments.map, arguments.reading);
  files.protect(map.files);

  std::string mask_rows;
  if (writes_mask(arguments)) {
    mask_rows = add_mask(map, arguments, files);
  } else if (ending == ".wkt") {
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
  out += mask_rows;
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
  command
      .add_option("OUT", arguments->out,
                  "Map to write: .geojson, .wkt, .svg, a picture, or .yaml, a mask of Nav2's costmap filters")
      ->required();
  const auto option = [&](const char* name, std::string& value, const char* what, const char* type) {
    return command.add_option(name, value, what)->type_name(type)->group("Writing a mask");
  };
  option("--filter-mask", arguments->filter_mask, "Zones that the mask has: keepout, or speed", "NAME");
  option("--mask-resolution", arguments->resolution, "Side of a cell [m]", "M")->capture_default_str();
  option("--mask-robot", arguments->robot, "Name of the robot: keep-outs for others are left out", "NAME");
  arguments->reading.add_to(command);
  command.callback(
      [arguments, &action] { action = [arguments](std::string& out) { return run_convert(*arguments, out); }; });
}

}  // namespace arcway::internal::cli

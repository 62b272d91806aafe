#include <memory>
#include <string>
#include <utility>

#include "bench/cli/arguments.h"
#include "datasets/clutter.h"
#include "datasets/formats/geojson.h"

namespace arcway::cli {
namespace {

struct GenerateArguments {
  std::string kind;
  std::string obstacles, vertices, fill, seed, gap;
  std::string out;
};

ClutterKind kind_of(const std::string& name) {
  for (const ClutterKind kind :
       {ClutterKind::kConvex, ClutterKind::kStar, ClutterKind::kMixed, ClutterKind::kRectangle}) {
    if (name == name_of(kind)) return kind;
  }
  throw UsageError("KIND: expected convex, star, mixed or rectangle, got \"" + name + "\"");
}

int run_generate(const GenerateArguments& arguments, std::string& out) {
  ClutterParameters parameters;
  parameters.kind = kind_of(arguments.kind);
  if (!arguments.obstacles.empty()) parameters.obstacles = parse_count(arguments.obstacles, "--obstacles");
  if (!arguments.vertices.empty()) parameters.vertices = parse_count(arguments.vertices, "--vertices");
  if (!arguments.fill.empty()) parameters.fill = parse_number(arguments.fill, "--fill");
  if (!arguments.gap.empty()) parameters.min_gap = parse_number(arguments.gap, "--gap");
  if (!arguments.seed.empty()) parameters.seed = parse_count(arguments.seed, "--seed");
  Clutter clutter = generate_clutter(parameters);

  MapFile map;
  map.obstacles = std::move(clutter.obstacles);
  map.bounds = std::move(clutter.bounds);
  const World world(map.obstacles, map.bounds);
  OutputFiles files;
  files.add(arguments.out, to_geojson(map));
  out += arguments.out + ": " + name_of(parameters.kind) + " clutter, seed " + std::to_string(parameters.seed) + "\n";
  out += world_rows(world) + row("fill", fixed(parameters.fill, 4)) +
         row("smallest gap", fixed(parameters.min_gap, 3) + " m");
  files.write();
  out += files.summary();
  return kExitSolved;
}

}  // namespace

void add_generate_command(CLI::App& app, Action& action) {
  CLI::App& command = *app.add_subcommand("generate", "Generate a cluttered map, the same for the same seed");
  const auto arguments = std::make_shared<GenerateArguments>();
  const ClutterParameters defaults;
  command.add_option("KIND", arguments->kind, "convex, star, mixed or rectangle")->required();
  const auto option = [&](const char* name, std::string& value, const std::string& what,
                          const std::string& default_value) {
    command.add_option(name, value, what)->type_name("N")->default_str(default_value);
  };
  option("--obstacles", arguments->obstacles, "Obstacles", std::to_string(defaults.obstacles));
  option("--vertices", arguments->vertices, "Vertices of each obstacle", std::to_string(defaults.vertices));
  option("--fill", arguments->fill, "Share of the area that is blocked", shortest(defaults.fill));
  option("--gap", arguments->gap, "Smallest gap between obstacles [m]", shortest(defaults.min_gap));
  option("--seed", arguments->seed, "Seed", std::to_string(defaults.seed));
  command.add_option("--out", arguments->out, "Map to write")->type_name("W.geojson")->required();
  command.callback(
      [arguments, &action] { action = [arguments](std::string& out) { return run_generate(*arguments, out); }; });
}

}  // namespace arcway::cli

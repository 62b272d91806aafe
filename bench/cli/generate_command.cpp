#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arcway/datasets/catalog.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/driven_world.h"
#include "arcway/datasets/geojson.h"
#include "arcway/datasets/plan_io.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/datasets/robot.h"
#include "bench/cli/arguments.h"
#include "bench/cli/output_files.h"
#include "core/model/pose_text.h"

namespace arcway::internal::cli {
namespace {

struct GenerateArguments {
  std::string world;
  MapOptions reading;
  std::string obstacles, vertices, fill, seed, gap;
  std::string out;
  std::string queries, count = "50", query_seed = "1", robot;
  std::string robot_out, drive_out;
};

std::optional<ClutterKind> clutter_kind(const std::string& name) {
  for (const ClutterKind kind :
       {ClutterKind::kConvex, ClutterKind::kStar, ClutterKind::kMixed, ClutterKind::kRectangle}) {
    if (name == name_of(kind)) return kind;
  }
  return std::nullopt;
}

MapFile clutter_map(ClutterKind kind, const GenerateArguments& arguments, std::string& out) {
  ClutterParameters parameters;
  parameters.kind = kind;
  if (!arguments.obstacles.empty()) parameters.obstacles = parse_count(arguments.obstacles, "--obstacles");
  if (!arguments.vertices.empty()) parameters.vertices = parse_count(arguments.vertices, "--vertices");
  if (!arguments.fill.empty()) parameters.fill = parse_number(arguments.fill, "--fill");
  if (!arguments.gap.empty()) parameters.min_gap = parse_number(arguments.gap, "--gap");
  if (!arguments.seed.empty()) parameters.seed = parse_count(arguments.seed, "--seed");
  Clutter clutter = generate_clutter(parameters);
  out += row("fill", fixed(parameters.fill, 4)) + row("smallest gap", fixed(parameters.min_gap, 3) + " m") +
         row("seed", std::to_string(parameters.seed));
  MapFile map;
  map.obstacles = std::move(clutter.obstacles);
  map.bounds = std::move(clutter.bounds);
  return map;
}

// The robot and the drive of a world "driven/...", as far as they are asked for.
void add_drive(OutputFiles& files, const GenerateArguments& arguments) {
  if (arguments.robot_out.empty() && arguments.drive_out.empty()) return;
  const auto driven =
      is_catalog_name(arguments.world) ? catalog_driven_world(arguments.world) : std::optional<DrivenWorld>();
  if (!driven) {
    throw UsageError(std::string(arguments.robot_out.empty() ? "--drive-out" : "--robot-out") +
                     ": only worlds driven/... know a robot and its drive, got " + in_quotes(arguments.world));
  }
  if (!arguments.robot_out.empty()) files.add(arguments.robot_out, to_json(driven->robot) + "\n");
  if (!arguments.drive_out.empty())
    files.add(arguments.drive_out, plan_to_json(plan_of_drive(*driven), 0, driven->robot) + "\n");
}

MapFile make_map(const GenerateArguments& arguments, std::string& out) {
  if (const auto kind = clutter_kind(arguments.world)) return clutter_map(*kind, arguments, out);
  for (const auto& [option, value] : {std::pair{"--obstacles", &arguments.obstacles},
                                      {"--vertices", &arguments.vertices},
                                      {"--fill", &arguments.fill},
                                      {"--gap", &arguments.gap},
                                      {"--seed", &arguments.seed}}) {
    if (!value->empty()) {
      throw UsageError(std::string(option) + ": only with convex, star, mixed or rectangle; a name of the catalog " +
                       "says it all, got " + in_quotes(arguments.world));
    }
  }
  if (arguments.world == "-" || std::filesystem::is_regular_file(arguments.world)) {
    if (!arguments.out.empty())
      throw UsageError("--out: " + in_quotes(arguments.world) + " is a map already; arcway convert writes it anew");
    const LoadedMap map = load_map(arguments.world, arguments.reading);
    out += warning_rows(map);
    return to_map_file(map.world);
  }
  return catalog_map(arguments.world);
}

std::string queries_csv(const GenerateArguments& arguments, const World& world, std::string& warnings) {
  const Vehicle vehicle = load_vehicle(arguments.robot);
  for (const std::string& warning : vehicle_warnings(vehicle)) warnings += row("warning", warning);
  const std::vector<PlanRequest> queries = random_queries(
      world, make_reference_queries(world), vehicle,
      {.count = parse_count(arguments.count, "--count"), .seed = parse_count(arguments.query_seed, "--query-seed")});
  std::string csv = "# random poses in " + arguments.world + ", seed " + arguments.query_seed + "\n";
  csv += std::string(kQueryColumns) + "\n";
  for (std::size_t q = 0; q < queries.size(); ++q) {
    csv += std::to_string(q);
    for (const Pose& pose : {queries[q].start, queries[q].goal})
      csv += "," + shortest_text(pose.x) + "," + shortest_text(pose.y) + "," + shortest_text(pose.heading);
    csv += "\n";
  }
  return csv;
}

int run_generate(const GenerateArguments& arguments, std::string& out) {
  if (arguments.out.empty() && arguments.queries.empty() && arguments.robot_out.empty() && arguments.drive_out.empty())
    throw UsageError("generate: nothing to write; use --out W.geojson or --queries Q.csv");
  for (const char* ending : {".wkt", ".svg", ".arcway"})
    if (std::filesystem::path(arguments.out).extension() == ending)
      throw UsageError("--out: writes GeoJSON, got " + in_quotes(arguments.out) +
                       "; convert and prepare write other formats");
  OutputFiles files({arguments.out, arguments.queries, arguments.robot_out, arguments.drive_out},
                    {arguments.robot, arguments.world});
  std::string details;
  const MapFile map = make_map(arguments, details);
  const World world = to_world(map, arguments.world);
  if (!arguments.out.empty()) files.add(arguments.out, to_geojson(map));
  if (!arguments.queries.empty()) files.add(arguments.queries, queries_csv(arguments, world, details));
  add_drive(files, arguments);
  out += arguments.world + "\n" + world_rows(world) + details;
  files.write();
  out += files.summary();
  return kExitSolved;
}

std::string families_text() {
  std::string text = "Names of the catalog (parts may be left out):\n";
  for (const CatalogFamily& family : catalog_families()) {
    text.append("  ").append(family.pattern).append("\n      ").append(family.what);
    for (const std::string_view& kind : family.kinds)
      text.append(&kind == &family.kinds.front() ? "; KIND: " : ", ").append(kind);
    text += "\n";
  }
  return text;
}

}  // namespace

void add_generate_command(CLI::App& app, Action& action) {
  CLI::App& command =
      *app.add_subcommand("generate", "Generate a map, the same for the same arguments, and queries for it");
  command.footer(families_text());
  const auto arguments = std::make_shared<GenerateArguments>();
  const ClutterParameters defaults;
  command
      .add_option("WORLD", arguments->world,
                  "convex, star, mixed or rectangle; or a name of the catalog; for --queries also a map file")
      ->required();
  const auto option = [&](const char* name, std::string& value, const std::string& what,
                          const std::string& default_value) {
    command.add_option(name, value, what)->type_name("N")->default_str(default_value);
  };
  option("--obstacles", arguments->obstacles, "Obstacles", std::to_string(defaults.obstacles));
  option("--vertices", arguments->vertices, "Vertices of each obstacle", std::to_string(defaults.vertices));
  option("--fill", arguments->fill, "Share of the area that is blocked", shortest_text(defaults.fill));
  option("--gap", arguments->gap, "Smallest gap between obstacles [m]", shortest_text(defaults.min_gap));
  option("--seed", arguments->seed, "Seed", std::to_string(defaults.seed));
  command.add_option("--out", arguments->out, "Map to write")->type_name("W.geojson");
  command.add_option("--queries", arguments->queries, "Random pose pairs to write, for plan --queries")
      ->type_name("Q.csv");
  command.add_option("--count", arguments->count, "Pairs in --queries")->type_name("N")->capture_default_str();
  command.add_option("--query-seed", arguments->query_seed, "Seed of --queries")->type_name("N")->capture_default_str();
  command.add_option("--robot", arguments->robot, "Robot (JSON, YAML) that --queries are for; default: the paper's")
      ->type_name("R.json");
  command.add_option("--robot-out", arguments->robot_out, "Robot of a world driven/... to write")->type_name("R.json");
  command.add_option("--drive-out", arguments->drive_out, "Drive of a world driven/... to write, a plan for validate")
      ->type_name("P.json");
  arguments->reading.add_to(command);
  command.callback(
      [arguments, &action] { action = [arguments](std::string& out) { return run_generate(*arguments, out); }; });
}

}  // namespace arcway::internal::cli

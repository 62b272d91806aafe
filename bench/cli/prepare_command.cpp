#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "arcway/datasets/prepared_map.h"
#include "arcway/planner.h"
#include "bench/cli/arguments.h"
#include "bench/cli/output_files.h"
#include "bench/cli/progress_bar.h"

namespace arcway::internal::cli {
namespace {

struct PrepareArguments {
  std::string map;
  MapOptions reading;
  std::string kind = "feasible";
  std::string robot;
  std::string out;
  BuildOptions build;
};

int run_prepare(PrepareArguments arguments, const ProcessGroup& process_group, std::string& out) {
  if (arguments.kind != "reduced" && arguments.kind != "feasible")
    throw UsageError("--kind: expected reduced or feasible, got " + in_quotes(arguments.kind));
  if (arguments.kind == "reduced" && !arguments.robot.empty())
    throw UsageError("--robot: a reduced graph is that of any robot; leave it out, or take --kind feasible");
  arguments.build.check();
  OutputFiles files({arguments.out}, {arguments.map, arguments.robot}, process_group.rank() == 0);
  LoadedMap map = load_map(arguments.map, arguments.reading);
  files.protect(map.files);
  arguments.build.prepared = map.prepared.has_value();
  std::optional<Vehicle> vehicle;  // vehicle of the feasible graph, if one is wanted
  if (arguments.kind == "feasible") {
    vehicle = load_vehicle(arguments.robot, map);
    close_for(*vehicle, map);
  }

  const Stopwatch watch;
  const auto threads = arguments.build.executor();
  ProgressBar bar;
  const ReportingExecutor executor(*threads, bar.callback());
  const Backend backend = arguments.build.backend_for(map.world, executor, process_group);
  VisibilityGraph reduced =
      map.prepared ? std::move(map.prepared->reduced_graph) : VisibilityGraph(*backend.reduced_graph());
  const double reduced_seconds = watch.seconds();
  std::string rows = row("reduced graph", count_text(reduced.edge_count()) + " edges");
  PreparedMap prepared{map.world, {}, map.start, map.goal, std::nullopt, {}};
  if (vehicle) {
    const Planner planner(map.world, *vehicle, backend_of(map.world, backend.queries(), std::move(reduced), executor),
                          {.graph_mode = GraphMode::kEager, .process_group = &process_group});
    rows += feasible_row(planner);
    prepared = prepared_map_of(planner, map.start, map.goal);
  } else {
    prepared.reduced_graph = std::move(reduced);
  }
  const double build_seconds = watch.seconds();
  std::string bytes = to_bytes(prepared);

  out += arguments.map + ": prepared\n" + world_rows(map.world) + rows;
  out += row("build", duration_text(build_seconds) + " (reduced graph " + duration_text(reduced_seconds) + ")");
  out += row("built by", arguments.build.summary(map.world)) + row("size", count_text(bytes.size()) + " bytes") +
         warning_rows(map);
  files.add(arguments.out, std::move(bytes));
  files.write();
  out += files.summary();
  return kExitSolved;
}

}  // namespace

void add_prepare_command(CLI::App& app, Action& action, const ProcessGroup& process_group) {
  CLI::App& command = *app.add_subcommand("prepare", "Build a map's graphs once, for plan to take up");
  const auto arguments = std::make_shared<PrepareArguments>();
  command.add_option("WORLD", arguments->map, kMapHelp)->required();
  arguments->reading.add_to(command);
  command
      .add_option("--kind", arguments->kind,
                  "reduced (of any robot, which plan then checks) or feasible (checked for one robot as well)")
      ->type_name("KIND")
      ->capture_default_str();
  command.add_option("--robot", arguments->robot, kRobotHelp)->type_name("R.json");
  arguments->build.add_to(command);
  command.add_option("--out", arguments->out, "File to write")->type_name("F.arcway")->required();
  command.callback([arguments, &action, &process_group] {
    action = [arguments, &process_group](std::string& out) { return run_prepare(*arguments, process_group, out); };
  });
}

}  // namespace arcway::internal::cli

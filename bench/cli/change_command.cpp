#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arcway/datasets/map_file.h"
#include "arcway/datasets/prepared_map.h"
#include "arcway/planner.h"
#include "arcway/world_change.h"
#include "bench/cli/added_maps.h"
#include "bench/cli/arguments.h"
#include "bench/cli/output_files.h"
#include "bench/cli/progress_bar.h"
#include "core/model/pose_text.h"
#include "datasets/io/shortened.h"

namespace arcway::internal::cli {
namespace {

struct ChangeArguments {
  std::string map;
  MapOptions reading;
  std::vector<std::string> removed, added;
  std::string out;
  BuildOptions build;
};

std::vector<ObstacleId> removed_obstacles(const ChangeArguments& arguments, const World& world) {
  std::vector<ObstacleId> removed;
  for (const std::string& text : arguments.removed) {
    const std::uint64_t id = parse_count(text, "--remove");
    if (id >= world.obstacle_count())
      throw UsageError("--remove: obstacle " + shortened(text) + " of " + arguments.map + ", which has " +
                       count_text(world.obstacle_count()) + ", counted from 0");
    removed.push_back(static_cast<ObstacleId>(id));
  }
  std::sort(removed.begin(), removed.end());
  if (const auto twice = std::adjacent_find(removed.begin(), removed.end()); twice != removed.end())
    throw UsageError("--remove: obstacle " + std::to_string(*twice) + " is named twice");
  return removed;
}

int run_change(const ChangeArguments& arguments, std::string& out) {
  if (arguments.removed.empty() && arguments.added.empty())
    throw UsageError("nothing to change: give --add MAP or --remove ID");
  arguments.build.check();
  OutputFiles files({arguments.out}, {arguments.map});
  files.protect({arguments.added.begin(), arguments.added.end()});
  LoadedMap map = load_map(arguments.map, {});  // options for reading are those of the maps to be added
  if (!map.prepared) throw UsageError(arguments.map + ": no prepared map; arcway prepare makes one");
  PreparedMap& prepared = *map.prepared;
  const std::vector<ObstacleId> removed = removed_obstacles(arguments, map.world);
  const std::vector<Polygon> added = added_obstacles({arguments.added, arguments.reading, arguments.map}, map, files);
  const auto threads = arguments.build.executor();
  ProgressBar bar;
  const ReportingExecutor executor(*threads, bar.callback());

  // What was prepared, taken up as it is; its time is none of the change.
  std::optional<Planner> before;
  if (prepared.robot) {
    const Vehicle vehicle(prepared.robot->parameters);
    warn_of(vehicle, map);
    PreparedGraph graphs{prepared.reduced_graph, prepared.robot->radii, std::move(prepared.robot->feasible)};
    try {
      before = Planner::restored(map.world, vehicle, arguments.build.backend_for(map.world, *threads, kSingleProcess),
                                 std::move(graphs));
    } catch (const SnapshotError& error) {
      throw FormatError(prepared.source.complaint(error));
    }
  }

  const Stopwatch watch;
  const World after = map.world.changed(removed, added);
  const WorldChange change(map.world, after, removed);
  const Backend backend = arguments.build.backend_for(after, executor, kSingleProcess);
  std::string rows;
  PreparedMap result{after, {}, map.start, map.goal, std::nullopt, {}};
  if (before) {
    const Planner planner = Planner::changed(*before, change, backend);
    rows = feasible_row(planner);
    result = prepared_map_of(planner, map.start, map.goal);
  } else {
    result.reduced_graph = *backend.changed_graph(prepared.reduced_graph, change);
  }
  rows = row("reduced graph", count_text(result.reduced_graph.edge_count()) + " edges") + rows;
  const double seconds = watch.seconds();
  std::string bytes = to_bytes(result);

  out += arguments.map + ": " + count_text(removed.size()) +
         (removed.size() == 1 ? " obstacle removed, " : " obstacles removed, ") + count_text(added.size()) +
         " added\n" + world_rows(after) + rows + row("change", duration_text(seconds)) +
         row("size", count_text(bytes.size()) + " bytes") + warning_rows(map);
  files.add(arguments.out, std::move(bytes));
  files.write();
  out += files.summary();
  return kExitSolved;
}

}  // namespace

void add_change_command(CLI::App& app, Action& action) {
  CLI::App& command =
      *app.add_subcommand("change", "Remove obstacles from a prepared map and add others, without building it anew");
  const auto arguments = std::make_shared<ChangeArguments>();
  command.add_option("PREPARED", arguments->map, "Prepared map: a file that prepare or change wrote")->required();
  arguments->reading.add_to(command, "MAP");
  command
      .add_option("--remove", arguments->removed,
                  "Obstacle to remove, by its number in the prepared map, from 0; repeated, or several with commas")
      ->type_name("ID")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--add", arguments->added,
                  "Map whose obstacles are added: after the last one, or in the place of a removed one with as many "
                  "vertices; repeated: in this order")
      ->type_name("MAP")
      ->allow_extra_args(false);
  arguments->build.add_to(command);
  command.add_option("--out", arguments->out, "File to write")->type_name("F.arcway")->required();
  command.callback(
      [arguments, &action] { action = [arguments](std::string& out) { return run_change(*arguments, out); }; });
}

}  // namespace arcway::internal::cli

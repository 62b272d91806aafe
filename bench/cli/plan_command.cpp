#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arcway/datasets/moving_io.h"
#include "arcway/datasets/robot.h"
#include "arcway/planner.h"
#include "arcway/stop_clock.h"
#include "arcway/world_change.h"
#include "bench/cli/added_maps.h"
#include "bench/cli/arguments.h"
#include "bench/cli/output_files.h"
#include "bench/cli/plan_arguments.h"
#include "bench/cli/plan_one.h"
#include "bench/cli/plan_queries.h"
#include "bench/cli/progress_bar.h"
#include "core/planner/no_path.h"

namespace arcway::internal::cli {
namespace {

/// Makes a planner from the prepared map, as far as it fits this vehicle. The rest is built, or found when a search
/// asks for it.
/// @throws Canceled if the clock is over before that is done.
Planner make_planner(const PlanArguments& arguments, LoadedMap& map, const Vehicle& vehicle,
                     const ProcessGroup& process_group, const StopClock& clock) {
  const PlannerOptions options = arguments.planner_options(process_group);
  const auto arena = arguments.build.executor();
  const StoppableExecutor threads(*arena, clock);
  ProgressBar bar;
  const ReportingExecutor executor(threads, bar.callback());
  close_for(vehicle, map);
  const Backend backend = arguments.build.backend_for(map.world, executor, process_group);
  if (!map.prepared) return {map.world, vehicle, backend, options};
  VisibilityGraph& reduced = map.prepared->reduced_graph;
  auto& robot = map.prepared->robot;
  if (!robot || to_json(robot->parameters) != to_json(vehicle.parameters()))
    return {map.world, vehicle, backend_of(map.world, backend.queries(), std::move(reduced), executor), options};
  try {
    PreparedGraph graphs{std::move(reduced), std::move(robot->radii), std::move(robot->feasible)};
    return Planner::restored(map.world, vehicle, backend, std::move(graphs), options);
  } catch (const SnapshotError& error) {
    throw FormatError(map.prepared->source.complaint(error));
  }
}

/// The planner for the map with what --add names. Of a prepared map all is kept that lies far from that.
/// @throws Canceled as make_planner does.
Planner make_planner_with_added(const PlanArguments& arguments, LoadedMap& map, const Vehicle& vehicle,
                                const ProcessGroup& process_group, const StopClock& clock) {
  Planner planner = make_planner(arguments, map, vehicle, process_group, clock);
  if (map.added.empty()) return planner;
  const std::vector<ObstacleId> removed;
  const World without = map.world;
  map.world = without.changed(removed, map.added);
  const auto arena = arguments.build.executor();
  const StoppableExecutor executor(*arena, clock);
  const Backend backend = arguments.build.backend_for(map.world, executor, process_group);
  return Planner::changed(planner, WorldChange(without, map.world, removed), backend,
                          arguments.planner_options(process_group));
}

/// Adds the obstacles of --add, at once unless the map is prepared.
void add_obstacles(const PlanArguments& arguments, LoadedMap& map, OutputFiles& files) {
  map.added = added_obstacles({arguments.added, arguments.reading, arguments.map}, map, files);
  if (map.prepared || map.added.empty()) return;
  map.world = map.world.changed({}, map.added);
  if (!map.curved.curves.empty())
    map.curved.polygons.insert(map.curved.polygons.end(), map.added.begin(), map.added.end());
  map.added.clear();
}

// Warns of poses with doubtful headings.
void warn_of_poses(const PlanArguments& arguments, const Pose& start, const TourRequest& request, LoadedMap& map) {
  const auto look = [&](const char* what, double heading) {
    if (std::string warning = heading_warning(what, heading); !warning.empty())
      map.warnings.push_back(std::move(warning));
  };
  if (!arguments.start.empty()) look("start", start.heading);  // the map's own poses have been checked
  for (const Place& place : request.waypoints)
    if (place.heading) look("waypoint", *place.heading);
  for (const Place& place : request.goals)
    if (place.heading && !arguments.goals.empty()) look("goal", *place.heading);
  if (arguments.reading.lonlat &&
      (!arguments.start.empty() || !arguments.goals.empty() || !arguments.waypoints.empty()))
    map.notes.push_back("--start, --goal and --waypoint are meters from there, not degrees");
}

// What the command line asks for, before the map is read.
struct Requests {
  std::optional<Pose> start;
  TourRequest tour;
  std::vector<NumberedRequest> queries;
  std::vector<std::string> warnings;  // warnings about the file of queries
};

Requests read_requests(const PlanArguments& arguments) {
  Requests requests;
  const double cusp_cost = arguments.cusp_cost_seconds();
  const std::optional<std::uint32_t> max_gear_changes = arguments.most_gear_changes();
  const EndSpeeds ends = arguments.end_speeds();
  requests.tour.reverse = arguments.reverse;
  requests.tour.cusp_cost = cusp_cost;
  requests.tour.max_gear_changes = max_gear_changes;
  if (!arguments.start.empty()) requests.start = parse_pose(arguments.start, "--start");
  for (const std::string& waypoint : arguments.waypoints)
    requests.tour.waypoints.push_back(parse_place(waypoint, "--waypoint"));
  for (const std::string& goal : arguments.goals) requests.tour.goals.push_back(parse_place(goal, "--goal"));
  if (arguments.batch()) requests.queries = read_queries(arguments.queries, requests.warnings);
  for (NumberedRequest& query : requests.queries) {
    query.request.reverse = arguments.reverse;
    query.request.cusp_cost = cusp_cost;
    query.request.max_gear_changes = max_gear_changes;
    query.request.start_speed = ends.start;
    query.request.goal_speed = ends.goal;
  }
  return requests;
}

// Takes start and goal from the map where the command line has none, and warns of doubtful poses.
void complete(const PlanArguments& arguments, LoadedMap& map, Requests& requests) {
  TourRequest& tour = requests.tour;
  if (!requests.start) requests.start = map.start;
  if (tour.goals.empty() && map.goal) tour.goals.push_back({map.goal->position(), map.goal->heading});
  if (!requests.start) throw UsageError("--start X,Y,HEADING is missing, and " + arguments.map + " has no start");
  if (tour.goals.empty()) throw UsageError("--goal X,Y,HEADING is missing, and " + arguments.map + " has no goal");
  tour.start = *requests.start;
  warn_of_poses(arguments, tour.start, tour, map);
}

int run_plan(PlanArguments arguments, const ProcessGroup& process_group, std::string& out) {
  const bool batch = arguments.batch();
  arguments.check();
  const PlannerOptions options = arguments.planner_options(process_group);
  const PlanLimits limits = arguments.limits();
  if (!arguments.moving.empty()) arguments.obstacles = read_moving_obstacles(input_file(arguments.moving));
  Requests requests = read_requests(arguments);
  const auto& [start, request, queries, query_warnings] = requests;

  OutputFiles files(arguments.outputs(), arguments.inputs(), process_group.rank() == 0);
  LoadedMap map = load_map(arguments.map, arguments.reading);
  files.protect(map.files);
  add_obstacles(arguments, map, files);
  arguments.build.prepared = map.prepared.has_value();
  const Vehicle vehicle = load_vehicle(arguments.robot, map);
  map.warnings.insert(map.warnings.end(), query_warnings.begin(), query_warnings.end());
  if (!batch) complete(arguments, map, requests);

  // A single process that stops building would leave the others waiting for it. With many queries, each has the limit.
  const StopClock clock(batch || process_group.size() > 1 ? std::numeric_limits<double>::infinity() : limits.time);
  const auto arena = arguments.build.executor();
  const StoppableExecutor executor(*arena, clock);
  const auto plan_on = [&](const World& world) {
    return Planner(world, vehicle, arguments.build.backend_for(world, executor, process_group), options);
  };
  // Tours and alternatives keep to the rings of the map.
  const bool plain = !batch && arguments.alternatives == 1 && request.waypoints.empty() && request.goals.size() == 1 &&
                     request.goals[0].heading;
  try {
    if (plain && !map.curved.curves.empty()) return plan_curved(arguments, map, request, plan_on, {files, out});
    const Stopwatch watch;
    const Planner planner = make_planner_with_added(arguments, map, vehicle, process_group, clock);
    if (batch && map.prepared) planner.warm_up(std::min(arguments.build.thread_count(), queries.size()));
    const double build_seconds = watch.seconds();
    const PreparedPlanner prepared{arguments, map, planner, build_seconds};
    if (batch) return answer_queries(prepared, queries, process_group, {files, out});
    PlanLimits rest = limits;
    rest.time = std::min(limits.time, clock.seconds_left());
    std::vector<CheckedPlan> plans = plans_of(arguments, planner, request, rest);
    for (CheckedPlan& plan : plans)
      if (plan.result.status == PlanStatus::kTimeLimit) plan.result.reason = time_limit_reason(limits);
    return plan_one(prepared, request, plans, {files, out});
  } catch (const Canceled&) {
    return no_plan(arguments, map, request, {files, out});
  }
}

}  // namespace

void add_plan_command(CLI::App& app, Action& action, const ProcessGroup& process_group) {
  CLI::App& command = *app.add_subcommand("plan", "Plan the fastest path from start to goal, or many on one map");
  const auto arguments = std::make_shared<PlanArguments>();
  arguments->add_to(command);
  command.callback([arguments, &action, &process_group] {
    action = [arguments, &process_group](std::string& out) { return run_plan(*arguments, process_group, out); };
  });
}

}  // namespace arcway::internal::cli

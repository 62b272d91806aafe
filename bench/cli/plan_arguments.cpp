#include "bench/cli/plan_arguments.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "arcway/datasets/svg.h"
#include "core/base/shortest_text.h"

namespace arcway::internal::cli {
namespace {

Heuristic heuristic_of(const std::string& name) {
  if (name == "travel_time") return Heuristic::kTravelTime;
  if (name == "paper") return Heuristic::kPaperDistance;
  if (name == "dijkstra") return Heuristic::kDijkstra;
  throw UsageError("--heuristic: expected travel_time, paper or dijkstra, got " + in_quotes(name));
}

GraphMode graph_mode_of(const std::string& name, bool batch) {
  if (name.empty()) return batch ? GraphMode::kEager : GraphMode::kLazy;
  if (name == "eager") return GraphMode::kEager;
  if (name == "lazy") return GraphMode::kLazy;
  throw UsageError("--graph: expected eager or lazy, got " + in_quotes(name));
}

}  // namespace

void PlanArguments::add_to(CLI::App& command) {
  command.add_option("WORLD", map, kMapHelp)->required();
  reading.add_to(command);
  command.add_option("--add", added, "Map whose obstacles come after those of WORLD, as what a robot sees; repeated")
      ->type_name("MAP")
      ->allow_extra_args(false);
  command.add_option("--robot", robot, kRobotHelp)->type_name("R.json");
  command.add_option("--start", start, "Start pose; default: the map's")->type_name("X,Y,HEADING");
  command
      .add_option("--goal", goals,
                  "Goal, without HEADING in any; repeated: the one that is reached first; default: the map's")
      ->type_name("X,Y[,HEADING]")
      ->allow_extra_args(false);
  command.add_option("--waypoint", waypoints, "Waypoint to pass; repeated: in this order")
      ->type_name("X,Y[,HEADING]")
      ->allow_extra_args(false);
  command
      .add_option("--alternatives", alternatives,
                  "So many ways, the fastest first, which pass some obstacle on different sides")
      ->type_name("K")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command.add_option("--queries", queries, std::string("Many queries: ") + kQueryColumns)->type_name("Q.csv");
  command.add_option("--out", out, "Results of --queries, one line a query")->type_name("R.csv");
  command.add_option("--heuristic", heuristic, "travel_time (admissible), paper (distance) or dijkstra")
      ->type_name("NAME")
      ->capture_default_str();
  command
      .add_option("--suboptimality", suboptimality,
                  "Searches may find a path 1 + W times as long in time as the fastest of the graph; default: 0, on "
                  "maps of more than " +
                      count_text(PlannerOptions::kExactVertices) + " convex vertices " +
                      shortest_text(PlannerOptions::kLargeMapSuboptimality))
      ->type_name("W");
  command
      .add_option("--graph", graph,
                  "eager (check all bitangents first), the default of --queries, or lazy (as the search needs them), "
                  "that of one query")
      ->type_name("MODE");
  command
      .add_option("--time-limit", time_limit,
                  "Of planning, from the read map on: the graph's building is part of it; of --queries for each query, "
                  "without the building. Then the best path found so far, if any")
      ->type_name("SECONDS");
  add_driving_to(command);
  command.add_option("--refine-trials", refine_trials, "Paths that refinement may try; 0 leaves it out")
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--leave-out", leave_out,
                  "Row of the strategy or move of refinement to do without, see core/README.md; repeated")
      ->type_name("NAME");
  build.add_to(command);
  add_outputs_to(command);
}

void PlanArguments::add_driving_to(CLI::App& command) {
  command.add_flag("--reverse", reverse, "Drive backwards as well, where that is faster or nothing else leads there");
  command.add_option("--cusp-cost", cusp_cost, "Of a change of gear, beside the time to stop; default: 0")
      ->type_name("SECONDS");
  command.add_option("--max-gear-changes", max_gear_changes, "Only paths with at most so many; default: any number")
      ->type_name("N");
  command
      .add_option("--start-speed", start_speed,
                  "With which the plan begins, negative backwards; default: 0, at rest. With --queries of each plan")
      ->type_name("M/S");
  command.add_option("--goal-speed", goal_speed, "With which the plan ends; likewise")->type_name("M/S");
  CLI::Option* preferred =
      command
          .add_option("--prefer-clearance", prefer_clearance,
                      "Keep the body so far from obstacles where there is room: driving closer costs")
          ->type_name("M");
  command
      .add_option("--clearance-cost", clearance_cost,
                  "Of each meter driven closer than --prefer-clearance; default: " +
                      shortest_text(ClearancePreference::kHighCost))
      ->type_name("S/M")
      ->needs(preferred);
  CLI::Option* named =
      command
          .add_option("--moving", moving, "Moving obstacles, as JSON: the plan waits for them, or drives more slowly")
          ->type_name("M.json");
  command
      .add_option("--horizon", horizon,
                  "Time up to which --moving is looked at; default: " + shortest_text(EvasionOptions{}.horizon) +
                      ", or twice the plan's travel time if that is more")
      ->type_name("SECONDS")
      ->needs(named);
}

void PlanArguments::add_outputs_to(CLI::App& command) {
  CLI::Option* picture = command.add_option("--svg", svg, "Write a picture")->type_name("F.svg");
  command
      .add_option("--svg-layers", svg_layers,
                  "What it shows: bounds,obstacles,zones,graph,swept,path,robot,numbers,axes,markers")
      ->type_name("LAYER,...")
      ->delimiter(',')
      ->default_str("all but graph and numbers")
      ->needs(picture);
  command.add_option("--svg-view", svg_view, "What part it shows: the whole map, or the path's surroundings")
      ->type_name("map|path")
      ->capture_default_str()
      ->needs(picture);
  command.add_option("--svg-color", svg_color, "What the path's color shows: the gear, or the speed, with a legend")
      ->type_name("gear|speed")
      ->capture_default_str()
      ->needs(picture);
  command.add_flag("--svg-inset", svg_inset, "Magnify the place of the smallest clearance in a corner of the picture")
      ->needs(picture);
  command.add_option("--json", json, "Write the exact plan; with --queries one object a line")->type_name("F.json");
  command.add_option("--csv", csv, "Write the path as samples; of --alternatives the first")->type_name("F.csv");
  command.add_option("--ros-path", ros_path, "Write the path as a nav_msgs/Path in JSON; likewise")
      ->type_name("F.json");
  command
      .add_option("--sample-step", sample_step,
                  "Largest distance between samples of --csv and --ros-path [m]; default: 0.5")
      ->type_name("M");
}

std::vector<std::string> PlanArguments::inputs() const {
  std::vector<std::string> files{map, robot, queries, moving};
  files.insert(files.end(), added.begin(), added.end());
  return files;
}

void PlanArguments::check() const {
  if (batch()) {
    if (out.empty()) throw UsageError("--queries: needs --out R.csv for the results");
    if (!start.empty() || !goals.empty() || !waypoints.empty() || alternatives > 1) {
      throw UsageError(
          "--queries: start and goal come from the file; leave out --start, --goal, --waypoint, --alternatives");
    }
    if (!svg.empty() || !csv.empty() || !ros_path.empty()) {
      throw UsageError("--queries: --svg, --csv and --ros-path show one plan; leave them out");
    }
  } else if (!out.empty()) {
    throw UsageError("--out: only with --queries; see --json and --csv for one plan");
  }
  if (!moving.empty() && (batch() || alternatives > 1 || !waypoints.empty()))
    throw UsageError("--moving: only a single plan evades; leave out --queries, --alternatives and --waypoint");
  if (!(evasion(0.0).horizon > 0.0)) throw UsageError("--horizon: above 0 s, got " + in_quotes(horizon));
  if (!sample_step.empty() && csv.empty() && ros_path.empty())
    throw UsageError("--sample-step: only with --csv or --ros-path");
  if (!(sampling().max_length > 0.0)) throw UsageError("--sample-step: above 0 m, got " + in_quotes(sample_step));
  build.check();
  if (svg_view != "map" && svg_view != "path")
    throw UsageError("--svg-view: expected map or path, got " + in_quotes(svg_view));
  if (svg_color != "gear" && svg_color != "speed")
    throw UsageError("--svg-color: expected gear or speed, got " + in_quotes(svg_color));
  for (const std::string& layer : svg_layers)
    if (std::ranges::find(SvgPicture::layers(), layer) == SvgPicture::layers().end())
      throw UsageError(
          "--svg-layers: expected bounds, obstacles, zones, graph, swept, path, robot, numbers, axes or markers, got " +
          in_quotes(layer));
}

PlannerOptions PlanArguments::planner_options(const ProcessGroup& process_group) const {
  PlannerOptions options;
  options.heuristic = heuristic_of(heuristic);
  if (!suboptimality.empty()) options.suboptimality = parse_number(suboptimality, "--suboptimality");
  if (options.suboptimality && *options.suboptimality < 0.0)
    throw UsageError("--suboptimality: at least 0, got " + in_quotes(suboptimality));
  options.graph_mode = graph_mode_of(graph, batch());
  constexpr std::uint64_t kMostTrials = std::numeric_limits<std::uint32_t>::max();
  const std::uint64_t trials = parse_count(refine_trials, "--refine-trials");
  if (trials > kMostTrials)
    throw UsageError("--refine-trials: at most " + std::to_string(kMostTrials) + ", got " + in_quotes(refine_trials));
  options.refinement.max_trials = static_cast<std::uint32_t>(trials);
  options.leave_out = leave_out;
  options.clearance_preference = clearance_preference();
  options.process_group = &process_group;
  return options;
}

std::optional<ClearancePreference> PlanArguments::clearance_preference() const {
  if (prefer_clearance.empty()) return std::nullopt;
  ClearancePreference preference{.distance = parse_number(prefer_clearance, "--prefer-clearance")};
  if (!(preference.distance > 0.0))
    throw UsageError("--prefer-clearance: above 0 m, got " + in_quotes(prefer_clearance));
  if (clearance_cost.empty()) return preference;
  preference.cost = parse_number(clearance_cost, "--clearance-cost");
  if (preference.cost < 0.0) throw UsageError("--clearance-cost: at least 0 s/m, got " + in_quotes(clearance_cost));
  return preference;
}

PlanLimits PlanArguments::limits() const {
  PlanLimits limits{.prefetch = build.thread_count() > 1};
  const std::string& text = time_limit;
  if (text.empty()) return limits;
  limits.time = parse_number(text, "--time-limit");
  if (limits.time < 0.0) throw UsageError("--time-limit: at least 0 s, got " + in_quotes(text));
  return limits;
}

double PlanArguments::cusp_cost_seconds() const {
  const std::string& text = cusp_cost;
  if (text.empty()) return 0.0;
  if (!reverse) throw UsageError("--cusp-cost: only with --reverse");
  const double seconds = parse_number(text, "--cusp-cost");
  if (seconds < 0.0) throw UsageError("--cusp-cost: at least 0 s, got " + in_quotes(text));
  return seconds;
}

std::optional<std::uint32_t> PlanArguments::most_gear_changes() const {
  const std::string& text = max_gear_changes;
  if (text.empty()) return std::nullopt;
  if (!reverse) throw UsageError("--max-gear-changes: only with --reverse");
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  const std::uint64_t count = parse_count(text, "--max-gear-changes");
  if (count > kMost)
    throw UsageError("--max-gear-changes: at most " + std::to_string(kMost) + ", got \"" + text + "\"");
  return static_cast<std::uint32_t>(count);
}

EndSpeeds PlanArguments::end_speeds() const {
  const auto speed = [](const std::string& text, const char* option) {
    return text.empty() ? 0.0 : parse_number(text, option);
  };
  return {speed(start_speed, "--start-speed"), speed(goal_speed, "--goal-speed")};
}

EvasionOptions PlanArguments::evasion(double travel_time) const {
  constexpr double kHorizonShare = 2.0;  // of the travel time: as long again to wait
  if (!horizon.empty()) return {.horizon = parse_number(horizon, "--horizon")};
  return {.horizon = std::max(EvasionOptions{}.horizon, kHorizonShare * travel_time)};
}

PathSampling PlanArguments::sampling() const {
  PathSampling sampling;
  if (!sample_step.empty()) sampling.max_length = parse_number(sample_step, "--sample-step");
  return sampling;
}

}  // namespace arcway::internal::cli

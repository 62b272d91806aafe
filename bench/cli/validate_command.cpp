#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arcway/datasets/file_io.h"
#include "arcway/datasets/moving_io.h"
#include "arcway/datasets/plan_io.h"
#include "arcway/validation.h"
#include "bench/cli/arguments.h"
#include "core/base/shortest_text.h"
#include "core/model/body_size.h"
#include "datasets/io/shortened.h"

namespace arcway::internal::cli {
namespace {

struct ValidateArguments {
  std::string map;
  MapOptions reading;
  std::string path;
  std::string robot;
  std::string moving;                     // file, or none
  std::vector<MovingObstacle> obstacles;  // of that file
};

/// Where a plan's robot is from, in words, and the robot.
std::pair<std::string, Vehicle> robot_of(const ValidateArguments& arguments, LoadedMap& map, const std::string& name,
                                         const PlanFile& plan) {
  if (!arguments.robot.empty()) return {arguments.robot, load_vehicle(arguments.robot)};
  try {
    if (plan.robot) return {"that of the plan", Vehicle(*plan.robot)};
  } catch (const std::invalid_argument& error) {
    throw UsageError(name + ": robot: " + error.what());
  }
  return {map.prepared && map.prepared->robot ? "that of the map" : "the paper's, as the plan names none",
          load_vehicle("", map)};
}

/// What a file says of its path, and what was found.
void compare(const char* what, const char* unit, std::optional<double> said, double found,
             std::vector<std::string>& complaints) {
  constexpr double kTolerance = 1e-6;  // relative error of rounding
  if (said && !(std::abs(*said - found) <= kTolerance * std::max(1.0, found)))
    complaints.push_back(std::string(what) + ": the file says " + shortest_text(*said) + unit + ", the path's is " +
                         shortest_text(found) + unit);
}

/// A plan, and what messages call it.
struct NamedPlan {
  std::string name;
  const PlanFile& plan;
};

/// The validator's verdict on one plan; none if it has no path and says why. An empty path stays at the start.
std::optional<bool> validate_plan(const ValidateArguments& arguments, LoadedMap& map, const Validator& validator,
                                  const NamedPlan& named, std::string& out) {
  const auto& [name, plan] = named;
  if (plan.path.segments.empty() && !plan.status.empty() && plan.status != name_of(PlanStatus::kSolved)) {
    out += name + ": no path to check (" + shortened(plan.status) + ")\n";
    return std::nullopt;
  }
  const auto [origin, vehicle] = robot_of(arguments, map, name, plan);
  warn_of(vehicle, map);
  const Stopwatch watch;
  const ValidationOptions options{
      .start_speed = plan.start_speed, .goal_speed = plan.goal_speed, .moving = arguments.obstacles};
  const ValidationReport report = validator(vehicle, plan.start, plan.goal, plan.path, options);
  const double seconds = watch.seconds();

  std::vector<std::string> complaints;
  compare("length", " m", plan.length, report.length, complaints);
  if (!plan.path.durations.empty()) compare("travel time", " s", plan.travel_time, report.travel_time, complaints);
  compare("changes of gear", "", plan.gear_changes, static_cast<double>(cusps_of(plan.path.segments)), complaints);
  const bool valid = report.valid() && complaints.empty();

  out += name + ": " + (valid ? "valid" : "NOT VALID") + "\n";
  for (const ValidationIssue& issue : report.issues) {
    out += row(name_of(issue.violation), "segment " + std::to_string(issue.segment) + " at " +
                                             fixed(issue.arc_length, 6) + " m: " + issue.message);
  }
  for (const Conflict& conflict : report.conflicts) out += row("conflict", to_string(conflict));
  for (const std::string& complaint : complaints) out += row("totals", complaint);
  out += row("robot", origin + ": " + fixed(body_length(vehicle), 3) + " x " + fixed(body_width(vehicle), 3) +
                          " m, turning radius from " + fixed(vehicle.min_turning_radius(), 3) + " m");
  out += row("start", pose_text(plan.start));
  out += row("goal", pose_text(plan.goal));
  out += row("segments", count_text(plan.path.segments.size()) +
                             (plan.path.durations.empty() ? ", geometry only: no speeds given" : ""));
  out += row("length", fixed(report.length, 3) + " m");
  if (!plan.path.durations.empty()) out += row("travel time", fixed(report.travel_time, 3) + " s");
  out += row("smallest clearance", "at least " + fixed(report.min_clearance, 6) + " m");
  out += row("checked in", duration_text(seconds));
  return valid;
}

int run_validate(ValidateArguments arguments, std::string& out) {
  if (!arguments.moving.empty()) arguments.obstacles = read_moving_obstacles(input_file(arguments.moving));
  LoadedMap map = load_map(arguments.map, arguments.reading);
  const std::vector<PlanOnLine> plans = parse_plans(read_file(input_file(arguments.path)), arguments.path);
  const Validator validator(map.world);
  std::size_t paths = 0;
  std::size_t valid = 0;
  for (const auto& [line, plan] : plans) {
    std::string name = arguments.path;
    if (plans.size() > 1) name += ":" + std::to_string(line) + (plan.q ? ": query " + std::to_string(*plan.q) : "");
    const std::optional<bool> verdict = validate_plan(arguments, map, validator, {name, plan}, out);
    paths += verdict ? 1 : 0;
    valid += verdict && *verdict ? 1 : 0;
  }
  if (const std::size_t none = plans.size() - paths; plans.size() > 1) {
    out += "\n" + row("valid", count_text(valid) + " of " + count_text(paths) + " paths" +
                                   (none == 0   ? ""
                                    : none == 1 ? ", 1 plan has none"
                                                : ", " + count_text(none) + " plans have none"));
  }
  if (paths > 0) out += warning_rows(map);
  return paths > 0 && valid == paths ? kExitSolved : kExitNoPath;
}

}  // namespace

void add_validate_command(CLI::App& app, Action& action) {
  CLI::App& command = *app.add_subcommand("validate",
                                          "Check a path, whoever made it: collision, joints, curvature, "
                                          "speeds, accelerations, durations");
  const auto arguments = std::make_shared<ValidateArguments>();
  command.add_option("WORLD", arguments->map, kMapHelp)->required();
  arguments->reading.add_to(command);
  command
      .add_option("--path", arguments->path,
                  "Plan, or plans, as written by plan --json; or a path by --csv or --ros-path")
      ->type_name("P")
      ->required();
  command
      .add_option("--robot", arguments->robot,
                  "Robot (JSON, YAML); default: the plan's, else the map's, else the paper's")
      ->type_name("R.json");
  command.add_option("--moving", arguments->moving, "Moving obstacles that the motion must not meet, as JSON")
      ->type_name("M.json");
  command.callback(
      [arguments, &action] { action = [arguments](std::string& out) { return run_validate(*arguments, out); }; });
}

}  // namespace arcway::internal::cli

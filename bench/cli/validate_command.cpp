#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/cli/arguments.h"
#include "core/path/validation.h"
#include "datasets/file_io.h"
#include "datasets/plan_io.h"

namespace arcway::cli {
namespace {

struct ValidateArguments {
  std::string map;
  MapOptions reading;
  std::string path;
  std::string robot;
};

/// What the validator says of one plan; none if it has no path.
std::optional<bool> validate_plan(const LoadedMap& map, const Vehicle& vehicle, const std::string& name,
                                  const PlanFile& plan, std::string& out) {
  if (plan.path.segments.empty()) {
    out += name + ": no path to check" + (plan.status.empty() ? "" : " (" + plan.status + ")") + "\n";
    return std::nullopt;
  }
  const Stopwatch watch;
  const ValidationReport report = validate(map.world, vehicle, plan.start, plan.goal, plan.path);
  const double seconds = watch.seconds();

  out += name + ": " + (report.valid() ? "valid" : "NOT VALID") + "\n";
  for (const ValidationIssue& issue : report.issues) {
    out += row(name_of(issue.violation), "segment " + std::to_string(issue.segment) + " at " +
                                             fixed(issue.arc_length, 6) + " m: " + issue.message);
  }
  out += row("start", pose_text(plan.start));
  out += row("goal", pose_text(plan.goal));
  out += row("segments", count_text(plan.path.segments.size()) +
                             (plan.path.durations.empty() ? ", geometry only: no speeds given" : ""));
  out += row("length", fixed(report.length, 3) + " m");
  if (!plan.path.durations.empty()) out += row("travel time", fixed(report.travel_time, 3) + " s");
  out += row("smallest clearance", "at least " + fixed(report.min_clearance, 6) + " m");
  out += row("checked in", duration_text(seconds));
  return report.valid();
}

int run_validate(const ValidateArguments& arguments, std::string& out) {
  const LoadedMap map = load_map(arguments.map, arguments.reading);
  const Vehicle vehicle = load_vehicle(arguments.robot, map);
  const std::vector<PlanOnLine> plans = read_plans(read_file(arguments.path), arguments.path);
  std::size_t paths = 0;
  std::size_t valid = 0;
  for (const auto& [line, plan] : plans) {
    std::string name = arguments.path;
    if (plans.size() > 1) name += ":" + std::to_string(line) + (plan.q ? ": query " + std::to_string(*plan.q) : "");
    const std::optional<bool> verdict = validate_plan(map, vehicle, name, plan, out);
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
  command.add_option("--path", arguments->path, "Plan, or plans, as written by plan --json")
      ->type_name("P.json")
      ->required();
  command.add_option("--robot", arguments->robot, kRobotHelp)->type_name("R.json");
  command.callback(
      [arguments, &action] { action = [arguments](std::string& out) { return run_validate(*arguments, out); }; });
}

}  // namespace arcway::cli

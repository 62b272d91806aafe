#include <memory>
#include <string>

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

int run_validate(const ValidateArguments& arguments, std::string& out) {
  const LoadedMap map = load_map(arguments.map, arguments.reading);
  const Vehicle vehicle = load_vehicle(arguments.robot, map);
  const PlanFile plan = read_plan(read_file(arguments.path), arguments.path);
  if (plan.path.segments.empty()) {
    out += arguments.path + ": no path to check" + (plan.status.empty() ? "" : " (" + plan.status + ")") + "\n";
    return kExitNoPath;
  }
  const Stopwatch watch;
  const ValidationReport report = validate(map.world, vehicle, plan.start, plan.goal, plan.path);
  const double seconds = watch.seconds();

  out += arguments.path + ": " + (report.valid() ? "valid" : "NOT VALID") + "\n";
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
  out += warning_rows(map);
  return report.valid() ? kExitSolved : kExitNoPath;
}

}  // namespace

void add_validate_command(CLI::App& app, Action& action) {
  CLI::App& command = *app.add_subcommand("validate",
                                          "Check a path, whoever made it: collision, joints, curvature, "
                                          "speeds, accelerations, durations");
  const auto arguments = std::make_shared<ValidateArguments>();
  command.add_option("WORLD", arguments->map, kMapHelp)->required();
  arguments->reading.add_to(command);
  command.add_option("--path", arguments->path, "Plan as written by plan --json")->type_name("P.json")->required();
  command.add_option("--robot", arguments->robot, kRobotHelp)->type_name("R.json");
  command.callback(
      [arguments, &action] { action = [arguments](std::string& out) { return run_validate(*arguments, out); }; });
}

}  // namespace arcway::cli

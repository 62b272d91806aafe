#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "arcway/clearance_preference.h"
#include "arcway/datasets/plan_io.h"
#include "arcway/moving_obstacle.h"
#include "arcway/planner.h"
#include "arcway/process_group.h"
#include "bench/cli/arguments.h"
#include "core/motion/end_speeds.h"

namespace arcway::internal::cli {

/// Arguments of `arcway plan` as typed.
struct PlanArguments {
  std::string map;
  MapOptions reading;
  std::vector<std::string> added;
  std::string robot;
  std::string start;
  std::vector<std::string> goals, waypoints;
  std::uint32_t alternatives = 1;
  std::string queries, out;
  std::string heuristic = "travel_time";
  std::string suboptimality;
  std::string graph;
  std::string time_limit;
  bool reverse = false;
  std::string cusp_cost, max_gear_changes;
  std::string start_speed, goal_speed;
  std::string moving, horizon;
  std::vector<MovingObstacle> obstacles;  ///< of the file `moving`
  std::string refine_trials = std::to_string(RefineOptions{}.max_trials);
  std::vector<std::string> leave_out;
  std::string prefer_clearance, clearance_cost;
  std::string svg, json, csv, ros_path;
  std::string sample_step;
  std::vector<std::string> svg_layers{"bounds", "obstacles", "zones", "swept", "path", "robot", "axes", "markers"};
  std::string svg_view = "map", svg_color = "gear";
  bool svg_inset = false;
  BuildOptions build;

  void add_to(CLI::App& command);
  /// Adds the options for gears and speeds.
  void add_driving_to(CLI::App& command);
  /// Adds the options for files to write.
  void add_outputs_to(CLI::App& command);
  /// @throws UsageError for options that exclude each other, or invalid values.
  void check() const;

  [[nodiscard]] bool batch() const { return !queries.empty(); }
  [[nodiscard]] std::vector<std::string> inputs() const;
  [[nodiscard]] std::vector<std::string> outputs() const { return {out, svg, json, csv, ros_path}; }
  /// @throws UsageError, as the next ones.
  [[nodiscard]] PlannerOptions planner_options(const ProcessGroup& process_group) const;
  [[nodiscard]] std::optional<ClearancePreference> clearance_preference() const;
  [[nodiscard]] PlanLimits limits() const;
  [[nodiscard]] double cusp_cost_seconds() const;  ///< 0 if not given
  [[nodiscard]] std::optional<std::uint32_t> most_gear_changes() const;
  [[nodiscard]] EndSpeeds end_speeds() const;
  /// The time up to which a plan evades moving obstacles: --horizon, by default
  /// EvasionOptions::horizon, or twice the plan's travel time if that is more.
  [[nodiscard]] EvasionOptions evasion(double travel_time) const;
  [[nodiscard]] PathSampling sampling() const;
};

}  // namespace arcway::internal::cli

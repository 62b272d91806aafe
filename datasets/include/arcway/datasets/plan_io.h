#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "arcway/datasets/file_io.h"
#include "arcway/export.h"
#include "arcway/planner.h"
#include "arcway/trajectory.h"
#include "arcway/vehicle.h"

namespace arcway {

/// One JSON object on one line, without a newline at its end. Numbers read back to the same doubles; what is not
/// finite is null.
///
///     {"format":"arcway-plan","version":1,"q":0,"status":"solved","robot":{..},"start":[x,y,heading],
///      "goal":[x,y,heading],"travel_time":..,"length":..,"gear_changes":..,"lower_bound":..,"min_clearance":..,
///      "path":[{"type":"line"|"arc","start":[x,y,heading],"length":..,"curvature":..,"direction":1|-1,
///               "speed_in":..,"speed_out":..,"duration":..}],"statistics":{..}}
///
/// "direction" is -1 where the segment is driven backwards. With "start_speed" and "goal_speed" if they are not 0,
/// negative backwards. With "reason" and an empty path unless solved; with
/// "interrupted": true if the time limit or a stop ended the search.
/// @param q      number of the query.
/// @param robot  that the plan is for, as robot.h writes it; left out if there is none.
ARCWAY_API std::string plan_to_json(const PlanResult& result, std::uint64_t q,
                                    const std::optional<VehicleParameters>& robot = {});

/// The states of a trajectory as `s,x,y,yaw,curvature,direction,t,v,steer` with a header line: meters, radians,
/// seconds. The steering angle is that of Vehicle::steering_angle. Headings are in (-pi, pi].
/// @throws std::invalid_argument as Trajectory::sample does.
ARCWAY_API std::string path_to_csv(const Trajectory& trajectory, const PathSampling& sampling = {});

/// The states as a nav_msgs/Path of ROS 2 in JSON, named as rosbridge does; stamps are times since the start. The
/// message has no gear: orientations are those of the body, so that backwards the positions move against them.
/// @param frame  of the coordinates, as "map".
/// @throws std::invalid_argument as Trajectory::sample does.
ARCWAY_API std::string path_to_nav_msgs(const Trajectory& trajectory, std::string_view frame = "map",
                                        const PathSampling& sampling = {});

/// A plan as plan_to_json writes it.
struct ARCWAY_API PlanFile {
  std::optional<std::uint64_t> q;  ///< number of the query
  std::string status;
  std::optional<VehicleParameters> robot;     ///< robot that the plan names
  std::optional<double> travel_time, length;  ///< as stated by the plan [s], [m]
  std::optional<double> gear_changes;         ///< as stated by the plan
  Pose start, goal;
  double start_speed = 0.0;  ///< with which the plan begins, negative backwards [m/s]
  double goal_speed = 0.0;   ///< with which it ends [m/s]
  TimedPath path;            ///< speeds and durations empty if the file has none
  /// The path in time for the robot that the plan names; if it names none, for that of VehicleParameters' defaults.
  /// @throws std::invalid_argument as Vehicle and Trajectory do, among others if the path has no segments.
  [[nodiscard]] Trajectory trajectory() const;
};
/// Reads what plan_to_json writes; only "format", "version", "start", "goal" and "path" are required, and of its
/// segments "type", "start", "length" and "curvature". Speeds and durations must be on all segments or on none.
/// @param name  of the source, for messages.
/// @throws FormatError, "plan.json: path[3].length: expected a number, found null".
ARCWAY_API PlanFile parse_plan(std::string_view json, std::string_view name);

struct PlanOnLine {
  std::size_t line;  ///< line where the plan begins, from 1
  PlanFile plan;
};
/// Reads a path that path_to_csv wrote, with or without units in the header: a segment between two samples, with its
/// speeds and duration. Of other writers' paths the columns up to v_m_per_s must be there, in any order.
/// @throws FormatError, "path.csv:7: v_m_per_s: expected a number, found "x"".
ARCWAY_API PlanFile parse_path_csv(std::string_view text, std::string_view name);
/// Reads a path that path_to_nav_msgs wrote: a line or arc between two poses, by their headings, without speeds. It is
/// driven backwards where the positions move against the headings.
/// @throws FormatError, "path.json: poses[3].pose.position.x: expected a number, found null".
ARCWAY_API PlanFile parse_nav_msgs(std::string_view text, std::string_view name);

/// Reads one plan, or several, each beginning on a line of its own; or the one path of parse_path_csv or
/// parse_nav_msgs. The content tells which it is.
/// @throws FormatError as parse_plan; of several "plans.json:2: path[3].length: ...".
ARCWAY_API std::vector<PlanOnLine> parse_plans(std::string_view json, std::string_view name);

/// Reads the file of one plan: see parse_plan.
///
///     const PlanFile file = read_plan("plan.json");
///     const Pose pose = file.trajectory().at(1.5).pose;
///
/// @throws FileError if the file cannot be read, FormatError as parse_plan does.
ARCWAY_API PlanFile read_plan(const std::filesystem::path& path);
/// Writes a plan with the robot that it is for, by plan_to_json: read_plan reads it back to the same doubles. Readers
/// see the old file or the new one, never half of it.
/// @throws FileError if the file cannot be written; the old one then stays.
ARCWAY_API void write_plan(const std::filesystem::path& path, const PlanResult& result);

}  // namespace arcway

#include "arcway/datasets/plan_io.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/robot.h"
#include "arcway/zone.h"
#include "arcway/zone_stay.h"
#include "core/base/shortest_text.h"
#include "datasets/io/json_text.h"

namespace arcway {

using namespace internal;
namespace {

using detail::append_number;
using detail::append_pose;
using detail::JsonPlace;

void append_key(std::string& out, std::string_view key) {
  out += ",\"";
  out += key;
  out += "\":";
}
void append_member(std::string& out, std::string_view key, double value) {
  append_key(out, key);
  append_number(out, value);
}
void append_member(std::string& out, std::string_view key, std::uint64_t value) {
  append_key(out, key);
  out += std::to_string(value);
}

void append_segment(std::string& out, const TimedSegment& timed) {
  out += timed.segment.is_line() ? R"({"type":"line","start":)" : R"({"type":"arc","start":)";
  append_pose(out, timed.segment.start);
  append_member(out, "length", timed.segment.length);
  append_member(out, "curvature", timed.segment.curvature);
  out += timed.segment.gear == Gear::kForward ? R"(,"direction":1)" : R"(,"direction":-1)";
  append_member(out, "speed_in", timed.speed_in);
  append_member(out, "speed_out", timed.speed_out);
  append_member(out, "duration", timed.duration);
  out += '}';
}

void append_bottleneck(std::string& out, const Bottleneck& bottleneck) {
  append_key(out, "bottleneck");
  out += R"({"width":)";
  append_number(out, bottleneck.width);
  append_member(out, "needed", bottleneck.needed);
  append_member(out, "needed_to_turn", bottleneck.needed_to_turn);
  out += R"(,"between":[)";
  const auto side = [&](ObstacleId obstacle, const Vec2& point) {
    out += R"({"obstacle":)" + std::to_string(obstacle) + R"(,"point":[)";
    append_number(out, point.x());
    out += ',';
    append_number(out, point.y());
    out += "]}";
  };
  side(bottleneck.obstacle_a, bottleneck.on_a);
  out += ',';
  side(bottleneck.obstacle_b, bottleneck.on_b);
  out += "]}";
}

void append_close_driving(std::string& out, const CloseDriving& close) {
  append_key(out, "close_driving");
  out += R"({"distance":)";
  append_number(out, close.distance);
  append_member(out, "length", close.length);
  append_member(out, "cost", close.cost);
  out += '}';
}

// Where the plan enters zones.
void append_zones(std::string& out, const PlanResult& result) {
  const std::vector<ZoneStay> stays = zone_stays(result);
  if (stays.empty()) return;
  append_key(out, "zones");
  out += '[';
  for (const ZoneStay& stay : stays) {
    const Zone& zone = result.scene->world.zones()[stay.zone];
    out += out.back() == '[' ? "{" : ",{";
    out += "\"zone\":" + std::to_string(stay.zone);
    append_key(out, "role");
    detail::append_string(out, role_of(zone));
    append_key(out, "name");
    detail::append_string(out, zone.name);
    append_member(out, "length", stay.length);
    append_member(out, "time", stay.time);
    for (const ZoneCloseDriving& in_zone : result.close_in_zones)
      if (in_zone.zone == stay.zone) append_close_driving(out, in_zone.close);
    out += '}';
  }
  out += ']';
}

}  // namespace

std::string plan_to_json(const PlanResult& result, std::uint64_t q, const std::optional<VehicleParameters>& robot) {
  std::string out = R"({"format":"arcway-plan","version":1)";
  append_member(out, "q", q);
  append_key(out, "status");
  detail::append_string(out, name_of(result.status));
  if (!result.solved()) {
    append_key(out, "reason");
    detail::append_string(out, result.reason);
    append_key(out, "certainty");
    detail::append_string(out, name_of(result.certainty));
  }
  if (result.bottleneck) append_bottleneck(out, *result.bottleneck);
  if (result.interrupted) out += R"(,"interrupted":true)";
  if (robot) out += R"(,"robot":)" + to_json(*robot);
  append_key(out, "start");
  append_pose(out, result.start);
  append_key(out, "goal");
  append_pose(out, result.goal);
  if (result.start_speed != 0.0) append_member(out, "start_speed", result.start_speed);
  if (result.goal_speed != 0.0) append_member(out, "goal_speed", result.goal_speed);
  if (result.solved()) {
    append_member(out, "travel_time", result.travel_time);
    append_member(out, "length", result.length);
    append_member(out, "gear_changes", static_cast<std::uint64_t>(cusps_of(result.path())));
  }
  append_member(out, "lower_bound", result.lower_bound);
  if (result.solved()) append_member(out, "min_clearance", result.min_clearance);
  if (result.close_driving || !result.close_in_zones.empty()) append_member(out, "cost", result.cost());
  if (result.close_driving) append_close_driving(out, *result.close_driving);
  append_zones(out, result);
  append_key(out, "path");
  out += '[';
  for (const TimedSegment& segment : result.segments) {
    if (out.back() != '[') out += ',';
    append_segment(out, segment);
  }
  out += R"(],"statistics":{"nodes_expanded":)" + std::to_string(result.statistics.nodes_expanded);
  append_member(out, "nodes_pushed", result.statistics.nodes_pushed);
  append_member(out, "straights_checked", result.statistics.straights_checked);
  append_member(out, "turns_checked", result.statistics.turns_checked);
  append_member(out, "maneuver_poses", result.statistics.maneuver_poses);
  append_member(out, "tree_poses", result.statistics.tree_poses);
  append_member(out, "unrefined_travel_time", result.statistics.unrefined_travel_time);
  append_member(out, "first_travel_time", result.statistics.first_travel_time);
  append_member(out, "first_path_seconds", result.statistics.first_path_seconds);
  append_member(out, "refine_trials", result.statistics.refine_trials);
  append_member(out, "refine_improvements", result.statistics.refine_improvements);
  append_member(out, "suboptimality", result.statistics.suboptimality);
  append_member(out, "refine_seconds", result.statistics.refine_seconds);
  append_member(out, "lower_bound_seconds", result.statistics.lower_bound_seconds);
  append_member(out, "search_seconds", result.statistics.search_seconds);
  append_member(out, "profile_seconds", result.statistics.profile_seconds);
  append_member(out, "total_seconds", result.statistics.total_seconds);
  out += "}}";
  return out;
}

std::string path_to_csv(const Trajectory& trajectory, const PathSampling& sampling) {
  std::string out = "s_m,x_m,y_m,yaw_rad,curvature_per_m,direction,t_s,v_m_per_s,steer_rad\n";
  for (const TrajectoryState& state : trajectory.sample(sampling)) {
    for (const double value : {state.distance, state.pose.x, state.pose.y, wrap_signed(state.pose.heading),
                               state.curvature, sign_of(state.gear), state.time, state.speed, state.steering_angle}) {
      append_number(out, value == 0.0 ? 0.0 : value);
      out += ',';
    }
    out.back() = '\n';
  }
  return out;
}

std::string path_to_nav_msgs(const Trajectory& trajectory, std::string_view frame, const PathSampling& sampling) {
  const auto append_header = [&](std::string& out, double t) {
    const double seconds = std::floor(t);
    out += R"({"stamp":{"sec":)";
    // Whole numbers without an exponent, which readers would take for others.
    out += std::to_string(static_cast<std::uint64_t>(seconds));
    out += R"(,"nanosec":)";
    out += std::to_string(static_cast<std::uint64_t>(std::min(std::floor((t - seconds) * 1e9), 999999999.0)));
    out += R"(},"frame_id":)";
    detail::append_string(out, frame);
    out += '}';
  };
  std::string out = R"({"header":)";
  append_header(out, 0.0);
  out += R"(,"poses":[)";
  const TrajectoryState* last = nullptr;
  const std::vector<TrajectoryState> samples = trajectory.sample(sampling);
  for (const TrajectoryState& sample : samples) {
    // A joint is sampled once for each of its curvatures, which a pose does not show.
    if (last != nullptr && last->distance == sample.distance) continue;
    out += last == nullptr ? R"({"header":)" : R"(,{"header":)";
    last = &sample;
    append_header(out, sample.time);
    out += R"(,"pose":{"position":{"x":)";
    append_number(out, sample.pose.x);
    append_member(out, "y", sample.pose.y);
    append_member(out, "z", 0.0);
    const double half = 0.5 * wrap_signed(sample.pose.heading);
    out += R"(},"orientation":{"x":0,"y":0)";
    append_member(out, "z", std::sin(half));
    append_member(out, "w", std::cos(half));
    out += "}}}";
  }
  out += "]}";
  return out;
}

namespace {

PlanFile plan_of(const JsonPlace& plan) {
  plan.allow_keys({"format",      "version",       "q",       "status", "reason",       "certainty",  "bottleneck",
                   "interrupted", "robot",         "start",   "goal",   "travel_time",  "length",     "gear_changes",
                   "lower_bound", "min_clearance", "zones",   "path",   "statistics",   "goal_index", "passed",
                   "start_speed", "goal_speed",    "evasion", "cost",   "close_driving"});
  plan.require_format("arcway-plan", 1);
  PlanFile file;
  if (plan.has("q")) {
    const JsonPlace q = plan.at("q");
    if (!q.value.is_number_unsigned()) q.expected("a whole number >= 0");
    file.q = q.value.get<std::uint64_t>();
  }
  file.status = plan.has("status") ? plan.at("status").string() : "";
  if (plan.has("robot")) {
    const JsonPlace robot = plan.at("robot");
    file.robot = read_robot(robot.value.dump(), robot.path);
  }
  if (plan.has("travel_time")) file.travel_time = plan.at("travel_time").number();
  if (plan.has("length")) file.length = plan.at("length").number();
  if (plan.has("gear_changes")) file.gear_changes = plan.at("gear_changes").number();
  file.start = plan.at("start").pose();
  file.goal = plan.at("goal").pose();
  if (plan.has("start_speed")) file.start_speed = plan.at("start_speed").number();
  if (plan.has("goal_speed")) file.goal_speed = plan.at("goal_speed").number();
  const JsonPlace path = plan.at("path");
  path.require_array();
  for (std::size_t i = 0; i < path.value.size(); ++i) {
    const JsonPlace place = path.at(i);
    place.allow_keys({"type", "start", "length", "curvature", "direction", "speed_in", "speed_out", "duration"});
    PathSegment segment{place.at("start").pose(), place.at("length").number(), place.at("curvature").number()};
    const std::string type = place.at("type").string();
    if (type != "line" && type != "arc") place.at("type").expected("\"line\" or \"arc\"");
    if ((type == "line") != segment.is_line()) place.at("curvature").expected(type == "line" ? "0 on a line" : "not 0");
    if (place.has("direction")) {
      const double direction = place.at("direction").number();
      if (std::abs(direction) != 1.0) place.at("direction").expected("1 (forwards) or -1 (backwards)");
      segment.gear = direction > 0.0 ? Gear::kForward : Gear::kReverse;
    }
    const bool timed = place.has("speed_in") || place.has("speed_out") || place.has("duration");
    if (timed) {
      if (file.path.speed_in.size() != i) place.fail("speeds must be on all segments or on none");
      file.path.speed_in.push_back(place.at("speed_in").number());
      file.path.speed_out.push_back(place.at("speed_out").number());
      file.path.durations.push_back(place.at("duration").number());
    } else if (!file.path.speed_in.empty()) {
      place.fail("speeds must be on all segments or on none");
    }
    file.path.segments.push_back(segment);
  }
  return file;
}

// Length of the first of several values. Within one, no line that begins with { follows one that ends with }.
std::size_t length_of_first(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  std::size_t next = 0;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n', next)) {
    const std::size_t last = text.find_last_not_of(kBlanks, end);
    next = text.find_first_not_of(kBlanks, end);
    if (next == std::string_view::npos) break;
    if (last != std::string_view::npos && text[last] == '}' && text[next] == '{') return text.rfind('\n', next) + 1;
  }
  return text.size();
}

}  // namespace

PlanFile parse_plan(std::string_view text, std::string_view name) {
  const nlohmann::json value = detail::parse_json(text, name);
  return plan_of({value, std::string(name)});
}

std::vector<PlanOnLine> parse_plans(std::string_view text, std::string_view name) {
  const std::size_t begin = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  if (begin != std::string_view::npos && text[begin] != '{' && text.find("yaw") != std::string_view::npos)
    return {{1, parse_path_csv(text.substr(begin), name)}};
  const bool several = length_of_first(text) < text.size();
  std::vector<PlanOnLine> plans;
  std::size_t line = 1;
  do {
    const std::string_view one = text.substr(0, length_of_first(text));
    const nlohmann::json value = detail::parse_json(one, name, nullptr, line);
    if (!several && value.is_object() && value.contains("poses") && !value.contains("format"))
      return {{1, parse_nav_msgs(text, name)}};
    plans.push_back({line, plan_of({value, std::string(name) + (several ? ":" + std::to_string(line) : "")})});
    line += static_cast<std::size_t>(std::count(one.begin(), one.end(), '\n'));
    text.remove_prefix(one.size());
  } while (!text.empty());
  return plans;
}

Trajectory PlanFile::trajectory() const { return Trajectory(path, Vehicle(robot.value_or(VehicleParameters{}))); }

PlanFile read_plan(const std::filesystem::path& path) { return parse_plan(read_file(path), path.string()); }

void write_plan(const std::filesystem::path& path, const PlanResult& result) {
  std::optional<VehicleParameters> robot;
  if (result.scene) robot = result.scene->vehicle.parameters();
  write_file_atomically(path, plan_to_json(result, 0, robot) + "\n");
}

}  // namespace arcway

#include "arcway/datasets/robot.h"

#include <cmath>
#include <set>

#include "datasets/formats/robot_yaml.h"
#include "datasets/io/json_text.h"

namespace arcway {

using namespace internal;
namespace {

using detail::JsonPlace;

constexpr std::pair<std::string_view, Steering> kSteerings[] = {
    {"front", Steering::kFront}, {"rear", Steering::kRear}, {"symmetric", Steering::kSymmetric}};

// What others call the keys of a robot. A lateral acceleration is one way to give the speed in turns.
constexpr Synonym kSynonyms[] = {
    {"breadth", "width"},
    {"polygon", "footprint"},
    {"outline", "footprint"},
    {"baselink", "footprint_origin"},
    {"axledistance", "wheelbase"},
    {"axlespacing", "wheelbase"},
    {"steeringangle", "max_steering_angle"},
    {"maxsteering", "max_steering_angle"},
    {"maxsteer", "max_steering_angle"},
    {"maxsteerangle", "max_steering_angle"},
    {"steeringlimit", "max_steering_angle"},
    {"turningradius", "min_turning_radius"},
    {"turnradius", "min_turning_radius"},
    {"mincurveradius", "min_turning_radius"},
    {"velocity", "max_speed"},
    {"maxvelocity", "max_speed"},
    {"maxlinearvelocity", "max_speed"},
    {"maxvel", "max_speed"},
    {"vmax", "max_speed"},
    {"topspeed", "max_speed"},
    {"speedlimit", "max_speed"},
    {"turnvelocity", "turn_speed"},
    {"corneringspeed", "turn_speed"},
    {"lateralacceleration", "turn_speed"},
    {"maxlateralacceleration", "turn_speed"},
    {"reversevelocity", "max_reverse_speed"},
    {"maxreversevelocity", "max_reverse_speed"},
    {"backwardspeed", "max_reverse_speed"},
    {"maxbackwardspeed", "max_reverse_speed"},
    {"accel", "max_acceleration"},
    {"maxaccel", "max_acceleration"},
    {"amax", "max_acceleration"},
    {"deceleration", "max_acceleration"},
    {"maxdeceleration", "max_acceleration"},
    {"clearance", "safety_margin"},
    {"minclearance", "safety_margin"},
    {"safetydistance", "safety_margin"},
    {"padding", "safety_margin"},
    {"inflation", "safety_margin"},
    {"inflationradius", "safety_margin"},
};

nlohmann::json parse(std::string_view text, std::string_view name) {
  return detail::parse_json(text, name, nullptr, 1, detail::RepeatedKeys::kRefused);
}

TurnSpeedLaw turn_speed_of(const JsonPlace& place) {
  if (place.value.is_number()) return ConstantTurnSpeed{place.number()};
  if (!place.value.is_object())
    place.expected("a speed, {\"lateral_acceleration\": ...} or {\"table\": [[radius, speed], ...]}");
  place.allow_keys({"lateral_acceleration", "table"});
  if (place.value.size() != 1) place.fail("expected one of \"lateral_acceleration\" and \"table\"");
  if (place.has("lateral_acceleration")) return LateralAccelerationLimit{place.at("lateral_acceleration").number()};
  const JsonPlace table = place.at("table");
  table.require_array();
  TurnSpeedTable result;
  for (std::size_t i = 0; i < table.value.size(); ++i) {
    const JsonPlace entry = table.at(i);
    if (!entry.value.is_array() || entry.value.size() != 2) entry.expected("[radius, speed]");
    result.entries.emplace_back(entry.at(0).number(), entry.at(1).number());
  }
  return result;
}

Vec2 point_of(const JsonPlace& place) {
  if (!place.value.is_array() || place.value.size() != 2) place.expected("a point [x, y]");
  return {place.at(0).number(), place.at(1).number()};
}

Ring ring_of(const JsonPlace& place) {
  place.require_array();
  Ring ring;
  for (std::size_t i = 0; i < place.value.size(); ++i) ring.push_back(point_of(place.at(i)));
  return ring;
}

// One polygon [[x, y], ...], or several, or a text of one of these as in the parameters of nav2.
std::vector<Ring> footprint_of(const JsonPlace& place) {
  if (place.value.is_string()) {
    const nlohmann::json value = parse(place.string(), place.path);
    return footprint_of({value, place.path});
  }
  place.require_array();
  const auto is_point = [](const nlohmann::json& v) { return v.is_array() && !v.empty() && !v[0].is_array(); };
  if (place.value.empty() || is_point(place.value[0])) return {ring_of(place)};
  std::vector<Ring> parts;
  for (std::size_t i = 0; i < place.value.size(); ++i) parts.push_back(ring_of(place.at(i)));
  return parts;
}

// The keys of the body. What another one takes the place of is refused beside it.
void read_body(const JsonPlace& place, VehicleParameters& robot) {
  const auto refuse = [&](std::string_view key, std::initializer_list<std::string_view> others) {
    for (const std::string_view other : others)
      if (place.has(key) && place.has(other))
        place.fail("\"" + std::string(key) + "\" takes the place of \"" + std::string(other) + "\", leave one out");
  };
  refuse("front_overhang", {"length"});
  refuse("rear_overhang", {"length"});
  refuse("footprint", {"length", "width", "front_overhang", "rear_overhang"});
  if (place.has("length")) robot.length = place.at("length").number();
  if (place.has("width")) robot.width = place.at("width").number();
  if (place.has("front_overhang")) robot.front_overhang = place.at("front_overhang").number();
  if (place.has("rear_overhang")) robot.rear_overhang = place.at("rear_overhang").number();
  if (place.has("footprint")) robot.footprint = footprint_of(place.at("footprint"));
  if (!place.has("footprint_origin")) return;
  if (!place.has("footprint")) place.fail("\"footprint_origin\" needs a \"footprint\" beside it");
  robot.footprint_origin = point_of(place.at("footprint_origin"));
}

// Limits of turns: angles of the wheels, or radii by the name of arcway or of nav2; to the right where they differ.
void read_turns(const JsonPlace& place, VehicleParameters& robot) {
  const std::string_view keys[] = {"min_turning_radius", "minimum_turning_radius"};
  if (place.has(keys[0]) && place.has(keys[1]))
    place.fail("\"min_turning_radius\" and \"minimum_turning_radius\" are the same, leave one out");
  const auto radius_of = [&](std::string_view key) {
    const JsonPlace radius = place.at(key);
    if (!(radius.number() > 0.0)) radius.expected("a radius > 0");
    return radius.number();
  };
  for (const std::string_view key : keys)
    if (place.has(key)) robot.min_turning_radius = radius_of(key);
  if (place.has("max_steering_angle")) robot.max_steering_angle = place.at("max_steering_angle").number();
  if (place.has("max_steering_angle_right"))
    robot.max_steering_angle_right = place.at("max_steering_angle_right").number();
  if (place.has("min_turning_radius_right")) robot.min_turning_radius_right = radius_of("min_turning_radius_right");
}

VehicleParameters robot_of(const JsonPlace& place) {
  place.allow_keys({"format",
                    "version",
                    "name",
                    "length",
                    "width",
                    "front_overhang",
                    "rear_overhang",
                    "footprint",
                    "footprint_origin",
                    "wheelbase",
                    "steering",
                    "max_steering_angle",
                    "max_steering_angle_right",
                    "min_turning_radius",
                    "min_turning_radius_right",
                    "minimum_turning_radius",
                    "max_speed",
                    "turn_speed",
                    "max_reverse_speed",
                    "max_acceleration",
                    "safety_margin"},
                   kSynonyms);
  place.allow_format("arcway-robot", 1);
  VehicleParameters robot;
  if (place.has("name")) robot.name = place.at("name").string();
  read_body(place, robot);
  const auto number = [&](std::string_view key, double& value) {
    if (place.has(key)) value = place.at(key).number();
  };
  number("wheelbase", robot.wheelbase);
  number("max_speed", robot.max_speed);
  number("max_acceleration", robot.max_acceleration);
  number("safety_margin", robot.safety_margin);
  if (place.has("steering")) {
    const JsonPlace steering = place.at("steering");
    bool known = false;
    for (const auto& [word, value] : kSteerings) {
      if (steering.value != word) continue;
      robot.steering = value;
      known = true;
    }
    if (!known) steering.expected("\"front\", \"rear\" or \"symmetric\"");
  }
  read_turns(place, robot);
  if (place.has("turn_speed")) robot.turn_speed = turn_speed_of(place.at("turn_speed"));
  if (place.has("max_reverse_speed")) robot.max_reverse_speed = place.at("max_reverse_speed").number();
  return robot;
}

std::string point_text(const Vec2& p) {
  std::string out = "[";
  detail::append_number(out, p.x());
  out += ',';
  detail::append_number(out, p.y());
  return out + ']';
}

// One polygon as it is, several as an array.
std::string footprint_text(const std::vector<Ring>& parts) {
  std::string out;
  for (const Ring& ring : parts) {
    out += out.empty() ? "[" : ",[";
    for (std::size_t i = 0; i < ring.size(); ++i) out += (i > 0 ? "," : "") + point_text(ring[i]);
    out += ']';
  }
  return parts.size() == 1 ? out : "[" + out + "]";
}

std::string turn_speed_text(const TurnSpeedLaw& law) {
  std::string out;
  if (const auto* constant = std::get_if<ConstantTurnSpeed>(&law)) {
    detail::append_number(out, constant->speed);
  } else if (const auto* limit = std::get_if<LateralAccelerationLimit>(&law)) {
    out += R"({"lateral_acceleration":)";
    detail::append_number(out, limit->lateral_acceleration);
    out += '}';
  } else {
    out += R"({"table":[)";
    for (const auto& [radius, speed] : std::get<TurnSpeedTable>(law).entries) {
      out += out.back() == '[' ? "[" : ",[";
      detail::append_number(out, radius);
      out += ',';
      detail::append_number(out, speed);
      out += ']';
    }
    out += "]}";
  }
  return out;
}

}  // namespace

VehicleParameters read_robot(std::string_view text, std::string_view name) {
  const bool is_yaml = name.ends_with(".yaml") || name.ends_with(".yml");
  const nlohmann::json value = is_yaml ? robot_of_yaml(text, name) : parse(text, name);
  return robot_of({value, std::string(name)});
}

VehicleParameters read_robot_file(const std::filesystem::path& path) {
  return read_robot(read_file(path), path.string());
}

std::string to_json(const VehicleParameters& robot) {
  std::string out = R"({"format":"arcway-robot","version":1)";
  const auto number = [&](std::string_view key, double value) {
    out += ",\"";
    out += key;
    out += "\":";
    detail::append_number(out, value);
  };
  if (!robot.name.empty()) {
    out += ",\"name\":";
    detail::append_string(out, robot.name);
  }
  if (!robot.footprint.empty()) {
    out += ",\"footprint\":" + footprint_text(robot.footprint);
    if (robot.footprint_origin != Vec2(0.0, 0.0)) out += ",\"footprint_origin\":" + point_text(robot.footprint_origin);
  } else if (robot.front_overhang && robot.rear_overhang) {
    number("front_overhang", *robot.front_overhang);
    number("rear_overhang", *robot.rear_overhang);
    number("width", robot.width);
  } else {
    number("length", robot.length);
    number("width", robot.width);
  }
  number("wheelbase", robot.wheelbase);
  for (const auto& [word, value] : kSteerings)
    if (value == robot.steering) out += ",\"steering\":\"" + std::string(word) + '"';
  const VehicleParameters none;
  if (!robot.min_turning_radius || robot.max_steering_angle != none.max_steering_angle)
    number("max_steering_angle", robot.max_steering_angle);
  if (robot.max_steering_angle_right) number("max_steering_angle_right", *robot.max_steering_angle_right);
  if (robot.min_turning_radius) number("min_turning_radius", *robot.min_turning_radius);
  if (robot.min_turning_radius_right) number("min_turning_radius_right", *robot.min_turning_radius_right);
  number("max_speed", robot.max_speed);
  out += ",\"turn_speed\":" + turn_speed_text(robot.turn_speed);
  if (robot.max_reverse_speed) number("max_reverse_speed", *robot.max_reverse_speed);
  number("max_acceleration", robot.max_acceleration);
  number("safety_margin", robot.safety_margin);
  out += '}';
  return out;
}

Scenario read_scenario(std::string_view text, std::string_view name) {
  const nlohmann::json value = parse(text, name);
  const JsonPlace place{value, std::string(name)};
  place.allow_keys({"format", "version", "world", "robot", "tasks"});
  place.require_format("arcway-scenario", 1);
  Scenario scenario;
  scenario.world = place.at("world").string();
  if (place.has("robot")) {
    const JsonPlace robot = place.at("robot");
    if (robot.value.is_string()) {
      scenario.robot = robot.string();
    } else if (robot.value.is_object()) {
      scenario.robot = robot_of(robot);
    } else {
      robot.expected("a robot or the name of its file");
    }
  }
  const JsonPlace tasks = place.at("tasks");
  tasks.require_array();
  std::set<std::string> ids;
  for (std::size_t i = 0; i < tasks.value.size(); ++i) {
    const JsonPlace task = tasks.at(i);
    task.allow_keys({"id", "start", "goal"});
    const std::string id = task.has("id") ? task.at("id").string() : "t" + std::to_string(i);
    if (!ids.insert(id).second) task.fail("second task with the id " + detail::shown(id));
    scenario.tasks.push_back({id, task.at("start").pose(), task.at("goal").pose()});
  }
  return scenario;
}

Scenario read_scenario_file(const std::filesystem::path& path) {
  Scenario scenario = read_scenario(read_file(path), path.string());
  const std::filesystem::path folder = path.parent_path();
  scenario.world = (folder / scenario.world).string();
  if (const auto* robot = std::get_if<std::string>(&scenario.robot)) scenario.robot = read_robot_file(folder / *robot);
  return scenario;
}

std::string to_json(const Scenario& scenario) {
  std::string out = R"({"format":"arcway-scenario","version":1,"world":)";
  detail::append_string(out, scenario.world);
  out += ",\"robot\":";
  if (const auto* file = std::get_if<std::string>(&scenario.robot)) {
    detail::append_string(out, *file);
  } else {
    out += to_json(std::get<VehicleParameters>(scenario.robot));
  }
  out += ",\"tasks\":[";
  for (const Task& task : scenario.tasks) {
    out += out.back() == '[' ? "\n{\"id\":" : ",\n{\"id\":";
    detail::append_string(out, task.id);
    out += ",\"start\":";
    detail::append_pose(out, task.start);
    out += ",\"goal\":";
    detail::append_pose(out, task.goal);
    out += '}';
  }
  out += "\n]}\n";
  return out;
}

}  // namespace arcway

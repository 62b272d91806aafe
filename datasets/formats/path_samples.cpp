#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "arcway/datasets/plan_io.h"
#include "datasets/formats/text_scanner.h"
#include "datasets/io/json_text.h"
#include "datasets/io/number_text.h"
#include "datasets/io/shortened.h"

namespace arcway {

using namespace internal;
namespace {

using detail::JsonPlace;

/// Difference of two headings that rounding alone makes [rad]: of sines and cosines of halves.
constexpr double kHeadingRounding = 1e-14;

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t end = std::min(line.find(','), line.size());
    std::string_view field = line.substr(0, end);
    while (!field.empty() && (field.front() == ' ' || field.front() == '\t')) field.remove_prefix(1);
    while (!field.empty() && (field.back() == ' ' || field.back() == '\t' || field.back() == '\r'))
      field.remove_suffix(1);
    fields.push_back(field);
    if (end == line.size()) return fields;
    line.remove_prefix(end + 1);
  }
}

// Columns that a path needs, as they are named with and without units.
enum Column : std::size_t { kS, kX, kY, kYaw, kCurvature, kDirection, kT, kV, kColumns };
constexpr std::array<std::array<std::string_view, 2>, kColumns> kNames{{{"s_m", "s"},
                                                                        {"x_m", "x"},
                                                                        {"y_m", "y"},
                                                                        {"yaw_rad", "yaw"},
                                                                        {"curvature_per_m", "curvature"},
                                                                        {"direction", "direction"},
                                                                        {"t_s", "t"},
                                                                        {"v_m_per_s", "v"}}};
using Sample = std::array<double, kColumns>;

// Where each column stands.
std::array<std::size_t, kColumns> columns_of(const std::vector<std::string_view>& header, const std::string& place) {
  std::array<std::size_t, kColumns> columns{};
  for (std::size_t c = 0; c < kColumns; ++c) {
    const auto found = std::ranges::find_if(
        header, [&](std::string_view name) { return std::ranges::find(kNames[c], name) != kNames[c].end(); });
    if (found == header.end())
      throw FormatError(place + ": no column " + std::string(kNames[c][0]) + "; expected those of plan --csv");
    columns[c] = static_cast<std::size_t>(found - header.begin());
  }
  return columns;
}

Sample sample_of(const std::vector<std::string_view>& fields, const std::array<std::size_t, kColumns>& columns,
                 const std::string& place) {
  Sample sample{};
  for (std::size_t c = 0; c < kColumns; ++c) {
    if (columns[c] >= fields.size())
      throw FormatError(place + ": expected " + std::string(kNames[c][0]) + ", found " + std::to_string(fields.size()) +
                        " fields");
    const auto value = read_number(fields[columns[c]]);
    if (!value)
      throw FormatError(place + ": " + std::string(kNames[c][0]) + ": expected a number, found " +
                        detail::quoted(fields[columns[c]]));
    sample[c] = *value;
  }
  if (std::abs(sample[kDirection]) != 1.0)
    throw FormatError(place + ": direction: expected 1 (forwards) or -1 (backwards), found " +
                      detail::quoted(fields[columns[kDirection]]));
  return sample;
}

std::vector<Sample> samples_of(std::string_view text, std::string_view name) {
  std::vector<Sample> samples;
  std::array<std::size_t, kColumns> columns{};
  bool has_header = false;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line.empty() || line.front() == '#') continue;
    const std::string place = std::string(name) + ":" + std::to_string(number);
    const std::vector<std::string_view> fields = fields_of(line);
    if (has_header) {
      samples.push_back(sample_of(fields, columns, place));
    } else {
      columns = columns_of(fields, place);
      has_header = true;
    }
  }
  if (samples.empty()) throw FormatError(std::string(name) + ": no samples of a path");
  return samples;
}

// The arc, or line, from one pose to another whose heading is that of the arc's end.
PathSegment segment_between(const Pose& from, const Pose& to) {
  const Vec2 way = to.position() - from.position();
  double turn = std::remainder(to.heading - from.heading, kTwoPi);
  if (std::abs(turn) <= kHeadingRounding) turn = 0.0;
  const double half = 0.5 * turn;
  const double length = turn == 0.0 ? way.norm() : way.norm() * (half / std::sin(half));
  const Gear gear = way.dot(direction_of(from.heading + half)) < 0.0 ? Gear::kReverse : Gear::kForward;
  const double curvature = length > 0.0 ? sign_of(gear) * turn / length : 0.0;
  return {from, length, curvature, gear};
}

}  // namespace

PlanFile parse_path_csv(std::string_view text, std::string_view name) {
  const std::vector<Sample> samples = samples_of(text, name);
  const auto pose_of = [](const Sample& s) { return Pose{s[kX], s[kY], s[kYaw]}; };
  PlanFile file;
  file.start = pose_of(samples.front());
  file.goal = pose_of(samples.back());
  file.start_speed = samples.front()[kDirection] * samples.front()[kV];
  file.goal_speed = samples.back()[kDirection] * samples.back()[kV];
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Sample &from = samples[i - 1], &to = samples[i];
    if (to[kS] == from[kS] && to[kT] == from[kT]) continue;  // a joint, once for each of its segments
    file.path.segments.push_back(
        {pose_of(from), to[kS] - from[kS], from[kCurvature], from[kDirection] > 0.0 ? Gear::kForward : Gear::kReverse});
    file.path.speed_in.push_back(from[kV]);
    file.path.speed_out.push_back(to[kV]);
    file.path.durations.push_back(to[kT] - from[kT]);
  }
  return file;
}

PlanFile parse_nav_msgs(std::string_view text, std::string_view name) {
  const nlohmann::json value = detail::parse_json(text, name);
  const JsonPlace poses = JsonPlace{value, std::string(name)}.at("poses");
  poses.require_array();
  if (poses.value.empty()) poses.expected("at least one pose");
  PlanFile file;
  Pose last;
  for (std::size_t i = 0; i < poses.value.size(); ++i) {
    const JsonPlace pose = poses.at(i).at("pose"), position = pose.at("position"), turn = pose.at("orientation");
    const Pose next{position.at("x").number(), position.at("y").number(),
                    2.0 * std::atan2(turn.at("z").number(), turn.at("w").number())};
    if (i == 0) file.start = next;
    if (i > 0) file.path.segments.push_back(segment_between(last, next));
    last = next;
  }
  file.goal = last;
  return file;
}

}  // namespace arcway

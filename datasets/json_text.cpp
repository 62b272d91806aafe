#include "datasets/json_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace arcway::detail {

using nlohmann::json;

void append_number(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
  } else if (value == 0.0) {
    out += std::signbit(value) ? "-0.0" : "0";  // -0 would be read as an integer
  } else {
    char buffer[32];
    out.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
  }
}

void append_pose(std::string& out, const Pose& pose) {
  out += '[';
  append_number(out, pose.x);
  out += ',';
  append_number(out, pose.y);
  out += ',';
  append_number(out, pose.heading);
  out += ']';
}

void append_string(std::string& out, std::string_view text) {
  out += json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

json parse_json(std::string_view text, std::string_view name, std::size_t first_line) {
  const auto fail = [&](const std::string& message) { throw FormatError(std::string(name) + ": " + message); };
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) fail("empty file, expected JSON");
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    const std::size_t at = std::min(error.byte > 0 ? error.byte - 1 : 0, text.size());
    const auto breaks = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    const std::string place = "line " + std::to_string(first_line + static_cast<std::size_t>(breaks)) + ": ";
    // The parser stops somewhere in the word.
    const std::size_t begin = at - std::min<std::size_t>(at, 2);
    for (const std::string_view word : {"NaN", "nan", "Inf", "inf"})
      if (text.substr(begin, 6).find(word) != std::string_view::npos)
        fail(place + "found " + std::string(word) + ", which is not a number in JSON; coordinates must be finite");
    const std::string what = error.what();
    const std::size_t colon = what.find(": ");
    fail(place + (colon == std::string::npos ? what : what.substr(colon + 2)));
  } catch (const json::exception& error) {  // a number beyond the range of double
    const std::string what = error.what();
    const std::size_t bracket = what.find("] ");
    fail(bracket == std::string::npos ? what : what.substr(bracket + 2));
  }
  return {};
}

std::string shown(const json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array() && value.size() > 4) return "an array of " + std::to_string(value.size());
  std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}

void JsonPlace::fail(const std::string& message) const { throw FormatError(path + ": " + message); }

void JsonPlace::expected(const char* what) const { fail(std::string("expected ") + what + ", found " + shown(value)); }

double JsonPlace::number() const {
  if (!value.is_number()) expected("a number");
  return value.get<double>();
}

std::string JsonPlace::string() const {
  if (!value.is_string()) expected("a string");
  return value.get<std::string>();
}

Pose JsonPlace::pose() const {
  if (!value.is_array() || value.size() != 3) expected("a pose [x, y, heading]");
  return {at(0).number(), at(1).number(), at(2).number()};
}

JsonPlace JsonPlace::at(std::string_view key) const {
  require_object();
  const auto found = value.find(key);
  if (found == value.end()) fail("missing key \"" + std::string(key) + "\"");
  // The source's name and the first key are two parts, further keys are joined with a dot.
  return {*found, path + (path.find(": ") == std::string::npos ? ": " : ".") + std::string(key)};
}

JsonPlace JsonPlace::at(std::size_t index) const { return {value.at(index), path + "[" + std::to_string(index) + "]"}; }

void JsonPlace::require_object() const {
  if (!value.is_object()) expected("an object");
}

void JsonPlace::require_array() const {
  if (!value.is_array()) expected("an array");
}

void JsonPlace::allow_keys(std::initializer_list<std::string_view> keys) const {
  require_object();
  for (const auto& [key, unused] : value.items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) fail("unknown key " + shown(key));
}

void JsonPlace::require_format(std::string_view format, int version) const {
  if (const JsonPlace place = at("format"); place.value != format)
    place.expected(("\"" + std::string(format) + "\"").c_str());
  if (const JsonPlace place = at("version"); place.value != version) place.expected(std::to_string(version).c_str());
}

}  // namespace arcway::detail

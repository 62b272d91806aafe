#include <string>
#include <utility>
#include <variant>

#include "arcway/datasets/geojson.h"
#include "datasets/io/json_text.h"

namespace arcway {

using namespace internal;

namespace {

void append_ring(std::string& out, const Ring& ring) {
  out += '[';
  for (std::size_t i = 0; i <= ring.size() && !ring.empty(); ++i) {
    const Vec2& p = ring[i < ring.size() ? i : 0];
    out += i == 0 ? "[" : ",[";
    detail::append_number(out, p.x());
    out += ',';
    detail::append_number(out, p.y());
    out += ']';
  }
  out += ']';
}

void append_polygon(std::string& out, std::string_view properties, const Polygon& polygon) {
  out += R"({"type":"Feature","properties":)";
  out += properties;
  out += R"(,"geometry":{"type":"Polygon","coordinates":[)";
  append_ring(out, polygon.outer);
  for (const Ring& hole : polygon.holes) {
    out += ',';
    append_ring(out, hole);
  }
  out += "]}}";
}

void append_point(std::string& out, std::string_view role, const Pose& pose) {
  out += R"({"type":"Feature","properties":{"role":")";
  out += role;
  out += R"(","heading":)";
  detail::append_number(out, pose.heading);
  out += R"(},"geometry":{"type":"Point","coordinates":[)";
  detail::append_number(out, pose.x);
  out += ',';
  detail::append_number(out, pose.y);
  out += "]}}";
}

struct RuleText {
  std::string operator()(const KeepOut& rule) const {
    std::string text;
    for (const std::string& vehicle : rule.vehicles) {
      text += text.empty() ? ",\"vehicles\":[" : ",";
      detail::append_string(text, vehicle);
    }
    return text.empty() ? text : text + "]";
  }
  std::string operator()(const SpeedLimit& rule) const {
    std::string text = ",\"max_speed\":";
    detail::append_number(text, rule.max_speed);
    return text;
  }
  std::string operator()(const OneWay& rule) const {
    std::string text = ",\"heading\":";
    detail::append_number(text, rule.heading);
    text += ",\"tolerance\":";
    detail::append_number(text, rule.tolerance);
    return text;
  }
  std::string operator()(const KeepClear& rule) const {
    std::string text = ",\"distance\":";
    detail::append_number(text, rule.distance);
    text += ",\"cost\":";
    detail::append_number(text, rule.cost);
    return text;
  }
};

std::string properties_of(const Zone& zone) {
  std::string text = "{\"role\":\"" + std::string(role_of(zone)) + "\"";
  if (!zone.name.empty()) {
    text += ",\"name\":";
    detail::append_string(text, zone.name);
  }
  return text + std::visit(RuleText{}, zone.rule) + "}";
}

}  // namespace

std::string to_geojson(const MapFile& map) {
  std::string out = R"({"type":"FeatureCollection","planar":{"unit":"m","frame":"map"},"features":[)";
  const char* separator = "\n";
  const auto next = [&] {
    out += separator;
    separator = ",\n";
  };
  if (map.bounds) {
    next();
    append_polygon(out, R"({"role":"boundary"})", {*map.bounds, {}});
  }
  for (const auto& [role, pose] : {std::pair{"start", &map.start}, {"goal", &map.goal}}) {
    if (!*pose) continue;
    next();
    append_point(out, role, **pose);
  }
  for (const Polygon& polygon : map.obstacles) {
    next();
    append_polygon(out, R"({"role":"obstacle"})", polygon);
  }
  for (const Zone& zone : map.zones) {
    next();
    append_polygon(out, properties_of(zone), zone.area);
  }
  out += "\n]}\n";
  return out;
}

}  // namespace arcway

#include "datasets/formats/geojson.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "datasets/json_text.h"

namespace arcway {
namespace {

using detail::shown;
using nlohmann::json;

enum class Role { kObstacle, kBoundary, kStart, kGoal };

constexpr int kMaxDepth = 32;  // of geometry collections

class Reader {
 public:
  explicit Reader(std::string_view name) : name_(name) {}

  void read_top(const json& top) {
    require_object(top, "");
    const std::string type = type_of(top, "");
    if (type == "FeatureCollection") {
      planar_ = planar_ || top.contains("planar");
      if (const auto properties = top.find("properties"); properties != top.end()) read_properties(*properties);
      const auto features = top.find("features");
      if (features == top.end() || !features->is_array())
        fail("", "a FeatureCollection needs an array \"features\", found " +
                     (features == top.end() ? std::string("none") : shown(*features)));
      for (const json& feature : *features) read_feature(feature);
    } else if (type == "Feature") {
      read_feature(top);
    } else {
      read_geometry(top, Role::kObstacle, nullptr, "geometry", 0);
    }
  }

  void read_feature(const json& feature) {
    const std::string place = "feature " + std::to_string(feature_++);
    require_object(feature, place);
    if (const std::string type = type_of(feature, place); type != "Feature")
      fail(place, "expected a Feature, found type \"" + type + "\"");
    const auto geometry = feature.find("geometry");
    if (geometry == feature.end() || geometry->is_null()) return;
    const auto found = feature.find("properties");
    const json* properties = found != feature.end() && found->is_object() ? &*found : nullptr;
    read_geometry(*geometry, role_of(properties, place), properties, place, 0);
  }

  MapFile finish() {
    const Vec2 extent = box_.max - box_.min;
    if (!planar_ && !box_.empty() && box_.min.x() >= -180.0 && box_.max.x() <= 180.0 && box_.min.y() >= -90.0 &&
        box_.max.y() <= 90.0 && extent.maxCoeff() < 1.0)
      warn("", "coordinates look like degrees of longitude and latitude; they are taken as metres");
    if (other_geometries_ > 0)
      warn("", std::to_string(other_geometries_) +
                   " geometries that are not polygons were passed over, the first one in " + other_place_);
    return std::move(map_);
  }

 private:
  [[noreturn]] void fail(const std::string& place, const std::string& message) const {
    throw FormatError(name_ + (place.empty() ? "" : ": " + place) + ": " + message);
  }
  void warn(const std::string& place, const std::string& message) {
    map_.warnings.push_back(name_ + (place.empty() ? "" : ": " + place) + ": " + message);
  }

  void require_object(const json& value, const std::string& place) const {
    if (!value.is_object()) fail(place, "expected an object, found " + shown(value));
  }
  [[nodiscard]] std::string type_of(const json& object, const std::string& place) const {
    const auto type = object.find("type");
    if (type == object.end()) fail(place, "missing key \"type\"");
    if (!type->is_string()) fail(place, "\"type\" must be a string, found " + shown(*type));
    return type->get<std::string>();
  }
  [[nodiscard]] double number(const json& value, const std::string& place) const {
    if (!value.is_number()) fail(place, "expected a number, found " + shown(value));
    return value.get<double>();
  }

  Role role_of(const json* properties, const std::string& place) {
    if (properties == nullptr) return Role::kObstacle;
    const auto role = properties->find("role");
    if (role == properties->end() || role->is_null() || *role == "obstacle") return Role::kObstacle;
    if (*role == "boundary") return Role::kBoundary;
    if (*role == "start") return Role::kStart;
    if (*role == "goal") return Role::kGoal;
    warn(place, "unknown role " + shown(*role) + ", taken as \"obstacle\"");
    return Role::kObstacle;
  }

  void read_properties(const json& properties) {
    if (!properties.is_object()) return;
    if (const auto bounds = properties.find("bounds"); bounds != properties.end() && !bounds->is_null()) {
      const std::string place = "properties.bounds";
      if (!bounds->is_array() || bounds->size() != 4)
        fail(place, "expected [xmin, ymin, xmax, ymax], found " + shown(*bounds));
      double v[4];
      for (std::size_t i = 0; i < 4; ++i) v[i] = number((*bounds)[i], place + "[" + std::to_string(i) + "]");
      if (!(v[0] < v[2] && v[1] < v[3])) fail(place, "must have xmin < xmax and ymin < ymax, found " + bounds->dump());
      set_bounds({{v[0], v[1]}, {v[2], v[1]}, {v[2], v[3]}, {v[0], v[3]}}, place);
    }
    for (const auto& [key, pose] : {std::pair{"start", &map_.start}, {"goal", &map_.goal}}) {
      const auto value = properties.find(key);
      if (value == properties.end() || value->is_null()) continue;
      const std::string place = std::string("properties.") + key;
      if (!value->is_array() || value->size() != 3) fail(place, "expected [x, y, heading], found " + shown(*value));
      double v[3];
      for (std::size_t i = 0; i < 3; ++i) v[i] = number((*value)[i], place + "[" + std::to_string(i) + "]");
      *pose = Pose{v[0], v[1], v[2]};
    }
  }

  void set_bounds(Ring ring, const std::string& place) {
    if (map_.bounds) fail(place, "second bounds; the first are in " + map_.bounds_place);
    map_.bounds = std::move(ring);
    map_.bounds_place = place;
  }

  [[nodiscard]] Vec2 position(const json& value, const std::string& place) const {
    if (!value.is_array() || value.size() < 2) fail(place, "expected a position [x, y], found " + shown(value));
    return {number(value[0], place), number(value[1], place)};
  }

  Ring ring(const json& positions, const std::string& place) {
    if (!positions.is_array()) fail(place, "expected an array of positions, found " + shown(positions));
    Ring result;
    result.reserve(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const json& value = positions[i];
      // The place is put into words only for a message.
      if (!value.is_array() || value.size() < 2 || !value[0].is_number() || !value[1].is_number())
        static_cast<void>(position(value, place + ", position " + std::to_string(i)));
      const Vec2 p(value[0].get<double>(), value[1].get<double>());
      if (result.empty() || p != result.back()) result.push_back(p);
      box_.extend(p);
    }
    if (result.size() > 1 && result.front() == result.back()) {
      result.pop_back();
    } else if (result.size() > 2) {
      warn(place, "ring is not closed; closed");
    }
    if (result.size() < 3)
      fail(place, "needs at least 3 different positions, found " + std::to_string(result.size()) + " in " +
                      std::to_string(positions.size()) + " positions");
    return result;
  }

  void read_polygon(const json& rings, Role role, const std::string& place) {
    if (!rings.is_array()) fail(place, "expected an array of rings, found " + shown(rings));
    if (rings.empty()) return;
    Polygon polygon;
    polygon.outer = ring(rings[0], place + ", ring 0");
    for (std::size_t i = 1; i < rings.size(); ++i)
      polygon.holes.push_back(ring(rings[i], place + ", ring " + std::to_string(i)));
    if (role == Role::kObstacle) {
      map_.obstacles.push_back(std::move(polygon));
      map_.places.push_back(place);
      return;
    }
    set_bounds(std::move(polygon.outer), place);
    for (std::size_t i = 0; i < polygon.holes.size(); ++i) {
      map_.obstacles.push_back({std::move(polygon.holes[i]), {}});
      map_.places.push_back(place + ", ring " + std::to_string(i + 1));
    }
  }

  void read_pose(const json& coordinates, Role role, const json* properties, const std::string& place) {
    const char* word = role == Role::kStart ? "start" : "goal";
    std::optional<Pose>& pose = role == Role::kStart ? map_.start : map_.goal;
    if (pose) fail(place, std::string("second ") + word);
    const Vec2 p = position(coordinates, place);
    const auto heading = properties->find("heading");
    if (heading == properties->end()) fail(place, std::string(word) + " needs the property \"heading\"");
    pose = Pose{p.x(), p.y(), number(*heading, place + ", heading")};
  }

  void read_geometry(const json& geometry, Role role, const json* properties, const std::string& place, int depth) {
    if (geometry.is_null()) return;
    require_object(geometry, place);
    const std::string type = type_of(geometry, place);
    if (type == "GeometryCollection") {
      if (depth == kMaxDepth)
        fail(place, "geometry collections nested more than " + std::to_string(kMaxDepth) + " deep");
      const auto parts = geometry.find("geometries");
      if (parts == geometry.end() || !parts->is_array())
        fail(place, "GeometryCollection needs an array \"geometries\"");
      for (std::size_t i = 0; i < parts->size(); ++i)
        read_geometry((*parts)[i], role, properties, place + ", geometry " + std::to_string(i), depth + 1);
      return;
    }
    const bool polygon = type == "Polygon", multi = type == "MultiPolygon", point = type == "Point";
    if (!polygon && !multi && !point && type != "MultiPoint" && type != "LineString" && type != "MultiLineString")
      fail(place, "unknown geometry type \"" + type + "\"");
    const auto coordinates = geometry.find("coordinates");
    if (coordinates == geometry.end()) fail(place, type + " without \"coordinates\"");
    if (!coordinates->is_array()) fail(place, "expected an array of coordinates, found " + shown(*coordinates));
    if (coordinates->empty()) return;

    if (role == Role::kStart || role == Role::kGoal) {
      if (!point) fail(place, "start and goal must be Points, found " + type);
      read_pose(*coordinates, role, properties, place);
    } else if (polygon) {
      read_polygon(*coordinates, role, place);
    } else if (multi) {
      for (std::size_t i = 0; i < coordinates->size(); ++i)
        read_polygon((*coordinates)[i], role, place + ", polygon " + std::to_string(i));
    } else if (other_geometries_++ == 0) {
      other_place_ = place + " (" + type + ")";
    }
  }

  std::string name_;
  MapFile map_;
  Box box_;
  std::size_t feature_ = 0;
  bool planar_ = false;
  std::size_t other_geometries_ = 0;
  std::string other_place_;
};

// Whether the text is one JSON value a line: the first line is one by itself and something follows.
bool is_sequence(std::string_view text) {
  if (text.starts_with('\x1E')) return true;
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  const std::size_t end = text.find('\n', begin == std::string_view::npos ? 0 : begin);
  if (end == std::string_view::npos || text.find_first_not_of(" \t\r\n", end) == std::string_view::npos) return false;
  return json::accept(text.substr(begin, end - begin));
}

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

}  // namespace

MapFile read_geojson(std::string_view text, std::string_view name) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  Reader reader(name);
  if (!is_sequence(text)) {
    reader.read_top(detail::parse_json(text, name));
    return reader.finish();
  }
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view one = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (one.starts_with('\x1E')) one.remove_prefix(1);
    if (one.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    reader.read_feature(detail::parse_json(one, name, line));
  }
  return reader.finish();
}

MapFile read_geojson(std::istream& input, std::string_view name) {
  const std::string text{std::istreambuf_iterator<char>(input), {}};
  if (input.bad()) throw FileError(std::string(name) + ": cannot be read");
  return read_geojson(text, name);
}

MapFile read_geojson_file(const std::filesystem::path& path) { return read_geojson(read_file(path), path.string()); }

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
  out += "\n]}\n";
  return out;
}

}  // namespace arcway

#include "arcway/datasets/geojson.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "datasets/formats/vector_map.h"
#include "datasets/io/json_text.h"
#include "datasets/io/lowercase.h"
#include "datasets/io/nearest_word.h"

namespace arcway {

using namespace internal;
namespace {

using detail::shown;
using nlohmann::json;

enum class Role { kUnstated, kObstacle, kBoundary, kStart, kGoal, kKeepOut, kSpeedLimit, kOneWay, kClearance };

bool is_zone(Role role) { return role >= Role::kKeepOut; }

constexpr int kMaxDepth = 32;  // nesting of geometry collections

constexpr std::string_view kRoles[] = {"obstacle", "boundary",    "start",   "goal",
                                       "keepout",  "speed_limit", "one_way", "clearance"};
constexpr std::string_view kKeepOutProperties[] = {"role", "curve", "id", "name", "vehicles"};
constexpr std::string_view kSpeedLimitProperties[] = {"role", "curve", "id", "name", "max_speed"};
constexpr std::string_view kOneWayProperties[] = {"role", "curve", "id", "name", "heading", "tolerance"};
constexpr std::string_view kClearanceProperties[] = {"role", "curve", "id", "name", "distance", "cost"};
constexpr std::string_view kTopProperties[] = {"bounds", "start", "goal", "id", "name"};
constexpr std::string_view kReadProperties[] = {"role", "curve", "heading", "id", "name"};
// Parts of properties that elsewhere say where, when or how fast one may drive, and whole names that do.
constexpr std::string_view kDrivingParts[] = {"speed",     "velocity",  "travers", "passable", "walkable", "drivable",
                                              "driveable", "navigable", "oneway",  "inflat",   "clearance"};
constexpr std::string_view kDrivingNames[] = {
    "cost",   "weight", "access", "free",    "freespace", "open",      "blocked", "obstacle", "direction", "radius",
    "buffer", "margin", "hole",   "level",   "floor",     "storey",    "layer",   "time",     "from",      "until",
    "start",  "goal",   "bounds", "endtime", "starttime", "validfrom", "validto", "gate",     "zone"};
constexpr const char* kTop = "properties";  // place of those of the whole file
constexpr std::size_t kMostNamed = 8;       // other properties named in a note

class GeoJsonReader {
 public:
  GeoJsonReader(std::string_view name, const VectorOptions& options) : map_(name, options), lonlat_(options.lonlat) {}

  /// @param top  a FeatureCollection whose features have been read already, or any other document.
  void read_top(const json& top) {
    require_object(top, "");
    read_crs(top);
    const std::string type = type_of(top, "");
    if (type == "FeatureCollection") {
      if (top.contains("planar")) map_.set_planar();
      if (const auto properties = top.find("properties"); properties != top.end()) read_properties(*properties);
      const auto features = top.find("features");
      if (features == top.end() || !features->is_array())
        map_.fail("", "a FeatureCollection needs an array \"features\", found " +
                          (features == top.end() ? std::string("none") : shown(*features)));
    } else if (type == "Feature") {
      read_feature(top);
    } else {
      read_geometry(top, Role::kUnstated, nullptr, "geometry", 0);
    }
  }

  void read_feature(const json& feature) {
    const std::string place = "feature " + std::to_string(feature_++);
    require_object(feature, place);
    if (const std::string type = type_of(feature, place); type != "Feature")
      map_.fail(place, "expected a Feature, found type " + shown(type));
    const auto geometry = feature.find("geometry");
    if (geometry == feature.end() || geometry->is_null()) return;
    const auto found = feature.find("properties");
    const json* properties = found != feature.end() && found->is_object() ? &*found : nullptr;
    if (feature.contains("crs") || feature.contains("coordRefSys")) read_crs(feature);
    if (geometry->is_object()) read_crs(*geometry);  // there PostGIS writes it
    const Role role = role_of(properties, place);
    note_properties(feature, properties, role, place);
    curved_ = is_curved(properties, place);
    read_geometry(*geometry, role, properties, place, 0);
  }

  MapFile finish() {
    report_properties();
    return map_.finish();
  }

 private:
  struct Unread {
    std::size_t features = 0;
    std::string first;  // place
  };

  // Properties that are not read: those that say how or where one may drive are warned of.
  void note_properties(const json& feature, const json* properties, Role role, const std::string& place) {
    for (const char* key : {"role", "curve", "heading"})
      if (feature.contains(key))
        map_.warn(place, "\"" + std::string(key) + "\" is not read beside \"properties\"; put it inside");
    if (properties == nullptr) return;
    for (const auto& [key, value] : properties->items()) {
      const std::span<const std::string_view> read = properties_of(role);
      if (value.is_null() || std::ranges::find(read, key) != read.end()) continue;
      Unread& unread = is_zone(role) ? unread_of_zones_[{role, key}] : unread_[key];
      if (unread.features++ == 0) unread.first = place;
    }
  }
  static std::span<const std::string_view> properties_of(Role role) {
    if (role == Role::kKeepOut) return kKeepOutProperties;
    if (role == Role::kSpeedLimit) return kSpeedLimitProperties;
    if (role == Role::kOneWay) return kOneWayProperties;
    if (role == Role::kClearance) return kClearanceProperties;
    return kReadProperties;
  }
  // A zone says how one may drive, and so may all of its properties.
  void report_properties_of_zones() {
    for (const auto& [role_and_key, unread] : unread_of_zones_) {
      const auto& [role, key] = role_and_key;
      const std::span<const std::string_view> read = properties_of(role);
      const std::string_view nearest = nearest_word(key, read);
      std::string message = "the property " + shown(key) + more_of(unread) + " of a zone is not read; ";
      if (nearest.empty()) {
        message += "these are:";
        for (const std::string_view known : read) message += " " + std::string(known);
      } else {
        message += "did you mean \"" + std::string(nearest) + "\"?";
      }
      map_.warn(unread.first, message);
    }
  }
  static std::string more_of(const Unread& unread) {
    return unread.features > 1 ? " (and of " + std::to_string(unread.features - 1) + " more)" : std::string();
  }
  void report_properties() {
    report_properties_of_zones();
    std::string others;
    std::size_t named = 0, unnamed = 0;
    for (const auto& [key, unread] : unread_) {
      const std::string more = more_of(unread);
      const std::string_view nearest =
          nearest_word(key, unread.first == kTop ? std::span(kTopProperties) : std::span(kReadProperties));
      if (!nearest.empty()) {
        map_.warn(unread.first,
                  "the property " + shown(key) + more + " is not read; did you mean \"" + std::string(nearest) + "\"?");
      } else if (changes_driving(key)) {
        map_.warn(unread.first, "the property " + shown(key) + more +
                                    " is not read: polygons are obstacles for everyone, at all times and speeds");
      } else if (++named <= kMostNamed) {
        others += (others.empty() ? "" : ", ") + shown(key);
      } else {
        ++unnamed;
      }
    }
    if (unnamed > 0) others += " and " + std::to_string(unnamed) + " more";
    if (!others.empty()) map_.map().notes.push_back("properties not read: " + others);
  }
  // As in "maxSpeed", "speed_limit" and "free".
  static bool changes_driving(std::string_view key) {
    std::string plain;
    for (const char c : key)
      if (c != '_' && c != '-' && c != ' ') plain += detail::lowercase(c);
    return std::ranges::find(kDrivingNames, std::string_view(plain)) != std::end(kDrivingNames) ||
           std::ranges::any_of(kDrivingParts,
                               [&](std::string_view part) { return plain.find(part) != std::string::npos; });
  }

  void require_object(const json& value, const std::string& place) const {
    if (!value.is_object()) map_.fail(place, "expected an object, found " + shown(value));
  }
  [[nodiscard]] std::string type_of(const json& object, const std::string& place) const {
    const auto type = object.find("type");
    if (type == object.end()) map_.fail(place, "missing key \"type\"");
    if (!type->is_string()) map_.fail(place, "\"type\" must be a string, found " + shown(*type));
    return type->get<std::string>();
  }
  [[nodiscard]] double number(const json& value, const std::string& place) const {
    if (!value.is_number()) map_.fail(place, "expected a number, found " + shown(value));
    return value.get<double>();
  }

  // The member of the format's first version (2008), or that of JSON-FG.
  void read_crs(const json& object) {
    for (const char* key : {"crs", "coordRefSys"}) {
      const auto crs = object.find(key);
      if (crs == object.end() || crs->is_null()) continue;
      map_.set_system(name_of_crs(*crs));
    }
  }
  // {"type":"name","properties":{"name":...}}, {"type":"EPSG","properties":{"code":...}}, a link, or a text.
  static std::string name_of_crs(const json& crs) {
    const auto text_of = [](const json& value) {
      return value.is_string() ? value.get<std::string>() : value.dump(-1, ' ', false, json::error_handler_t::replace);
    };
    if (!crs.is_object()) return text_of(crs);
    const auto properties = crs.find("properties");
    const json& from = properties != crs.end() && properties->is_object() ? *properties : crs;
    for (const char* key : {"name", "href", "code", "id"}) {
      const auto value = from.find(key);
      if (value == from.end()) continue;
      const bool bare = std::string_view(key) == "code" && crs.value("type", json()).is_string();
      return (bare ? crs["type"].get<std::string>() + ":" : "") + text_of(*value);
    }
    return text_of(crs);
  }

  bool is_curved(const json* properties, const std::string& place) const {
    const auto curve = properties == nullptr ? json::const_iterator() : properties->find("curve");
    if (properties == nullptr || curve == properties->end() || curve->is_null()) return false;
    if (*curve != "spline") map_.fail(place, "unknown curve " + shown(*curve) + ", expected \"spline\"");
    return true;
  }

  Role role_of(const json* properties, const std::string& place) {
    if (properties == nullptr) return Role::kUnstated;
    const auto role = properties->find("role");
    if (role == properties->end() || role->is_null()) return Role::kUnstated;
    if (*role == "obstacle") return Role::kObstacle;
    if (*role == "boundary") return Role::kBoundary;
    if (*role == "start") return Role::kStart;
    if (*role == "goal") return Role::kGoal;
    if (*role == "keepout") return Role::kKeepOut;
    if (*role == "speed_limit") return Role::kSpeedLimit;
    if (*role == "one_way") return Role::kOneWay;
    if (*role == "clearance") return Role::kClearance;
    map_.warn(place, unknown_word("role", role->is_string() ? role->get<std::string>() : shown(*role), kRoles) +
                         "; the feature is taken as an obstacle");
    return Role::kObstacle;
  }

  void read_properties(const json& properties) {
    if (!properties.is_object()) return;
    for (const auto& [key, value] : properties.items())
      if (!value.is_null() && std::ranges::find(kTopProperties, std::string_view(key)) == std::end(kTopProperties))
        unread_[key] = {1, kTop};
    const auto numbers = [&](const json& value, const std::string& place, double* out, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) out[i] = number(value[i], place + "[" + std::to_string(i) + "]");
    };
    if (const auto bounds = properties.find("bounds"); bounds != properties.end() && !bounds->is_null()) {
      const std::string place = "properties.bounds";
      if (!bounds->is_array() || bounds->size() != 4)
        map_.fail(place, "expected [xmin, ymin, xmax, ymax], found " + shown(*bounds));
      double v[4];
      numbers(*bounds, place, v, 4);
      if (lonlat_ && v[0] > v[2]) v[2] += 360.0;  // from the west to the east, as RFC 7946 has it
      if (!(v[0] < v[2] && v[1] < v[3]))
        map_.fail(place, "must have xmin < xmax and ymin < ymax, found " + bounds->dump());
      map_.set_bounds({{{v[0], v[1]}, {v[2], v[1]}, {v[2], v[3]}, {v[0], v[3]}}, {}}, place);
    }
    for (const auto& [key, pose] : {std::pair{"start", &map_.map().start}, {"goal", &map_.map().goal}}) {
      const auto value = properties.find(key);
      if (value == properties.end() || value->is_null()) continue;
      const std::string place = std::string("properties.") + key;
      if (*pose) map_.fail(place, std::string("second ") + key);
      if (!value->is_array() || value->size() != 3)
        map_.fail(place, "expected [x, y, heading], found " + shown(*value));
      double v[3];
      numbers(*value, place, v, 3);
      *pose = Pose{v[0], v[1], v[2]};
    }
  }

  [[nodiscard]] Vec2 position(const json& value, const std::string& place) const {
    if (!value.is_array() || value.size() < 2) map_.fail(place, "expected a position [x, y], found " + shown(value));
    return {number(value[0], place), number(value[1], place)};
  }

  std::vector<Vec2> positions(const json& values, const std::string& place) {
    if (!values.is_array()) map_.fail(place, "expected an array of positions, found " + shown(values));
    std::vector<Vec2> result;
    result.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const json& value = values[i];
      // The place is put into words only for a message.
      if (!value.is_array() || value.size() < 2 || !value[0].is_number() || !value[1].is_number())
        static_cast<void>(position(value, place + ", position " + std::to_string(i)));
      result.emplace_back(value[0].get<double>(), value[1].get<double>());
    }
    return result;
  }
  // `wanted` is the winding that has blocked ground on the left.
  Ring ring(const json& values, int wanted, const std::string& place, detail::VectorMapBuilder::Curves& curves) {
    Ring points = map_.ring(positions(values, place), /*closed=*/true, place);
    curves.emplace_back();
    if (!curved_) return points;
    try {
      const ClosedSpline spline(points);
      curves.back().assign(spline.pieces().begin(), spline.pieces().end());
      return map_.curved_ring(curves.back(), wanted, place);
    } catch (const std::invalid_argument& error) {  // points as written may repeat
      map_.fail(place, error.what());
    }
  }

  [[nodiscard]] ZoneRule rule_of(const json& properties, Role role, const std::string& place) const {
    const auto needed = [&](const char* role_name, const char* key, const char* unit) {
      const auto value = properties.find(key);
      if (value == properties.end())
        map_.fail(place, std::string("a ") + role_name + " needs the property \"" + key + "\" [" + unit + "]");
      return number(*value, place + ", " + key);
    };
    if (role == Role::kSpeedLimit) return SpeedLimit{needed("speed_limit", "max_speed", "m/s")};
    if (role == Role::kOneWay)
      return OneWay{needed("one_way", "heading", "rad"), needed("one_way", "tolerance", "rad")};
    if (role == Role::kClearance)
      return KeepClear{needed("clearance", "distance", "m"), needed("clearance", "cost", "s/m")};
    KeepOut rule;
    const auto vehicles = properties.find("vehicles");
    if (vehicles == properties.end() || vehicles->is_null()) return rule;
    const auto is_name = [](const json& name) { return name.is_string(); };
    if (!vehicles->is_array() || vehicles->empty() || !std::ranges::all_of(*vehicles, is_name))
      map_.fail(place, "expected \"vehicles\" as an array of names of robots, found " + shown(*vehicles) +
                           "; leave it out for all vehicles");
    for (const json& name : *vehicles) rule.vehicles.push_back(name.get<std::string>());
    return rule;
  }

  void add_zone(Polygon area, Role role, const json& properties, const std::string& place) {
    const auto name = properties.find("name");
    std::string text;
    if (name != properties.end() && !name->is_null())
      text = name->is_string() ? name->get<std::string>() : name->dump();
    map_.map().zones.push_back({std::move(area), rule_of(properties, role, place), std::move(text)});
    map_.map().zone_places.push_back(place);
  }

  void read_polygon(const json& rings, Role role, const json* properties, const std::string& place) {
    if (!rings.is_array()) map_.fail(place, "expected an array of rings, found " + shown(rings));
    if (rings.empty()) return;
    Polygon polygon;
    detail::VectorMapBuilder::Curves curves;
    const int outer = role == Role::kBoundary ? -1 : role == Role::kUnstated ? map_.outer_winding() : 1;
    polygon.outer = ring(rings[0], outer, place + ", ring 0", curves);
    for (std::size_t i = 1; i < rings.size(); ++i)
      polygon.holes.push_back(ring(rings[i], -outer, place + ", ring " + std::to_string(i), curves));
    if (role == Role::kUnstated) return map_.add_polygon(std::move(polygon), place, std::move(curves));
    if (role == Role::kObstacle) return map_.add_obstacle(std::move(polygon), place, std::move(curves));
    if (is_zone(role)) return add_zone(std::move(polygon), role, *properties, place);
    map_.set_bounds(std::move(polygon), place, std::move(curves));
  }

  void read_pose(const json& coordinates, Role role, const json* properties, const std::string& place) {
    const char* word = role == Role::kStart ? "start" : "goal";
    std::optional<Pose>& pose = role == Role::kStart ? map_.map().start : map_.map().goal;
    if (pose) map_.fail(place, std::string("second ") + word);
    const Vec2 p = position(coordinates, place);
    const auto heading = properties->find("heading");
    if (heading == properties->end()) map_.fail(place, std::string(word) + " needs the property \"heading\"");
    pose = Pose{p.x(), p.y(), number(*heading, place + ", heading")};
  }

  void read_geometry(const json& geometry, Role role, const json* properties, const std::string& place, int depth) {
    if (geometry.is_null()) return;
    require_object(geometry, place);
    const std::string type = type_of(geometry, place);
    if (type == "GeometryCollection") {
      if (depth == kMaxDepth)
        map_.fail(place, "geometry collections nested more than " + std::to_string(kMaxDepth) + " deep");
      const auto parts = geometry.find("geometries");
      if (parts == geometry.end() || !parts->is_array())
        map_.fail(place, "GeometryCollection needs an array \"geometries\"");
      for (std::size_t i = 0; i < parts->size(); ++i)
        read_geometry((*parts)[i], role, properties, place + ", geometry " + std::to_string(i), depth + 1);
      return;
    }
    const bool polygon = type == "Polygon", multi = type == "MultiPolygon", point = type == "Point";
    const bool line = type == "LineString", lines = type == "MultiLineString";
    if (!polygon && !multi && !point && !line && !lines && type != "MultiPoint")
      map_.fail(place, "unknown geometry type " + shown(type));
    const auto coordinates = geometry.find("coordinates");
    if (coordinates == geometry.end()) map_.fail(place, type + " without \"coordinates\"");
    if (!coordinates->is_array()) map_.fail(place, "expected an array of coordinates, found " + shown(*coordinates));
    if (coordinates->empty()) return;

    const auto part = [&](const char* what, std::size_t i) { return place + ", " + what + " " + std::to_string(i); };
    if (role == Role::kStart || role == Role::kGoal) {
      if (!point) map_.fail(place, "start and goal must be Points, found " + shown(type));
      read_pose(*coordinates, role, properties, place);
    } else if (polygon) {
      read_polygon(*coordinates, role, properties, place);
    } else if (multi) {
      for (std::size_t i = 0; i < coordinates->size(); ++i)
        read_polygon((*coordinates)[i], role, properties, part("polygon", i));
    } else if (is_zone(role)) {
      map_.fail(place, "a zone must be a Polygon or MultiPolygon, found " + shown(type));
    } else if (line) {
      map_.add_line(positions(*coordinates, place), place);
    } else if (lines) {
      for (std::size_t i = 0; i < coordinates->size(); ++i)
        map_.add_line(positions((*coordinates)[i], part("line", i)), part("line", i));
    } else {
      map_.pass_over(place, type);
    }
  }

  detail::VectorMapBuilder map_;
  std::size_t feature_ = 0;
  bool lonlat_;                           // bounds may lie across the antimeridian
  bool curved_ = false;                   // whether the feature being read has curves
  std::map<std::string, Unread> unread_;  // by property
  std::map<std::pair<Role, std::string>, Unread> unread_of_zones_;
};

// Replaces NaN by null where it is the third or a later number of an array. Writers without heights write NaN there,
// which is no JSON, and positions ignore these numbers. Elsewhere NaN stays, and is refused with its line.
std::string without_missing_heights(std::string_view text) {
  std::string result;
  std::size_t commas = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' && (i == 0 || text[i - 1] != '\\')) quoted = !quoted;
    if (!quoted) {
      if (c == '[' || c == '{') commas = 0;
      if (c == ',') ++commas;
      std::size_t length = 0;
      for (const std::string_view word : {"NaN", "-Infinity", "Infinity"})
        if (text.substr(i, word.size()) == word) length = word.size();
      if (length > 0 && commas >= 2) {
        result += "null";
        i += length - 1;
        continue;
      }
    }
    result += c;
  }
  return result;
}

// Whether the text is one JSON value a line: the first line is one by itself and something follows.
bool is_sequence(std::string_view text) {
  if (text.starts_with('\x1E')) return true;
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  const std::size_t end = text.find('\n', begin == std::string_view::npos ? 0 : begin);
  if (end == std::string_view::npos || text.find_first_not_of(" \t\r\n", end) == std::string_view::npos) return false;
  return json::accept(text.substr(begin, end - begin));
}

}  // namespace

MapFile read_geojson(std::string_view text, std::string_view name, const VectorOptions& options) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::string mended;
  if (text.find("NaN") != std::string_view::npos || text.find("Infinity") != std::string_view::npos)
    text = mended = without_missing_heights(text);
  GeoJsonReader reader(name, options);
  if (!is_sequence(text)) {
    const detail::JsonElements features{.key = "features",
                                        .restart = [&] { reader = GeoJsonReader(name, options); },
                                        .element = [&](const json& feature) { reader.read_feature(feature); }};
    reader.read_top(detail::parse_json(text, name, &features));
    return reader.finish();
  }
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view one = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (one.starts_with('\x1E')) one.remove_prefix(1);
    if (one.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    reader.read_feature(detail::parse_json(one, name, nullptr, line));
  }
  return reader.finish();
}

}  // namespace arcway

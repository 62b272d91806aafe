#include "arcway/datasets/map_file.h"

#include <algorithm>
#include <string>
#include <utility>

#include "arcway/datasets/repair.h"
#include "core/geometry/predicates.h"

namespace arcway {

using namespace internal;

bool looks_like_degrees(const Box& box) {
  constexpr double kWidest = 1.0;    // [degrees], 111 km
  constexpr double kFarther = 20.0;  // than the map is wide
  if (box.empty() || box.min.x() < -180.0 || box.max.x() > 180.0 || box.min.y() < -90.0 || box.max.y() > 90.0)
    return false;
  const double width = (box.max - box.min).maxCoeff(), away = (0.5 * (box.min + box.max)).cwiseAbs().maxCoeff();
  return width < kWidest && away > kFarther * width;
}

namespace {

bool is_on_a_line(const Ring& ring) {
  const auto other = std::ranges::find_if(ring, [&](const Vec2& p) { return p != ring[0]; });
  return other == ring.end() ||
         std::ranges::all_of(ring, [&](const Vec2& p) { return orientation(ring[0], *other, p) == 0; });
}

// What mends a polygon that World refuses; nothing where no rule says what is meant.
std::string remedy_for(const Polygon& polygon, std::string_view name) {
  if (!can_repair() || !std::ranges::all_of(polygon.outer, [](const Vec2& p) { return is_in_range(p); })) return "";
  const std::string repair = "arcway doctor " + std::string(name) + " --repair W.geojson";
  if (!is_on_a_line(polygon.outer)) return "; '" + repair + "' writes a map of valid rings";
  return "; a wall needs a width: draw it as a line string and give --wall-width, or leave it out by '" + repair + "'";
}

// Whether World refuses it, alone as it is.
bool is_refused(const Polygon& polygon) {
  try {
    const World alone({polygon});
    return false;
  } catch (const WorldError&) {
    return true;
  }
}

}  // namespace

World to_world(const MapFile& map, std::string_view name) {
  try {
    const World world(map.obstacles, map.bounds);
    return map.zones.empty() ? world : world.with_zones(map.zones);
  } catch (const ZoneError& error) {
    const std::size_t k = error.zone();
    const std::string place = k < map.zone_places.size() ? map.zone_places[k] + ": " : "";
    const Polygon& area = map.zones[k].area;
    const std::string remedy = is_refused(area) ? remedy_for(area, name) : "";  // else its rule is
    throw FormatError(std::string(name) + ": " + place + error.what() + remedy);
  } catch (const WorldError& error) {
    const std::size_t k = error.obstacle();
    const std::string place = k < map.places.size() ? map.places[k] : k >= map.obstacles.size() ? map.bounds_place : "";
    const std::string remedy = k < map.obstacles.size() ? remedy_for(map.obstacles[k], name)
                               : map.bounds             ? remedy_for({*map.bounds, {}}, name)
                                                        : "";
    throw FormatError(std::string(name) + ": " + (place.empty() ? "" : place + ": ") + error.what() + remedy);
  }
}

MapFile to_map_file(const World& world) {
  MapFile map;
  map.zones.assign(world.zones().begin(), world.zones().end());
  for (ObstacleId o = 0; o < world.region_count(); ++o) {
    if (world.keep_out_of(o) != kNone) continue;
    Polygon polygon = world.polygon_of(o);
    if (o == world.obstacle_count())
      map.bounds = std::move(polygon.outer);
    else
      map.obstacles.push_back(std::move(polygon));
  }
  return map;
}

}  // namespace arcway

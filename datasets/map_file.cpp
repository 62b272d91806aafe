#include "datasets/map_file.h"

#include <utility>

namespace arcway {

bool looks_like_degrees(const Box& box) {
  constexpr double kWidest = 1.0;    // [degrees], 111 km
  constexpr double kFarther = 20.0;  // than the map is wide
  if (box.empty() || box.min.x() < -180.0 || box.max.x() > 180.0 || box.min.y() < -90.0 || box.max.y() > 90.0)
    return false;
  const double width = (box.max - box.min).maxCoeff(), away = (0.5 * (box.min + box.max)).cwiseAbs().maxCoeff();
  return width < kWidest && away > kFarther * width;
}

World to_world(const MapFile& map, std::string_view name) {
  try {
    return World(map.obstacles, map.bounds);
  } catch (const WorldError& error) {
    const std::size_t k = error.obstacle();
    const std::string place = k < map.places.size() ? map.places[k] : k >= map.obstacles.size() ? map.bounds_place : "";
    throw FormatError(std::string(name) + ": " + (place.empty() ? "" : place + ": ") + error.what());
  }
}

MapFile to_map_file(const World& world) {
  MapFile map;
  for (ObstacleId o = 0; o < world.region_count(); ++o) {
    const auto starts = world.ring_starts(o);
    std::vector<Ring> rings;
    for (std::size_t r = 0; r < starts.size(); ++r) {
      const VertexId end = r + 1 < starts.size() ? starts[r + 1] : world.vertices_of(o).last;
      const auto all = world.vertices();
      rings.emplace_back(all.begin() + starts[r], all.begin() + end);
    }
    if (o == world.obstacle_count()) {
      map.bounds = std::move(rings.front());
    } else {
      Ring outer = std::move(rings.front());
      rings.erase(rings.begin());
      map.obstacles.push_back({std::move(outer), std::move(rings)});
    }
  }
  return map;
}

}  // namespace arcway

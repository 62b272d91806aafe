// Polygons that are free space: what is blocked is their complement.

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "arcway/datasets/repair.h"
#include "datasets/formats/vector_map.h"

namespace arcway::internal::detail {
namespace {

Ring box_ring(const Box& box, double growth) {
  const Vec2 a = box.min.array() - growth, b = box.max.array() + growth;
  return {a, {b.x(), a.y()}, b, {a.x(), b.y()}};
}

bool has_rings_only(const Polygon& polygon) {
  return polygon.outer.size() >= 3 &&
         std::ranges::all_of(polygon.holes, [](const Ring& hole) { return hole.size() >= 3; });
}

}  // namespace

void VectorMapBuilder::enclose_free_space() {
  if (!options_.free_polygons) return;
  if (map_.bounds && !free_.empty())
    fail(free_.front().place,
         "polygons are free space by --polygons, and there are bounds in " + map_.bounds_place + "; give one of them");
  if (free_.empty()) {
    if (!map_.bounds) fail("", "no polygons that could be free space (--polygons)");
    return;
  }
  const std::size_t given = free_.size();
  if (given > 1 && can_repair() &&
      std::ranges::all_of(free_, [](const FreePolygon& free) { return has_rings_only(free.polygon); })) {
    std::vector<Polygon> all;
    for (FreePolygon& free : free_) all.push_back(std::move(free.polygon));
    const std::string place = free_.front().place + " and " + std::to_string(given - 1) + " more";
    free_.clear();
    try {
      for (Polygon& polygon : united(all)) free_.push_back({std::move(polygon), place, {}});
    } catch (const std::runtime_error& error) {
      fail(place, error.what());
    }
    if (free_.empty()) fail(place, "the polygons of free space enclose no area");
    map_.notes.push_back(std::to_string(given) + " polygons of free space, united to " + std::to_string(free_.size()));
  } else {
    map_.notes.push_back(std::to_string(given) + (given == 1 ? " polygon" : " polygons") + " of free space");
  }
  if (free_.size() == 1) return set_bounds(std::move(free_[0].polygon), free_[0].place, std::move(free_[0].curves));

  // Several are holes of one obstacle, which reaches beyond the bounds.
  constexpr double kBounds = 1.0, kObstacle = 2.0;  // around them [m]
  Box box;
  for (const FreePolygon& free : free_)
    for (const Vec2& p : free.polygon.outer) box.extend(p);
  Polygon around{box_ring(box, kObstacle), {}};
  std::vector<std::pair<Ring, std::string>> islands;
  for (FreePolygon& free : free_) {
    around.holes.push_back(std::move(free.polygon.outer));
    for (Ring& hole : free.polygon.holes) islands.emplace_back(std::move(hole), free.place);
  }
  add_obstacle(std::move(around), "around the free space");
  for (auto& [island, place] : islands) add_obstacle({std::move(island), {}}, place);
  map_.bounds = box_ring(box, kBounds);
  map_.bounds_place = "around the free space";
}

}  // namespace arcway::internal::detail

#include "accel/expansion/occupants.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace arcway::internal {

Occupants::Places Occupants::places_of(const OpenedTriangulation& triangulation, const Box& box) {
  Places places;
  const std::array boxes{box};
  triangulation.visit_near(boxes, [&](std::uint32_t first) {
    if (triangulation.may_meet(first, box)) places.triangles.push_back(first / 3);
  });
  triangulation.visit_boundary_near(boxes, [&](const PlanarMap::Edge& edge, const Box& box_of_edge) {
    if (box_of_edge.overlaps(box)) places.points.push_back(edge.low);
  });
  std::ranges::sort(places.points);
  places.points.erase(std::unique(places.points.begin(), places.points.end()), places.points.end());
  return places;
}

void Occupants::add(const OpenedTriangulation& triangulation, const World::VertexRange& vertices, const Box& box) {
  known_.push_back({{next_number_++, vertices, box}, nullptr});
  put(triangulation, known_.back());
}

void Occupants::put(const OpenedTriangulation& triangulation, Known& known) {
  known.places = std::make_shared<const Places>(places_of(triangulation, known.occupant.box));
  for (const std::uint32_t triangle : known.places->triangles) in_triangles_.add(triangle, known.occupant.number);
  for (const std::uint32_t point : known.places->points) at_points_.add(point, known.occupant.number);
}

void Occupants::remove(const Known& known) {
  for (const std::uint32_t triangle : known.places->triangles) in_triangles_.remove(triangle, known.occupant.number);
  for (const std::uint32_t point : known.places->points) at_points_.remove(point, known.occupant.number);
}

void Occupants::spread(const OpenedTriangulation& triangulation, const Box& place) {
  for (Known& known : known_) {
    if (!known.occupant.box.overlaps(place)) continue;
    remove(known);
    put(triangulation, known);
  }
}

void Occupants::follow(const VertexMap& map) {
  std::erase_if(known_, [&](Known& known) {
    World::VertexRange& vertices = known.occupant.vertices;
    const VertexId first = map.after(vertices.first);
    if (first == kNone) {
      remove(known);
      return true;
    }
    vertices = {first, first + (vertices.last - vertices.first)};
    return false;
  });
}

const Occupants::Occupant& Occupants::with_number(std::uint32_t number) const {
  const auto known = std::ranges::lower_bound(known_, number, {}, [](const Known& k) { return k.occupant.number; });
  assert(known != known_.end() && known->occupant.number == number);
  return known->occupant;
}

std::vector<std::uint32_t> Occupants::numbers() const {
  std::vector<std::uint32_t> numbers;
  for (const Known& known : known_) numbers.push_back(known.occupant.number);
  return numbers;
}

std::size_t Occupants::vertex_count() const {
  std::size_t count = 0;
  for (const Known& known : known_) count += known.occupant.vertices.last - known.occupant.vertices.first;
  return count;
}

}  // namespace arcway::internal

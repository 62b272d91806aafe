#include "accel/expansion/change_visibility.h"

#include <algorithm>

#include "core/geometry/box_tree.h"
#include "core/geometry/predicates.h"

namespace arcway::internal {

namespace {

// Whether a box lies strictly to the right of the line from a to b.
bool lies_right_of(const Vec2& a, const Vec2& b, const Box& box) {
  for (const Vec2& corner : box.corners())
    if (orientation(a, b, corner) >= 0) return false;
  return true;
}

}  // namespace

void ChangeVisibility::look_from(std::span<const Box> places) {
  const BoxTree tree(places);
  const auto box_of = [&](std::span<const std::uint32_t> sites) {
    Box box;
    for (const std::uint32_t site : sites) box.extend(map_.sites()[site]);
    return box;
  };
  for (std::size_t triangle = 0; 3 * triangle < map_.doors().size(); ++triangle) {
    const Corners corners = corners_of(triangle);
    tree.visit_overlaps(box_of(corners), [&](std::uint32_t i) {
      if (meets(corners, places[i])) look_through(triangle, corners, places[i]);
      return !gives_up_;
    });
    if (gives_up_) return;
  }
  for (std::uint32_t site = 0; site < map_.sites().size(); ++site)
    for (const PlanarMap::Edge& wall : map_.edges_from(site))
      if (!tree.visit_overlaps(box_of(std::array{wall.low, wall.high}), [](std::uint32_t) { return false; }))
        follow_wall(wall);
}

ChangeVisibility::Corners ChangeVisibility::corners_of(std::size_t triangle) const {
  const SightMap::Door* const doors = map_.doors().data() + 3 * triangle;
  return {doors[1].site, doors[2].site, doors[0].site};
}

// From a place that a triangle meets out of it.
void ChangeVisibility::look_through(std::size_t triangle, const Corners& corners, const Box& place) {
  for (const std::uint32_t corner : corners) mark(map_.first_node_at(corner));
  for (std::uint32_t j = 0; j < 3; ++j) {
    const std::uint32_t door = map_.doors()[3 * triangle + (j + 1) % 3].left;
    // Sights that go on where the place is are looked for from there.
    if (door != kNone && !meets(corners_of(door / 3), place)) walk(corners, {door, kNone, kNone});
  }
}

void ChangeVisibility::walk(const Corners& corners, Range range) {
  const SightMap::Door* const doors = map_.doors().data();
  stack_.push_back(range);
  while (!stack_.empty()) {
    auto [door, low, high] = stack_.back();
    stack_.pop_back();
    while (door != kNone) {
      if (++steps_ > map_.doors().size()) {  // more than looking from everywhere is worth
        std::fill(seen_.begin(), seen_.end(), std::uint8_t{1});
        stack_.clear();
        gives_up_ = true;
        return;
      }
      const SightMap::Door& triangle = doors[door];
      if (low != kNone && all_pass(corners, low, triangle.site, 1)) {
        door = triangle.left;
      } else if (high != kNone && all_pass(corners, high, triangle.site, -1)) {
        door = triangle.right;
      } else {
        mark(triangle.node);
        if (triangle.right != kNone) stack_.push_back({triangle.right, low, triangle.site});
        door = triangle.left;
        low = triangle.site;
      }
    }
  }
}

// Sights that run along walls all the way: from a wall at a place straight on, both ways, to the first node.
void ChangeVisibility::follow_wall(const PlanarMap::Edge& wall) {
  const std::span<const Vec2> sites = map_.sites();
  const PlanarMap::Edge* edge = &wall;
  while (edge && map_.first_node_at(edge->high) == kNone) {
    const PlanarMap::Edge* straight_on = nullptr;
    for (const PlanarMap::Edge& next : map_.edges_from(edge->high))
      if (orientation(sites[edge->low], sites[edge->high], sites[next.high]) == 0) straight_on = &next;
    edge = straight_on;
  }
  if (edge) mark(map_.first_node_at(edge->high));
  edge = &wall;
  while (edge && map_.first_node_at(edge->low) == kNone) {
    const PlanarMap::Edge* straight_on = nullptr;
    for (const std::uint32_t next : map_.edges_to(edge->low))
      if (orientation(sites[edge->high], sites[edge->low], sites[map_.edge(next).low]) == 0)
        straight_on = &map_.edge(next);
    edge = straight_on;
  }
  if (edge) mark(map_.first_node_at(edge->low));
}

void ChangeVisibility::mark(std::uint32_t first_node) {
  for (std::uint32_t n = first_node; n != kNone; n = map_.nodes()[n].sibling) seen_[n] = 1;
}

bool ChangeVisibility::meets(const Corners& corners, const Box& place) const {
  Box box;
  for (const std::uint32_t corner : corners) box.extend(map_.sites()[corner]);
  if (!box.overlaps(place)) return false;
  for (std::uint32_t j = 0; j < 3; ++j)
    if (lies_right_of(map_.sites()[corners[j]], map_.sites()[corners[(j + 1) % 3]], place)) return false;
  return true;
}

// Whether a site lies to the right (1) or to the left (-1) of the rays from all corners past the limit: no ray that
// leaves the limit on its other side gets there.
bool ChangeVisibility::all_pass(const Corners& corners, std::uint32_t limit, std::uint32_t site, int side) const {
  for (const std::uint32_t corner : corners)
    if (orientation(map_.sites()[corner], map_.sites()[limit], map_.sites()[site]) * side >= 0) return false;
  return true;
}

}  // namespace arcway::internal

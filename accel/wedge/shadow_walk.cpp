#include "accel/wedge/shadow_walk.h"

#include <algorithm>

#include "core/geometry/predicates.h"

namespace arcway {

namespace {

// Whether a box lies strictly to the right of the line from a to b.
bool lies_right_of(const Vec2& a, const Vec2& b, const Box& box) {
  for (const Vec2& corner : box.corners())
    if (orientation(a, b, corner) >= 0) return false;
  return true;
}

}  // namespace

void ShadowWalk::look_from(const Box& place) {
  const std::span<const SightMap::Door> doors = map_.doors();
  const auto corners_of = [&](std::size_t triangle, std::uint32_t(&corners)[3]) {
    for (std::uint32_t j = 0; j < 3; ++j) corners[j] = doors[3 * triangle + (j + 1) % 3].site;
  };
  for (std::size_t triangle = 0; 3 * triangle < doors.size(); ++triangle) {
    std::uint32_t corners[3];
    corners_of(triangle, corners);
    if (!meets(corners, place)) continue;
    for (const std::uint32_t corner : corners) mark(map_.first_node_at(corner));
    for (std::uint32_t j = 0; j < 3; ++j) {
      const std::uint32_t door = doors[3 * triangle + (j + 1) % 3].left;
      if (door == kNone) continue;
      std::uint32_t beyond[3];
      corners_of(door / 3, beyond);
      if (meets(beyond, place)) continue;  // sights that go on there are looked for from there
      walk(corners, {door, kNone, kNone});
    }
  }
  follow_walls(place);
}

void ShadowWalk::walk(const std::uint32_t (&corners)[3], Range range) {
  const SightMap::Door* const doors = map_.doors().data();
  stack_.push_back(range);
  while (!stack_.empty()) {
    auto [door, low, high] = stack_.back();
    stack_.pop_back();
    while (door != kNone) {
      if (++steps_ > map_.doors().size()) {  // more than looking from everywhere is worth
        std::fill(seen_.begin(), seen_.end(), std::uint8_t{1});
        stack_.clear();
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

// Sights that run along walls all the way: from a wall at the place straight on, both ways, to the first node.
void ShadowWalk::follow_walls(const Box& place) {
  const std::span<const Vec2> sites = map_.sites();
  const auto meets_place = [&](const PlanarMap::Edge& edge) {
    Box box;
    box.extend(sites[edge.low]);
    box.extend(sites[edge.high]);
    return box.overlaps(place);
  };
  for (std::uint32_t site = 0; site < sites.size(); ++site)
    for (const PlanarMap::Edge& first : map_.edges_from(site)) {
      if (!meets_place(first)) continue;
      const PlanarMap::Edge* edge = &first;
      while (edge && map_.first_node_at(edge->high) == kNone) {
        const PlanarMap::Edge* straight_on = nullptr;
        for (const PlanarMap::Edge& next : map_.edges_from(edge->high))
          if (orientation(sites[edge->low], sites[edge->high], sites[next.high]) == 0) straight_on = &next;
        edge = straight_on;
      }
      if (edge) mark(map_.first_node_at(edge->high));
      edge = &first;
      while (edge && map_.first_node_at(edge->low) == kNone) {
        const PlanarMap::Edge* straight_on = nullptr;
        for (const std::uint32_t next : map_.edges_to(edge->low))
          if (orientation(sites[edge->high], sites[edge->low], sites[map_.edge(next).low]) == 0)
            straight_on = &map_.edge(next);
        edge = straight_on;
      }
      if (edge) mark(map_.first_node_at(edge->low));
    }
}

void ShadowWalk::mark(std::uint32_t first_node) {
  for (std::uint32_t n = first_node; n != kNone; n = map_.nodes()[n].sibling) seen_[n] = 1;
}

bool ShadowWalk::meets(const std::uint32_t (&corners)[3], const Box& place) const {
  Box box;
  for (const std::uint32_t corner : corners) box.extend(map_.sites()[corner]);
  if (!box.overlaps(place)) return false;
  for (std::uint32_t j = 0; j < 3; ++j)
    if (lies_right_of(map_.sites()[corners[j]], map_.sites()[corners[(j + 1) % 3]], place)) return false;
  return true;
}

// Whether a site lies to the right (1) or to the left (-1) of the rays from all corners past the limit: no ray that
// leaves the limit on its other side gets there.
bool ShadowWalk::all_pass(const std::uint32_t (&corners)[3], std::uint32_t limit, std::uint32_t site, int side) const {
  for (const std::uint32_t corner : corners)
    if (orientation(map_.sites()[corner], map_.sites()[limit], map_.sites()[site]) * side >= 0) return false;
  return true;
}

}  // namespace arcway

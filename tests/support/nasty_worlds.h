#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "arcway/world.h"
#include "core/geometry/predicates.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal::test {

/// Rings on a coarse grid of whole numbers, so that contacts, overlaps, coincidences and collinear triples of every
/// kind abound; about one in two has a shape that World takes.
inline Ring grid_ring(RandomInputs& random, std::int64_t size) {
  const auto at = [&] { return random.grid_point(0, size); };
  switch (random.integer(0, 4)) {
    case 0: {  // triangle
      return {at(), at(), at()};
    }
    case 1: {  // box
      const Vec2 a = at(), b = at();
      return {a, {b.x(), a.y()}, b, {a.x(), b.y()}};
    }
    case 2: {  // cell
      const Vec2 a = at();
      return square(a.x(), a.y(), 1.0);
    }
    case 3: {  // L, T, U and Z of cells
      const Vec2 a = at();
      const double w = static_cast<double>(random.integer(2, 4)), h = static_cast<double>(random.integer(2, 4));
      return {a,
              {a.x() + w, a.y()},
              {a.x() + w, a.y() + 1},
              {a.x() + 1, a.y() + 1},
              {a.x() + 1, a.y() + h},
              {a.x(), a.y() + h}};
    }
    default: {  // star with rounded corners
      Ring ring = random_star(random, at(), 0.5, 0.5 * static_cast<double>(size),
                              static_cast<std::size_t>(random.integer(3, 8)));
      for (Vec2& p : ring) p = p.array().round();
      return ring;
    }
  }
}

inline bool crosses(const Ring& a, const Ring& b) {
  for (std::size_t i = 0, before_i = a.size() - 1; i < a.size(); before_i = i++)
    for (std::size_t j = 0, before_j = b.size() - 1; j < b.size(); before_j = j++)
      if (relate({a[before_i], a[i]}, {b[before_j], b[j]}) == SegmentRelation::kCrossing) return true;
  return false;
}

/// A world of up to `obstacles` of them, some with holes, sometimes with bounds; mapped to other places, scales and
/// headings half of the time, where rounding breaks some of the contacts by a hair. In one of two worlds no edges cross
/// properly: obstacles touch, nest, and overlap along edges.
inline World nasty_world(std::uint64_t seed, std::int64_t obstacles) {
  RandomInputs random(seed);
  const std::int64_t size = random.integer(3, 14);
  const std::int64_t transform = random.integer(0, 5);
  const bool may_cross = random.integer(0, 1) == 0;
  const double heading = random.uniform(0.0, 6.0);
  const auto place = [&](Ring ring) {
    for (Vec2& p : ring) {
      if (transform == 1) p = p * 0.125 + Vec2(1e7, -1e7);
      if (transform == 2) p = p * 0.1 + Vec2(0.3, 0.7);
      if (transform == 3) p = p.x() * direction_of(heading) + p.y() * perpendicular(direction_of(heading));
      if (transform == 4) p = Vec2(p.x() * 1e6, p.y());
    }
    return ring;
  };
  const auto is_legal = [](const Polygon& polygon) {
    try {
      const World alone({polygon});
      return true;
    } catch (const WorldError&) {
      return false;
    }
  };
  std::vector<Polygon> polygons;
  const std::int64_t count = random.integer(0, obstacles);
  for (std::int64_t i = 0; i < count; ++i) {
    Polygon polygon{place(grid_ring(random, size)), {}};
    if (!is_legal(polygon)) continue;
    for (std::int64_t h = random.integer(-3, 3); h > 0; --h) {
      polygon.holes.push_back(place(grid_ring(random, size)));
      if (!is_legal(polygon)) polygon.holes.pop_back();
    }
    const auto is_crossed_by = [&](const Polygon& other) {
      const auto ring_crossed = [&](const Ring& ring) {
        return crosses(ring, other.outer) || std::any_of(other.holes.begin(), other.holes.end(),
                                                         [&](const Ring& hole) { return crosses(ring, hole); });
      };
      return ring_crossed(polygon.outer) || std::any_of(polygon.holes.begin(), polygon.holes.end(), ring_crossed);
    };
    if (!may_cross && std::any_of(polygons.begin(), polygons.end(), is_crossed_by)) continue;
    polygons.push_back(std::move(polygon));
  }
  if (random.integer(0, 2) == 0) {
    const double s = static_cast<double>(size);
    Ring bounds = place(random.integer(0, 1) == 0 ? square(0, 0, s) : grid_ring(random, size));
    if (is_legal({bounds, {}})) return World(std::move(polygons), std::move(bounds));
  }
  return World(std::move(polygons));
}

/// One in so many of a world's obstacles, about, ascending.
inline std::vector<ObstacleId> draw_obstacles(const World& world, std::int64_t one_in, RandomInputs& random) {
  std::vector<ObstacleId> drawn;
  for (ObstacleId o = 0; o < world.obstacle_count(); ++o)
    if (random.integer(1, one_in) == 1) drawn.push_back(o);
  return drawn;
}

}  // namespace arcway::internal::test

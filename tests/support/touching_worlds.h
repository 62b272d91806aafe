#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "arcway/world.h"
#include "tests/support/nasty_worlds.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal::test {

inline bool is_region(const Polygon& polygon) {
  try {
    const World alone({polygon});
    return true;
  } catch (const WorldError&) {
    return false;
  }
}

/// A polygon of whole coordinates whose rings touch each other and themselves: at vertices, and inside edges from
/// either side.
inline Polygon touching_polygon(RandomInputs& random, std::int64_t size) {
  constexpr double kSteps = 4.0;  // on an edge, at whole coordinates
  const auto at = [&]() -> Vec2 { return kSteps * random.grid_point(0, size); };
  Polygon polygon;
  do {
    polygon = {grid_ring(random, size), {}};
    for (Vec2& p : polygon.outer) p *= kSteps;
  } while (!is_region(polygon));
  const auto point_on_a_ring = [&]() -> Vec2 {
    const auto r = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(polygon.holes.size())));
    const Ring& ring = r == 0 ? polygon.outer : polygon.holes[r - 1];
    const auto i = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(ring.size()) - 1));
    const double share = static_cast<double>(random.integer(0, 3)) / kSteps;
    const Vec2 p = ring[i] + share * (ring[(i + 1) % ring.size()] - ring[i]);
    return p == p.array().round().matrix() ? p : ring[i];
  };
  for (int trial = 0; trial < 40; ++trial) {
    Polygon changed = polygon;
    if (random.integer(0, 3) == 0) {  // a ring goes to another place on the boundary and back
      Ring& ring = changed.outer;
      const auto i = random.integer(0, static_cast<std::int64_t>(ring.size()) - 1);
      const Vec2 before = at(), behind = at();
      ring.insert(ring.begin() + i + 1, {before, point_on_a_ring(), behind});
    } else {
      Ring& hole = changed.holes.emplace_back(
          Ring{point_on_a_ring(), at(), random.integer(0, 1) == 0 ? at() : point_on_a_ring()});
      if (random.integer(0, 2) == 0) hole.push_back(at());
    }
    if (is_region(changed)) polygon = std::move(changed);
  }
  return polygon;
}

/// A world of such polygons, now and then with bounds, turned by an angle with whole coordinates, mirrored and moved.
inline World touching_world(std::uint64_t seed, std::int64_t obstacles) {
  RandomInputs random(seed);
  const std::int64_t size = random.integer(3, 9);
  constexpr std::int64_t kTurns[][2] = {{1, 0}, {3, 4}, {20, 21}, {-7, 24}};  // legs of triangles with whole sides
  const auto& turn = kTurns[random.integer(0, 3)];
  const Vec2 x{static_cast<double>(turn[0]), static_cast<double>(turn[1])};
  const Vec2 y = (random.integer(0, 1) == 0 ? 1.0 : -1.0) * perpendicular(x);
  const Vec2 offset = random.integer(0, 2) == 0 ? Vec2(1e6, -2e6) : Vec2(0, 0);
  const auto place = [&](Ring& ring) {
    for (Vec2& p : ring) p = Vec2(p.x() * x + p.y() * y + offset);
  };
  std::vector<Polygon> polygons;
  for (std::int64_t i = random.integer(1, obstacles); i > 0; --i) {
    Polygon polygon = touching_polygon(random, size);
    place(polygon.outer);
    for (Ring& hole : polygon.holes) place(hole);
    polygons.push_back(std::move(polygon));
  }
  if (random.integer(0, 3) > 0) return World(std::move(polygons));
  Ring bounds = touching_polygon(random, size).outer;
  place(bounds);
  return World(std::move(polygons), std::move(bounds));
}

}  // namespace arcway::internal::test

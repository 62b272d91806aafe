#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal::test {

/// Outlines about F: convex ones, stars, forks and bodies of up to three parts, with F on and off the body.
inline std::vector<Ring> random_footprint(RandomInputs& random) {
  std::vector<Ring> parts;
  const auto kind = random.integer(0, 4);
  if (kind == 0) {  // convex, perhaps a needle
    Ring ring = random_star(random, {0, 0}, 1.0, 1.0, static_cast<std::size_t>(random.integer(3, 8)));
    const Vec2 half(random.uniform(0.3, 1.2), std::exp(random.uniform(-4.0, 0.0)));
    for (Vec2& p : ring) p = p.cwiseProduct(half);
    parts.push_back(ring);
  } else if (kind == 1) {
    parts.push_back(random_star(random, {0, 0}, 0.2, 1.2, static_cast<std::size_t>(random.integer(4, 14))));
  } else if (kind == 2) {  // a fork
    const double tip = random.uniform(1.2, 2.0);
    parts.push_back({{-0.6, -0.5},
                     {0.6, -0.5},
                     {0.6, -0.4},
                     {tip, -0.4},
                     {tip, -0.2},
                     {0.6, -0.2},
                     {0.6, 0.2},
                     {tip, 0.2},
                     {tip, 0.4},
                     {0.6, 0.4},
                     {0.6, 0.5},
                     {-0.6, 0.5}});
  } else {
    for (std::int64_t i = 0, count = random.integer(2, 3); i < count; ++i)
      parts.push_back(random_star(random, {1.1 * static_cast<double>(i), random.uniform(-0.3, 0.3)}, 0.1, 0.5,
                                  static_cast<std::size_t>(random.integer(3, 9))));
  }
  const Vec2 shift(random.uniform(-1.5, 0.8), random.unit() < 0.5 ? 0.0 : random.uniform(-0.6, 0.6));
  const double turn = random.unit() < 0.5 ? 0.0 : random.uniform(-kPi, kPi);
  const Vec2 ahead = direction_of(turn);
  for (Ring& ring : parts)
    for (Vec2& p : ring) p = shift + p.x() * ahead + p.y() * perpendicular(ahead);
  return parts;
}

/// The default vehicle with such a body.
inline Vehicle random_body_vehicle(RandomInputs& random) {
  VehicleParameters parameters;
  parameters.footprint = random_footprint(random);
  return Vehicle(parameters);
}

/// Distance between parts that stand at a pose and the boundaries of the world, in extended precision and with no code
/// of the library: 0 if they cross, or if one contains a point of the other's boundary.
class PlacedBody {
 public:
  PlacedBody(const std::vector<Ring>& parts, const Pose& pose) : place_{pose.x, pose.y} {
    const long double c = std::cos(static_cast<long double>(pose.heading)),
                      s = std::sin(static_cast<long double>(pose.heading));
    for (const Ring& ring : parts) {
      parts_.emplace_back();
      for (const Vec2& p : ring) reach_ = std::max(reach_, std::hypot<long double>(p.x(), p.y()));
      for (const Vec2& p : ring)
        parts_.back().push_back({pose.x + c * p.x() - s * p.y(), pose.y + s * p.x() + c * p.y()});
    }
  }

  /// Distance from the boundaries of all regions, 0 in contact or around them.
  [[nodiscard]] long double distance_to(const World& world) const {
    long double least = INFINITY;
    for (const LineSegment& e : world.edges()) {
      const Point a{e.a.x(), e.a.y()}, b{e.b.x(), e.b.y()};
      if (distance(place_, a, b) - reach_ > least) continue;
      for (const auto& part : parts_) {
        if (contains(part, a)) return 0.0L;
        for (std::size_t i = 0; i < part.size(); ++i)
          least = std::min(least, distance(a, b, part[i], part[(i + 1) % part.size()]));
      }
    }
    return least;
  }
  /// Whether the first corner of any part lies in an obstacle, or out of bounds.
  [[nodiscard]] bool is_swallowed_by(const World& world) const {
    return std::ranges::any_of(parts_, [&](const auto& part) {
      for (ObstacleId o = 0; o < world.region_count(); ++o) {
        bool inside = false;
        const auto [first, last] = world.vertices_of(o);
        for (VertexId v = first; v < last; ++v) {
          const LineSegment& e = world.edges()[v];
          flip_if_crossed(part[0], {e.a.x(), e.a.y()}, {e.b.x(), e.b.y()}, inside);
        }
        if (inside != (o == world.obstacle_count())) return true;
      }
      return false;
    });
  }

 private:
  struct Point {
    long double x, y;
  };
  static long double cross(const Point& o, const Point& p, const Point& q) {
    return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
  }
  static void flip_if_crossed(const Point& p, const Point& a, const Point& b, bool& inside) {
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  static bool contains(const std::vector<Point>& part, const Point& p) {
    bool inside = false;
    for (std::size_t i = 0; i < part.size(); ++i) flip_if_crossed(p, part[i], part[(i + 1) % part.size()], inside);
    return inside;
  }
  static long double distance(const Point& p, const Point& a, const Point& b) {
    const long double ux = b.x - a.x, uy = b.y - a.y;
    const long double t = std::clamp(((p.x - a.x) * ux + (p.y - a.y) * uy) / (ux * ux + uy * uy), 0.0L, 1.0L);
    return std::hypot(a.x + t * ux - p.x, a.y + t * uy - p.y);
  }
  static long double distance(const Point& a, const Point& b, const Point& c, const Point& d) {
    if (cross(a, b, c) * cross(a, b, d) < 0 && cross(c, d, a) * cross(c, d, b) < 0) return 0.0L;
    return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
  }

  std::vector<std::vector<Point>> parts_;
  Point place_;
  long double reach_ = 0.0L;
};

}  // namespace arcway::internal::test

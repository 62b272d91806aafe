#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "arcway/angle.h"
#include "arcway/planner.h"
#include "tests/support/boxes.h"

namespace arcway::internal::test {

/// A motion of the plane: scaled, perhaps mirrored, turned, shifted.
struct Variant {
  const char* name;
  double scale, turn;
  bool mirrored;
  Vec2 shift;
  [[nodiscard]] Vec2 operator()(const Vec2& p) const {
    const Vec2 q = scale * Vec2(p.x(), mirrored ? -p.y() : p.y());
    return std::cos(turn) * q + std::sin(turn) * perpendicular(q) + shift;
  }
  [[nodiscard]] Pose operator()(const Pose& pose) const {
    const Vec2 p = (*this)(pose.position());
    return {p.x(), p.y(), (mirrored ? -pose.heading : pose.heading) + turn};
  }
};

/// As given; turned by odd angles, mirrored, moved far away, scaled.
inline std::vector<Variant> variants() {
  return {{"plain", 1.0, 0.0, false, {0.0, 0.0}},   {"turned", 1.0, 37.0 * kPi / 180.0, false, {0.0, 0.0}},
          {"mirrored", 1.0, 0.0, true, {0.0, 0.0}}, {"mirrored_and_turned", 1.0, 2.0, true, {0.0, 0.0}},
          {"moved", 1.0, 0.0, false, {1e6, -1e6}},  {"turned_and_moved", 1.0, 37.0 * kPi / 180.0, false, {-1e6, 1e6}},
          {"small", 0.1, 1.0, false, {0.0, 0.0}},   {"large", 7.0, 1.0, false, {0.0, 0.0}}};
}

/// A query that leaves the vehicle little room.
struct NarrowQuery {
  const char* name;
  VehicleParameters vehicle;
  std::vector<Ring> obstacles;
  Ring bounds;
  Pose start, goal;
};

inline Ring ring_of_box(double x0, double y0, double x1, double y1) { return box(x0, y0, x1, y1).outer; }

inline VehicleParameters car() {
  return {.length = 4.5,
          .width = 1.8,
          .wheelbase = 2.7,
          .max_steering_angle = 0.55,
          .max_speed = 2.5,
          .turn_speed = ConstantTurnSpeed{1.5},
          .max_acceleration = 1.0,
          .safety_margin = 0.01};
}

inline VehicleParameters scaled(VehicleParameters v, double by) {
  for (double* length : {&v.length, &v.width, &v.wheelbase, &v.max_speed, &v.max_acceleration, &v.safety_margin})
    *length *= by;
  v.turn_speed = ConstantTurnSpeed{by * std::get<ConstantTurnSpeed>(v.turn_speed).speed};
  return v;
}

/// The planner of a query as a variant has it.
inline Planner planner_of(const NarrowQuery& query, const Variant& variant) {
  const auto moved = [&](Ring ring) {
    std::ranges::transform(ring, ring.begin(), variant);
    if (variant.mirrored) std::ranges::reverse(ring);
    return ring;
  };
  std::vector<Polygon> obstacles;
  for (const Ring& ring : query.obstacles) obstacles.push_back({moved(ring), {}});
  return {World(std::move(obstacles), moved(query.bounds)), Vehicle(scaled(query.vehicle, variant.scale))};
}

}  // namespace arcway::internal::test

#include "core/collision/close_ends.h"

#include <algorithm>
#include <cmath>

#include "core/motion/clearance.h"

namespace arcway::internal {

namespace {

// Share that is taken off for rounding.
constexpr double kRounding = 1e-9;

// How far a point of the body moves at most while F moves by 1.
double fastest_point(const Vehicle& vehicle) {
  double fastest = 1.0;
  const Footprint body = vehicle.footprint();
  for (const Vec2& corner : Box{{-body.rear, -body.right}, {body.front, body.left}}.corners())
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const double curvature = sign_of(side) / vehicle.min_turning_radius(side);
      fastest = std::max(fastest, std::hypot(1.0 - curvature * corner.y(), curvature * corner.x()));
    }
  return fastest;
}

}  // namespace

// Many parameters because paths are between two poses in a world, and have a length.
double close_ends_cost(const ClearanceCost& cost, const Vehicle& vehicle, const Outlines& outlines, const Pose& start,
                       const Pose& goal, double length) {
  const double fastest = fastest_point(vehicle);
  const Body body = vehicle.body();
  const auto close_at = [&](const Pose& end, const ClearanceCost::Rule& rule) {
    const double inside = rule.area ? rule.area->depth_of(end.position()) : length;
    const double distance = rule.close.distance();
    const double left = distance - clearance_below(distance, {end, 0.0, 0.0}, body, outlines);
    return std::min(inside, left / fastest);
  };
  double sum = 0.0;
  for (const ClearanceCost::Rule& rule : cost.rules())
    if (rule.cost > 0.0) sum += rule.cost * std::min(length, close_at(start, rule) + close_at(goal, rule));
  return (1.0 - kRounding) * sum;
}

}  // namespace arcway::internal

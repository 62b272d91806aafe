#include "datasets/generators/drive_clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/geometry/distance.h"

namespace arcway::internal::detail {
namespace {

// Intervals of an arc shorter than this share of the body's reach are not halved again.
constexpr double kShortestInterval = 1e-6;

// The body at a pose, and what it sweeps until it is `ahead` further on in a straight line.
Polygon body_at(const Pose& pose, const Footprint& body, double ahead = 0.0) {
  const Vec2 u = direction_of(pose.heading), aside = perpendicular(u);
  const Vec2 left = aside * body.left, right = aside * body.right;
  const Vec2 front = pose.position() + u * (body.front + ahead), rear = pose.position() - u * body.rear;
  return {{rear - right, front - right, front + left, rear + left}, {}};
}

// How far a polygon must keep from a body with this reach about F.
struct Wanted {
  const Polygon& polygon;
  const Vehicle& vehicle;
  const Footprint& box;
  double reach, distance;

  [[nodiscard]] double gap_at(const Pose& pose) const {
    if (is_rectangle()) return internal::distance(body_at(pose, box), polygon);
    double least = std::numeric_limits<double>::infinity();
    for (Ring& part : vehicle.outline(pose))
      least = std::min(least, internal::distance(Polygon{std::move(part), {}}, polygon));
    return least;
  }
  [[nodiscard]] bool is_rectangle() const { return vehicle.shape() == nullptr; }
};

bool interval_keeps_away(const Wanted& wanted, const PathSegment& segment, double from, double to) {
  const double half = 0.5 * (to - from);
  const double gap = wanted.gap_at(segment.at(0.5 * (from + to)));
  const double travel = half * (1.0 + std::abs(segment.curvature) * wanted.reach);
  if (gap >= wanted.distance + travel) return true;
  if (gap < wanted.distance || travel < kShortestInterval * wanted.reach) return false;
  const double middle = from + half;
  return interval_keeps_away(wanted, segment, from, middle) && interval_keeps_away(wanted, segment, middle, to);
}

bool segment_keeps_away(const Wanted& wanted, const PathSegment& segment) {
  if (!segment.is_line() || !wanted.is_rectangle()) return interval_keeps_away(wanted, segment, 0.0, segment.length);
  const Polygon swept = body_at(segment.forwards().start, wanted.box, segment.length);
  return distance(swept, wanted.polygon) >= wanted.distance;
}

}  // namespace

bool keeps_away(const Polygon& polygon, std::span<const PathSegment> drive, const Vehicle& vehicle, double distance) {
  const Footprint box = vehicle.footprint();
  const Wanted wanted{polygon, vehicle, box, box.farthest(), distance};
  return std::ranges::all_of(drive, [&](const PathSegment& segment) { return segment_keeps_away(wanted, segment); });
}

Box box_of(std::span<const PathSegment> drive, const Footprint& body, double growth) {
  const double reach = body.farthest();
  Box box;
  for (const PathSegment& segment : drive) {
    // Pieces as long as the body reaches: nothing is further from a piece's middle than half of that and the reach.
    const double pieces = std::ceil(segment.length / reach);
    for (double i = 0.0; i < pieces; i += 1.0) {
      const Vec2 middle = segment.at(segment.length * ((i + 0.5) / pieces)).position();
      const double around = 1.5 * reach + growth;
      box.extend(middle - Vec2(around, around));
      box.extend(middle + Vec2(around, around));
    }
  }
  return box;
}

}  // namespace arcway::internal::detail

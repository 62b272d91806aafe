#include "core/path/clearance.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/distance.h"
#include "core/query/sweep_query.h"

namespace arcway {

namespace {

double gap(const Box& a, const Box& b) {
  const Vec2 d = (a.min - b.max).cwiseMax(b.min - a.max).cwiseMax(0.0);
  return d.norm();
}

Box box_of_points(std::span<const Vec2> points) {
  Box box;
  for (const Vec2& p : points) box.extend(p);
  return box;
}

// Distance of an edge to whatever `motion` describes, over all edges, nearest regions' boxes permitting.
template <class DistanceToEdge>
Clearance least(const World& world, const Box& swept, const DistanceToEdge& distance_to) {
  Clearance best;
  for (ObstacleId o = 0; o < world.region_count(); ++o) {
    // The box of the bounds surrounds everything; it never lets the region be skipped.
    if (gap(world.box_of(o), swept) >= best.distance) continue;
    const auto [first, last] = world.vertices_of(o);
    for (VertexId e = first; e < last; ++e) {
      const LineSegment& edge = world.edges()[e];
      if (gap(box_of_points({{edge.a, edge.b}}), swept) >= best.distance) continue;
      const double d = distance_to(edge);
      if (d < best.distance) best = {d, e};
    }
  }
  return best;
}

class TurningClearance {
 public:
  TurningClearance(const PathSegment& segment, const Footprint& body)
      : turn_(segment.curvature * segment.length),
        center_(segment.start.position() + perpendicular(direction_of(segment.start.heading)) / segment.curvature),
        first_(swept_rectangle(segment.start, 0.0, body)),
        last_(swept_rectangle(segment.end(), 0.0, body)) {
    reach_ = swept_annulus(body, 1.0 / std::abs(segment.curvature)).outer;
  }

  [[nodiscard]] Box box() const { return {center_ - Vec2(reach_, reach_), center_ + Vec2(reach_, reach_)}; }

  [[nodiscard]] double to(const LineSegment& edge) const {
    double least = std::min(distance(edge, first_), distance(edge, last_));
    for (const Vec2& corner : first_) least = std::min(least, distance(trace(corner, turn_), edge));
    for (std::size_t i = 0; i < 4; ++i)
      least = std::min(least, distance(trace(edge.a, -turn_), LineSegment{first_[i], first_[(i + 1) % 4]}));
    return least;
  }

 private:
  [[nodiscard]] CircularArc trace(const Vec2& p, double turn) const {
    const Vec2 r = p - center_;
    return {center_, r.norm(), std::atan2(r.y(), r.x()), turn};
  }

  double turn_;
  Vec2 center_;
  SweptRectangle first_, last_;
  double reach_;
};

}  // namespace

Clearance clearance_along(const PathSegment& segment, const Footprint& body, const World& world) {
  if (segment.is_line()) {
    const SweptRectangle swept = swept_rectangle(segment.start, segment.length, body);
    return least(world, box_of_points(swept), [&](const LineSegment& edge) { return distance(edge, swept); });
  }
  const TurningClearance turning(segment, body);
  return least(world, turning.box(), [&](const LineSegment& edge) { return turning.to(edge); });
}

}  // namespace arcway

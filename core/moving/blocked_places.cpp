#include "core/moving/blocked_places.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "arcway/angle.h"
#include "core/geometry/convex_hull.h"
#include "core/geometry/convex_pieces.h"

namespace arcway::internal {
namespace {

constexpr double kHullExcess = 0.25;  // of the safety margin: how far hulls of arcs may reach beyond what is swept
constexpr double kNarrowestPiece = 1e-3, kWidestPiece = 0.1;  // of an arc [rad]

// The half-plane of the points x with normal.x <= most.
struct HalfPlane {
  Vec2 normal;
  double most;
};

double support(std::span<const Vec2> points, const Vec2& direction) {
  double most = -INFINITY;
  for (const Vec2& p : points) most = std::max(most, p.dot(direction));
  return most;
}

void add_sides(std::span<const Vec2> polygon, double sign, std::vector<Vec2>& normals) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 side = polygon[(i + 1) % polygon.size()] - polygon[i];
    if (side.squaredNorm() > 0.0) normals.push_back(-sign * perpendicular(side).normalized());
  }
}

// Where a point may be so that a convex polygon about it touches another one; grown by `growth`.
std::vector<HalfPlane> touching(std::span<const Vec2> obstacle, std::span<const Vec2> body, double growth) {
  std::vector<Vec2> normals;
  add_sides(obstacle, 1.0, normals);
  add_sides(body, -1.0, normals);
  std::vector<HalfPlane> planes;
  planes.reserve(normals.size());
  for (const Vec2& n : normals) planes.push_back({n, support(obstacle, n) + support(body, -n) + growth});
  return planes;
}

// What of a convex polygon lies in the half-plane.
std::vector<Vec2> clipped(const std::vector<Vec2>& polygon, const HalfPlane& plane) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double over_a = a.dot(plane.normal) - plane.most, over_b = b.dot(plane.normal) - plane.most;
    if (over_a <= 0.0) kept.push_back(a);
    if ((over_a < 0.0 && over_b > 0.0) || (over_a > 0.0 && over_b < 0.0))
      kept.push_back(a + (b - a) * (over_a / (over_a - over_b)));
  }
  return kept;
}

// The body's convex pieces about F.
std::vector<Ring> pieces_of(const Vehicle& vehicle) {
  const Body body = vehicle.body(0.5 * vehicle.safety_margin());
  if (body.shape != nullptr) return body.shape->pieces;
  return {Polygon::rectangle({-body.rear, -body.right}, {body.front, body.left}).outer};
}

// Turned by the heading about F at the origin.
Ring turned(const Ring& piece, double heading) {
  const Vec2 ahead = direction_of(heading);
  Ring ring;
  for (const Vec2& p : piece) ring.push_back(p.x() * ahead + p.y() * perpendicular(ahead));
  return ring;
}

class Blocked {
 public:
  Blocked(const Vehicle& vehicle, std::span<const MovingObstacle> obstacles, double horizon)
      : vehicle_(vehicle), pieces_(pieces_of(vehicle)), horizon_(horizon) {
    for (const MovingObstacle& o : obstacles) {
      Ring ring = o.outline;
      if (winding(ring) < 0) std::reverse(ring.begin(), ring.end());
      obstacles_.push_back({&o, convex_pieces(without_straight_corners(ring))});
    }
  }

  // @param before  arc length at the segment's start.
  void add(const PathSegment& segment, double before) {
    for (const Parts& obstacle : obstacles_)
      for (const Ring& part : obstacle.parts)
        for (const Ring& piece : pieces_)
          segment.is_line() ? add_line(segment, before, *obstacle.moving, part, piece)
                            : add_arc(segment, before, *obstacle.moving, part, piece);
  }
  std::vector<BlockedPlaces> take() && { return std::move(found_); }

 private:
  struct Parts {
    const MovingObstacle* moving;
    std::vector<Ring> parts;
  };

  void add_line(const PathSegment& line, double before, const MovingObstacle& moving, const Ring& part,
                const Ring& piece) {
    const double begin = std::max(0.0, moving.from), end = std::min(horizon_, moving.until);
    if (!(begin <= end)) return;
    const Vec2 along = sign_of(line.gear) * direction_of(line.start.heading);
    std::vector<Vec2> places{{0.0, begin}, {line.length, begin}, {line.length, end}, {0.0, end}};
    for (const auto& [normal, most] : touching(part, turned(piece, line.start.heading), 0.0)) {
      // normal . (start + along s - velocity t) <= most.
      const Vec2 by_place(normal.dot(along), -normal.dot(moving.velocity));
      places = clipped(places, {by_place, most - normal.dot(line.start.position())});
      if (places.empty()) return;
    }
    keep(std::move(places), before);
  }

  void add_arc(const PathSegment& arc, double before, const MovingObstacle& moving, const Ring& part,
               const Ring& piece) {
    const double radius = 1.0 / std::abs(arc.curvature), turn = arc.length / radius;
    const Vec2 center(0.0, arc.curvature > 0.0 ? radius : -radius);
    double farthest = 0.0;
    for (const Vec2& p : piece) farthest = std::max(farthest, (p - center).norm());
    const double excess = std::min(1.0, kHullExcess * vehicle_.safety_margin() / farthest);
    const double widest = std::clamp(2.0 * std::acos(1.0 - excess), kNarrowestPiece, kWidestPiece);
    const auto count = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(turn / widest)));
    const double height = farthest * (1.0 - std::cos(0.5 * turn / static_cast<double>(count)));
    const auto place = [&](std::size_t i) {
      return arc.length * (static_cast<double>(i) / static_cast<double>(count));
    };
    for (std::size_t i = 0; i < count; ++i) {
      const double from = place(i), to = place(i + 1);
      Ring corners;
      for (const double s : {from, to}) {
        const Pose pose = arc.at(s);
        for (const Vec2& p : turned(piece, pose.heading)) corners.push_back(pose.position() + p);
      }
      replace_by_hull(corners);
      double begin = std::max(0.0, moving.from), end = std::min(horizon_, moving.until);
      // The hull stands about the origin: normal . (-velocity t) <= most.
      for (const auto& [normal, most] : touching(part, corners, height)) {
        const double rate = -normal.dot(moving.velocity);
        if (rate > 0.0) end = std::min(end, most / rate);
        if (rate < 0.0) begin = std::max(begin, most / rate);
        if (rate == 0.0 && most < 0.0) end = -INFINITY;
      }
      if (begin <= end) keep({{from, begin}, {to, begin}, {to, end}, {from, end}}, before);
    }
  }

  void keep(std::vector<Vec2> corners, double before) {
    BlockedPlaces places{std::move(corners), INFINITY, -INFINITY};
    for (Vec2& p : places.corners) {
      p.x() += before;
      places.first = std::min(places.first, p.x());
      places.last = std::max(places.last, p.x());
    }
    found_.push_back(std::move(places));
  }

  const Vehicle& vehicle_;
  std::vector<Ring> pieces_;
  double horizon_;
  std::vector<Parts> obstacles_;
  std::vector<BlockedPlaces> found_;
};

}  // namespace

std::vector<BlockedPlaces> blocked_places(std::span<const PathSegment> path, const Vehicle& vehicle,
                                          std::span<const MovingObstacle> obstacles, double horizon) {
  Blocked blocked(vehicle, obstacles, horizon);
  double before = 0.0;
  for (const PathSegment& segment : path) {
    blocked.add(segment, before);
    before += segment.length;
  }
  return std::move(blocked).take();
}

}  // namespace arcway::internal

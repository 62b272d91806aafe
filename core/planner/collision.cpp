#include "core/planner/collision.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "arcway/angle.h"
#include "core/gaps/bottleneck_finder.h"
#include "core/model/pose_text.h"

namespace arcway::internal {
namespace {

constexpr int kTurns = 24, kDirections = 24, kCircles = 16;
constexpr int kRingHalvings = 15;  // number of bisections of the step between two circles: to a 30,000th

// The part of the segment a + t (b - a) inside the box |x| <= half.x, |y| <= half.y: the two values of t.
std::optional<std::pair<double, double>> clip(const Vec2& a, const Vec2& b, const Vec2& half) {
  double first = 0.0, last = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double from = a[axis], along = b[axis] - a[axis];
    if (along == 0.0) {
      if (std::abs(from) > half[axis]) return std::nullopt;
      continue;
    }
    const double low = (-half[axis] - from) / along, high = (half[axis] - from) / along;
    first = std::max(first, std::min(low, high));
    last = std::min(last, std::max(low, high));
  }
  if (first > last) return std::nullopt;
  return std::pair(first, last);
}

// The part of a segment inside a convex polygon, counter-clockwise.
std::optional<std::pair<double, double>> clip(const LineSegment& s, std::span<const Vec2> polygon) {
  double first = 0.0, last = 1.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &corner = polygon[i], along = polygon[(i + 1) % polygon.size()] - corner;
    const double from = cross(along, s.a - corner), to = cross(along, s.b - corner);
    if (from < 0.0 && to < 0.0) return std::nullopt;
    if (from < 0.0) first = std::max(first, from / (from - to));
    if (to < 0.0) last = std::min(last, from / (from - to));
  }
  if (first > last) return std::nullopt;
  return std::pair(first, last);
}

bool is_free(const SweepQuery& sweep, const Body& body, const Pose& pose) {
  return sweep.straight_free({pose, 0.0, body});
}

// The free pose at the same position with the smallest turn, to the left before the right.
std::optional<FreePose> free_turn(const SweepQuery& sweep, const Body& body, const Pose& pose) {
  const double reach = body.farthest();
  for (int turn = 1; turn < kTurns; ++turn) {
    const int steps = (turn + 1) / 2;
    const double angle = (turn % 2 == 1 ? 1.0 : -1.0) * steps * (kTwoPi / kTurns);
    const Pose turned{pose.x, pose.y, wrap_signed(pose.heading + angle)};
    if (is_free(sweep, body, turned)) return FreePose{turned, 0.0, reach * std::abs(angle)};
  }
  return std::nullopt;
}

// The nearest free pose of the same heading on the smallest circle with free poses, each moved inwards by bisection.
std::optional<FreePose> free_move(const SweepQuery& sweep, const Body& body, const Pose& pose) {
  const double step = free_pose_reach(body) / kCircles;
  std::optional<FreePose> nearest;
  for (int circle = 1; circle <= kCircles && !nearest; ++circle) {
    for (int i = 0; i < kDirections; ++i) {
      const Vec2 direction = direction_of(pose.heading + i * (kTwoPi / kDirections));
      const auto at = [&](double distance) {
        const Vec2 p = pose.position() + distance * direction;
        return Pose{p.x(), p.y(), pose.heading};
      };
      double near = (circle - 1) * step, far = circle * step;
      if (!is_free(sweep, body, at(far))) continue;
      for (int k = 0; k < kRingHalvings; ++k) {
        const double middle = 0.5 * (near + far);
        (is_free(sweep, body, at(middle)) ? far : near) = middle;
      }
      if (!nearest || far < nearest->distance) nearest = FreePose{at(far), far, far};
    }
  }
  return nearest;
}

}  // namespace

std::optional<Collision> contact_of(const World& world, const Outlines& outlines, const DistanceQuery& distance,
                                    const Body& body, const Pose& pose) {
  const Vec2 middle = middle_of(body, pose), ahead = direction_of(pose.heading), aside = perpendicular(ahead);
  const Vec2 half(0.5 * body.length(), 0.5 * body.width());
  const auto in_body = [&](const Vec2& p) { return Vec2((p - middle).dot(ahead), (p - middle).dot(aside)); };
  VertexId nearest = kNone;
  double least = std::numeric_limits<double>::infinity();
  Vec2 point = middle;
  const auto look_at_part = [&](VertexId v, const LineSegment& edge,
                                const std::optional<std::pair<double, double>>& part) {
    if (!part) return;
    const auto& [from, to] = edge;
    const Vec2 a = in_body(from), b = in_body(to), along = b - a;
    const double length2 = along.squaredNorm();
    const double t = length2 > 0.0 ? std::clamp(-a.dot(along) / length2, part->first, part->second) : part->first;
    const double away = (a + t * along).norm();
    if (away > least || (away == least && v > nearest)) return;
    least = away;
    nearest = v;
    point = from + t * (to - from);
  };
  const Vec2 offset(0.5 * (body.front - body.rear), 0.5 * (body.left - body.right));
  const auto look_at = [&](VertexId v, const Vec2& from, const Vec2& to) {
    const Vec2 a = in_body(from), b = in_body(to);
    if (body.shape == nullptr) return look_at_part(v, {from, to}, clip(a, b, half));
    for (const Ring& piece : body.shape->pieces) look_at_part(v, {from, to}, clip({a + offset, b + offset}, piece));
  };
  // Twice as far as the body reaches, so that rounding leaves no edge out.
  const Vec2 far = Vec2::Constant(2.0 * half.norm());
  const Box near{middle - far, middle + far};
  outlines.visit_if([&](const Box& box) { return box.overlaps(near); },
                    [&](const Outlines::Piece& piece) {
                      for (std::size_t i = 0; i < piece.edge_count(); ++i)
                        look_at(piece.first + static_cast<VertexId>(i), piece.points[i], piece.points[i + 1]);
                      return true;
                    });
  if (nearest != kNone) return Collision{world.obstacle_of(nearest), point};
  const auto inside_of = [&](const Vec2& p) {
    const ObstacleId inside = distance.containing(p);
    return inside == kNone ? std::nullopt : std::optional(Collision{inside, p});
  };
  if (body.shape == nullptr) return inside_of(middle);
  for (const Vec2& p : body.shape->inner_points)
    if (auto inside = inside_of(pose.position() + p.x() * ahead + p.y() * aside)) return inside;
  return std::nullopt;
}

double free_pose_reach(const Footprint& body) { return 2.0 * std::hypot(body.length(), body.width()); }

std::optional<FreePose> nearest_free_pose(const SweepQuery& sweep, const Body& body, const Pose& pose) {
  const auto turned = free_turn(sweep, body, pose), moved = free_move(sweep, body, pose);
  return !turned || (moved && moved->travel < turned->travel) ? moved : turned;
}

std::string collision_text(const World& world, const Outlines& outlines, const QuerySet& queries, const Body& body,
                           const Pose& pose) {
  std::string text = "collides";
  if (const auto contact = contact_of(world, outlines, *queries.distance, body, pose))
    text += " with " + region_text(world, contact->region) + " at (" + rounded_text(contact->point.x()) + ", " +
            rounded_text(contact->point.y()) + ")";
  if (const auto free = nearest_free_pose(*queries.sweep, body, pose))
    return text + "; the nearest free pose found is " + shortest_text(free->pose) +
           (free->distance > 0.0 ? ", " + rounded_text(free->distance) + " m away" : ", in the same place");
  return text + "; no free pose was found within " + rounded_text(free_pose_reach(body)) + " m";
}

}  // namespace arcway::internal

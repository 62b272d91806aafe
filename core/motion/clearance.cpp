#include "core/motion/clearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "arcway/angle.h"
#include "core/geometry/closest_pair.h"
#include "core/geometry/distance.h"

namespace arcway::internal {
namespace {

struct Frame {
  explicit Frame(const Pose& pose) : origin(pose.position()), axis(direction_of(pose.heading)) {}
  [[nodiscard]] Vec2 operator()(const Vec2& p) const {
    const Vec2 d = p - origin;
    return {axis.dot(d), cross(axis, d)};
  }
  [[nodiscard]] LineSegment operator()(const LineSegment& s) const { return {(*this)(s.a), (*this)(s.b)}; }
  Vec2 origin;
  Vec2 axis;
};

/// A distance and where along the motion it occurs.
struct Near {
  double distance = std::numeric_limits<double>::infinity();
  double at = 0.0;
  void lower(double other_distance, double other_at) {
    if (other_distance < distance) *this = {other_distance, other_at};
  }
};

/// Distance of an edge to a rectangle, and the x of the rectangle where it occurs.
Near to_rectangle(const Box& r, const LineSegment& e) {
  const Vec2 u = e.b - e.a;
  // The part of the edge inside, by clipping.
  double t0 = 0.0;
  double t1 = 1.0;
  for (Eigen::Index k = 0; k < 2; ++k) {
    if (u[k] == 0.0) {
      if (e.a[k] < r.min[k] || e.a[k] > r.max[k]) t1 = -1.0;
      continue;
    }
    const double in = ((u[k] > 0.0 ? r.min[k] : r.max[k]) - e.a[k]) / u[k];
    const double out = ((u[k] > 0.0 ? r.max[k] : r.min[k]) - e.a[k]) / u[k];
    t0 = std::max(t0, in);
    t1 = std::min(t1, out);
  }
  if (t0 <= t1) return {0.0, std::min(e.a.x() + t0 * u.x(), e.a.x() + t1 * u.x())};
  Near near;
  for (const Vec2& p : {e.a, e.b}) {
    const Vec2 q = r.closest_point(p);
    near.lower((p - q).norm(), q.x());
  }
  for (const Vec2& corner : r.corners()) {
    const double t = std::clamp((corner - e.a).dot(u) / u.squaredNorm(), 0.0, 1.0);
    near.lower((e.a + t * u - corner).norm(), corner.x());
  }
  return near;
}

/// Distance of an edge to a convex polygon.
double distance_to(std::span<const Vec2> polygon, const LineSegment& e) {
  double least = std::numeric_limits<double>::infinity();
  bool is_inside = true;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const LineSegment side{polygon[i], polygon[(i + 1) % polygon.size()]};
    least = std::min(least, distance(side, e));
    is_inside = is_inside && cross(side.b - side.a, e.a - side.a) >= 0.0;
  }
  return is_inside ? 0.0 : least;
}

/// The least distance of a point that turns about a center from a segment, without the ends of its arc. It occurs at
/// the foot of the perpendicular from the center, at a crossing, or radially at an end of the segment.
/// @param spin  +1 counter-clockwise, -1 clockwise.
/// @param turn  angle of the arc [rad].
Near turning_point(const Vec2& center, const Vec2& point, double spin, double turn, const LineSegment& s) {
  const Vec2 arm = point - center;
  const double radius = arm.norm();
  Near near;
  const auto consider = [&](const Vec2& place) {
    const Vec2 d = place - center;
    const double angle = wrap_positive(spin * std::atan2(cross(arm, d), arm.dot(d)));
    if (angle <= turn) near.lower(std::abs(d.norm() - radius), angle);
  };
  consider(s.a);
  consider(s.b);
  const Vec2 u = s.b - s.a;
  const double square = u.squaredNorm();
  const double foot = (center - s.a).dot(u) / square;
  const Vec2 perpendicular_foot = s.a + foot * u;
  const double depth = radius * radius - (perpendicular_foot - center).squaredNorm();
  if (depth <= 0.0) {
    if (foot > 0.0 && foot < 1.0) consider(perpendicular_foot);
    return near;
  }
  const double offset = std::sqrt(depth / square);
  for (const double t : {foot - offset, foot + offset}) {
    if (t < 0.0 || t > 1.0) continue;
    const Vec2 d = s.a + t * u - center;
    const double angle = wrap_positive(spin * std::atan2(cross(arm, d), arm.dot(d)));
    if (angle <= turn) near.lower(0.0, angle);  // a crossing: exactly 0
  }
  return near;
}

/// The motion of the body, seen from its start pose.
class Motion {
 public:
  Motion(const PathSegment& segment, const Body& body)
      : segment_(segment),
        shape_(body.shape),
        body_{{-body.rear, -body.right}, {body.front, body.left}},
        start_(segment.start),
        end_(segment.end()),
        swept_box_(swept_box()) {}

  [[nodiscard]] Box swept_box() const {
    Box box;
    if (segment_.is_line()) {
      for (const Vec2& corner : Box{body_.min, {body_.max.x() + segment_.length, body_.max.y()}}.corners()) {
        box.extend(Vec2(start_.origin + corner.x() * start_.axis + corner.y() * perpendicular(start_.axis)));
      }
      return box;
    }
    double reach = 0.0;
    for (const Vec2& corner : body_.corners()) reach = std::max(reach, corner.norm());
    reach += 0.5 * segment_.length;
    const Vec2 middle = segment_.at(0.5 * segment_.length).position();
    return Box{middle, middle}.grown(reach);
  }

  /// No point of a box is nearer. For a line by the box in its frame: that of a long oblique one is mostly empty space.
  [[nodiscard]] double distance_at_least(const Box& box) const {
    if (!segment_.is_line()) return swept_box_.distance_to(box);
    const Vec2 middle = start_(Vec2(0.5 * (box.min + box.max)));
    const Vec2 half = 0.5 * (box.max - box.min);
    const Vec2 axis = start_.axis.cwiseAbs();
    const Vec2 extent(axis.dot(half), axis.x() * half.y() + axis.y() * half.x());
    const Vec2 front(body_.max.x() + segment_.length, body_.max.y());
    return Box{body_.min, front}.distance_to(Box{middle - extent, middle + extent});
  }

  /// Distance to an edge, and the arc length.
  [[nodiscard]] Near nearest(const LineSegment& edge) const {
    const LineSegment e = start_(edge);
    if (shape_ != nullptr) {
      Near near;
      for (const Ring& piece : shape_->pieces) lower_by_piece(piece, e, end_(edge), near);
      return near;
    }
    if (segment_.is_line()) {
      const Near near = to_rectangle({body_.min, {body_.max.x() + segment_.length, body_.max.y()}}, e);
      return {near.distance, std::clamp(near.at - body_.max.x(), 0.0, segment_.length)};
    }
    Near near{to_rectangle(body_, e).distance, 0.0};
    near.lower(to_rectangle(body_, end_(edge)).distance, segment_.length);
    lower_on_arc(body_.corners(), e, near);
    return near;
  }

 private:
  // By the corners of the body on their circles, and by the ends of the edge on theirs.
  void lower_on_arc(std::span<const Vec2> corners, const LineSegment& e, Near& near) const {
    const double spin = segment_.curvature > 0.0 ? 1.0 : -1.0;
    const double turn = std::min(kTwoPi, std::abs(segment_.curvature) * segment_.length);
    const Vec2 center(0.0, 1.0 / segment_.curvature);
    const auto take = [&](const Near& other) { near.lower(other.distance, other.at / std::abs(segment_.curvature)); };
    for (std::size_t k = 0; k < corners.size(); ++k) {
      take(turning_point(center, corners[k], spin, turn, e));
      const LineSegment side{corners[k], corners[(k + 1) % corners.size()]};
      take(turning_point(center, e.a, -spin, turn, side));  // seen from the body, the world turns the other way
      take(turning_point(center, e.b, -spin, turn, side));
    }
  }

  // By the corners of the body on their ways, and by the ends of the edge on theirs, which lead backwards.
  void lower_on_line(std::span<const Vec2> corners, const LineSegment& e, Near& near) const {
    const Vec2 way(segment_.length, 0.0);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec2 &corner = corners[k], &next = corners[(k + 1) % corners.size()];
      const ClosestPair ahead = closest_pair({corner, corner + way}, e);
      near.lower(ahead.distance, ahead.a.x() - corner.x());
      for (const Vec2& p : {e.a, e.b}) {
        const ClosestPair back = closest_pair({p, p - way}, {corner, next});
        near.lower(back.distance, p.x() - back.a.x());
      }
    }
  }

  // By a convex piece of the shape.
  // @param at_end  the edge, seen from the end of the motion.
  void lower_by_piece(std::span<const Vec2> piece, const LineSegment& e, const LineSegment& at_end, Near& near) const {
    near.lower(distance_to(piece, e), 0.0);
    near.lower(distance_to(piece, at_end), segment_.length);
    segment_.is_line() ? lower_on_line(piece, e, near) : lower_on_arc(piece, e, near);
  }

  PathSegment segment_;
  const GrownBody* shape_;
  Box body_;
  Frame start_;
  Frame end_;
  Box swept_box_;
};

}  // namespace

Clearance clearance_along(const PathSegment& segment, const Body& body, const World& world) {
  if (segment.gear == Gear::kReverse) {
    Clearance clearance = clearance_along(segment.reversed(), body, world);
    clearance.arc_length = segment.length - clearance.arc_length;
    return clearance;
  }
  const Motion motion(segment, body);
  const Box swept = motion.swept_box();
  Clearance best;
  const auto visit = [&](ObstacleId region) {
    const auto [first, last] = world.vertices_of(region);
    for (VertexId v = first; v < last; ++v) {
      const LineSegment& edge = world.edges()[v];
      if (swept.distance_to(box_of(edge)) >= best.distance) continue;
      const Near near = motion.nearest(edge);
      if (near.distance < best.distance) best = {near.distance, near.at, v};
    }
  };
  // The obstacle with the nearest box first: it rules out most others.
  ObstacleId likely = kNone;
  double least = std::numeric_limits<double>::infinity();
  for (ObstacleId o = 0; o < world.region_count(); ++o) {
    const double distance = swept.distance_to(world.box_of(o));
    if (distance < least) {
      least = distance;
      likely = o;
    }
  }
  if (likely == kNone) return best;
  visit(likely);
  for (ObstacleId o = 0; o < world.region_count(); ++o) {
    if (o != likely && swept.distance_to(world.box_of(o)) < best.distance) visit(o);
  }
  return best;
}

double clearance_below(double limit, const PathSegment& segment, const Body& body, const Outlines& outlines) {
  const Motion motion(segment.gear == Gear::kReverse ? segment.reversed() : segment, body);
  const auto is_near = [&](const Box& box) { return motion.distance_at_least(box) < limit; };
  outlines.visit_if(is_near, [&](const Outlines::Piece& piece) {
    for (std::size_t i = 0; i < piece.edge_count(); ++i) {
      const LineSegment edge{piece.points[i], piece.points[i + 1]};
      if (is_near(box_of(edge))) limit = std::min(limit, motion.nearest(edge).distance);
    }
    return true;
  });
  return limit;
}

}  // namespace arcway::internal

#include "core/validate/motion_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

#include "core/base/infinity.h"

namespace arcway::internal {
namespace {
/// Share of the body's reach. An interval in which every body point travels less than this, and which is not proved
/// free, is a collision.
constexpr double kShortestTravel = 1e-9;
/// Share of an arc's length: shorter intervals cannot be halved reliably.
constexpr double kShortestInterval = 4.0 * std::numeric_limits<double>::epsilon();
constexpr int kHalvings = 50;  ///< number of bisections for the place of a contact on a line
constexpr double kClearanceTolerance = 1e-6,
                 kClearanceShare = 1e-7;  ///< error of the clearance: [m], or as a share of the body's reach

using Rectangle = MotionCheck::Rectangle;
using Ends = MotionCheck::Ends;

double point_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 u = b - a;
  const double square = u.squaredNorm();
  const double t = square > 0.0 ? std::clamp((p - a).dot(u) / square, 0.0, 1.0) : 0.0;
  return (a + t * u - p).norm();
}

/// The part [t0, t1] of a -> b inside the rectangle, by clipping at its four sides; nothing if t0 > t1.
std::pair<double, double> clip(const Rectangle& r, const Vec2& a, const Vec2& b) {
  double t0 = 0.0;
  double t1 = 1.0;
  const auto side = [&t0, &t1](double from, double to) {  // keeps where from + t (to - from) >= 0
    if (from < 0.0 && to < 0.0) {
      t1 = -1.0;
    } else if (from < 0.0) {
      t0 = std::max(t0, from / (from - to));
    } else if (to < 0.0) {
      t1 = std::min(t1, from / (from - to));
    }
  };
  side(a.x() - r.x0, b.x() - r.x0);
  side(r.x1 - a.x(), r.x1 - b.x());
  side(a.y() - r.y0, b.y() - r.y0);
  side(r.y1 - a.y(), r.y1 - b.y());
  return {t0, t1};
}

double segment_to_rectangle(const Rectangle& r, const Vec2& a, const Vec2& b) {
  const auto [t0, t1] = clip(r, a, b);
  if (t0 <= t1) return 0.0;
  double distance = std::min(r.distance_to(a), r.distance_to(b));
  for (const Vec2& corner : {Vec2(r.x0, r.y0), Vec2(r.x1, r.y0), Vec2(r.x1, r.y1), Vec2(r.x0, r.y1)}) {
    distance = std::min(distance, point_to_segment(corner, a, b));
  }
  return distance;
}

bool in_triangle(const Vec2& p, const Vec2& a, const Vec2& b, const Vec2& c) {
  const double u = cross(b - a, p - a);
  const double v = cross(c - b, p - b);
  const double w = cross(a - c, p - c);
  return (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
}

bool in_hull(const Vec2& p, const std::array<Vec2, 4>& q) {
  return in_triangle(p, q[0], q[1], q[2]) || in_triangle(p, q[0], q[1], q[3]) || in_triangle(p, q[0], q[2], q[3]) ||
         in_triangle(p, q[1], q[2], q[3]);
}

/// Distance of a rectangle to the convex hull of four points.
double hull_to_rectangle(const Rectangle& r, const std::array<Vec2, 4>& q) {
  if (in_hull(Vec2(r.x0, r.y0), q)) return 0.0;
  double distance = kInfinity;  // the six joins contain the hull's sides
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) distance = std::min(distance, segment_to_rectangle(r, q[i], q[j]));
  }
  return distance;
}

/// Calls visit(from, to) for each side of a ring.
template <typename Visit>
void for_sides(const std::vector<Vec2>& ring, const Visit& visit) {
  for (std::size_t i = 0, last = ring.size() - 1; i < ring.size(); last = i++) visit(ring[last], ring[i]);
}

bool in_ring(const Vec2& p, const std::vector<Vec2>& ring) {
  bool inside = false;
  for_sides(ring, [&](const Vec2& a, const Vec2& b) {
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      inside = !inside;
  });
  return inside;
}

double segment_to_segment(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double from_a = cross(d - c, a - c), from_b = cross(d - c, b - c);
  const double from_c = cross(b - a, c - a), from_d = cross(b - a, d - a);
  if (from_a * from_b < 0.0 && from_c * from_d < 0.0) return 0.0;
  return std::min(
      {point_to_segment(a, c, d), point_to_segment(b, c, d), point_to_segment(c, a, b), point_to_segment(d, a, b)});
}

double segment_to_ring(const std::vector<Vec2>& ring, const Vec2& a, const Vec2& b) {
  if (in_ring(a, ring)) return 0.0;
  double distance = kInfinity;
  for_sides(ring, [&](const Vec2& c, const Vec2& d) { distance = std::min(distance, segment_to_segment(a, b, c, d)); });
  return distance;
}

/// A point in a ring: the middle of the first chord at a height between its lowest two.
Vec2 point_in(const std::vector<Vec2>& ring) {
  double low = kInfinity, next = kInfinity;
  for (const Vec2& p : ring) low = std::min(low, p.y());
  for (const Vec2& p : ring)
    if (p.y() > low) next = std::min(next, p.y());
  const double y = 0.5 * (low + next);
  std::vector<double> crossings;
  for_sides(ring, [&](const Vec2& a, const Vec2& b) {
    if ((a.y() > y) != (b.y() > y)) crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  });
  std::sort(crossings.begin(), crossings.end());
  return {0.5 * (crossings[0] + crossings[1]), y};
}

/// World coordinates seen from a pose.
struct Frame {
  explicit Frame(const Pose& pose) : origin(pose.position()), axis(direction_of(pose.heading)) {}
  [[nodiscard]] Vec2 operator()(const Vec2& p) const {
    const Vec2 d = p - origin;
    return {axis.dot(d), cross(axis, d)};
  }
  [[nodiscard]] Ends operator()(const LineSegment& edge) const { return {(*this)(edge.a), (*this)(edge.b)}; }
  Vec2 origin;
  Vec2 axis;
};

Box box_of(const Ends& ends) { return {ends.a.cwiseMin(ends.b), ends.a.cwiseMax(ends.b)}; }
Box box_of(const Ends& first, const Ends& second) {
  const Box one = box_of(first), two = box_of(second);
  return {one.min.cwiseMin(two.min), one.max.cwiseMax(two.max)};
}

}  // namespace

double MotionCheck::Rectangle::distance_to(const Vec2& p) const {
  const double dx = std::max({x0 - p.x(), 0.0, p.x() - x1});
  const double dy = std::max({y0 - p.y(), 0.0, p.y() - y1});
  return std::hypot(dx, dy);
}

double MotionCheck::Rectangle::gap_to(const Box& box) const {
  return std::max({x0 - box.max.x(), box.min.x() - x1, y0 - box.max.y(), box.min.y() - y1, 0.0});
}

MotionCheck::MotionCheck(const World& world, const EdgeGrid& grid, const Vehicle& vehicle)
    : world_(world), grid_(grid), upper_(kInfinity), lower_(kInfinity) {
  const VehicleParameters& p = vehicle.parameters();
  const double shift = p.steering == Steering::kSymmetric ? 0.0 : 0.5 * p.wheelbase;
  const double ahead = p.steering == Steering::kRear ? -shift : shift;  // from F to the body's center
  const double axle = 0.5 * p.wheelbase;
  const double x0 = p.rear_overhang ? -axle - *p.rear_overhang : -0.5 * p.length;
  const double x1 = p.front_overhang ? axle + *p.front_overhang : 0.5 * p.length;
  body_ = {ahead + x0, ahead + x1, -0.5 * p.width, 0.5 * p.width};
  inner_points_ = {Vec2(0.5 * (body_.x0 + body_.x1), 0.0)};
  if (!p.footprint.empty()) read_footprint(p);
  reach_ =
      std::hypot(std::max(std::abs(body_.x0), std::abs(body_.x1)), std::max(std::abs(body_.y0), std::abs(body_.y1)));
  if (!world.box().empty())
    largest_ = std::max(world.box().min.cwiseAbs().maxCoeff(), world.box().max.cwiseAbs().maxCoeff());
  set_precision();
}

void MotionCheck::read_footprint(const VehicleParameters& p) {
  Box box;
  inner_points_.clear();
  for (const Ring& ring : p.footprint) {
    std::vector<Vec2> part;
    for (const Vec2& corner : ring) part.push_back(corner + p.footprint_origin);
    for (const Vec2& corner : part) box.extend(corner);
    inner_points_.push_back(point_in(part));
    parts_.push_back(std::move(part));
  }
  body_ = {box.min.x(), box.max.x(), box.min.y(), box.max.y()};
}

/// Distance of an edge, seen from the body.
double MotionCheck::distance_to_body(const Vec2& a, const Vec2& b) const {
  if (parts_.empty()) return segment_to_rectangle(body_, a, b);
  double distance = kInfinity;
  for (const auto& ring : parts_) distance = std::min(distance, segment_to_ring(ring, a, b));
  return distance;
}

/// Distance of the convex hull of four points, seen from the body.
double MotionCheck::hull_to_body(const std::array<Vec2, 4>& hull) const {
  if (parts_.empty()) return hull_to_rectangle(body_, hull);
  double distance = kInfinity;
  for (const auto& ring : parts_) {
    if (in_hull(ring.front(), hull)) return 0.0;
    for (std::size_t i = 0; i < 4; ++i)  // the six joins contain the hull's sides
      for (std::size_t j = i + 1; j < 4; ++j) distance = std::min(distance, segment_to_ring(ring, hull[i], hull[j]));
  }
  return distance;
}

void MotionCheck::set_precision() {
  rounding_ = 16.0 * std::numeric_limits<double>::epsilon() * (largest_ + std::max(1.0, largest_heading_) * reach_);
  shortest_travel_ = std::max(kShortestTravel * reach_, rounding_);
  tolerance_ = std::max({kClearanceTolerance, kClearanceShare * reach_, 2.0 * rounding_});
}

std::vector<MotionCheck::Hit> MotionCheck::check(const PathSegment& segment) {
  for (const Pose& pose : {segment.start, segment.end()}) {
    largest_ = std::max(largest_, pose.position().cwiseAbs().maxCoeff());
    largest_heading_ = std::max(largest_heading_, std::abs(pose.heading));
  }
  set_precision();
  std::vector<Hit> hits;
  if (!is_near_last_end(segment.start))
    if (const auto region = swallowing(segment.start)) hits.push_back({*region, 0.0, kNone});
  last_end_ = segment.end();
  if (upper_ == kInfinity) upper_ = body_distance(segment.start);
  if (segment.is_line()) {
    check_line(segment, hits);
  } else {
    check_arc(segment, hits);
  }
  if (!hits.empty()) upper_ = lower_ = 0.0;
  return hits;
}

double MotionCheck::clearance() const { return std::max(0.0, lower_); }

/// From the edges near by, in wider and wider surroundings.
double MotionCheck::body_distance(const Pose& pose) const {
  const Frame frame(pose);
  const Box around = Box{frame.origin, frame.origin}.grown(reach_);
  double distance = kInfinity;
  double wide = std::max(grid_.cell(), reach_);
  if (!grid_.edges().empty()) wide = std::max(wide, grid_.box().distance_to(around));
  for (; !grid_.edges().empty(); wide *= 4.0) {
    const Box looked_at = around.grown(wide);
    grid_.visit_near(looked_at, [&](VertexId e) {
      const LineSegment& edge = world_.edges()[e];
      distance = std::min(distance, distance_to_body(frame(edge.a), frame(edge.b)));
    });
    if (distance <= wide || (looked_at.contains(grid_.box().min) && looked_at.contains(grid_.box().max))) break;
  }
  return distance;
}

/// Whether the body, moved from the end of the segment before to a pose, stays off all edges by the distance proved
/// there. It is then in no region that it was not in before.
bool MotionCheck::is_near_last_end(const Pose& pose) const {
  if (!last_end_) return false;
  const double turn = std::abs(std::remainder(pose.heading - last_end_->heading, 2.0 * std::numbers::pi));
  return (pose.position() - last_end_->position()).norm() + turn * reach_ + rounding_ < lower_;
}

/// The obstacle around a point of any part of the body, or the bounds if it is not in them.
std::optional<ObstacleId> MotionCheck::swallowing(const Pose& pose) const {
  const Vec2 ahead = direction_of(pose.heading);
  for (const Vec2& p : inner_points_)
    if (const auto region = region_around(pose.position() + p.x() * ahead + p.y() * perpendicular(ahead)))
      return region;
  return std::nullopt;
}

/// The obstacle around a point by ray crossings of all its rings, or the bounds if it is not in them.
std::optional<ObstacleId> MotionCheck::region_around(const Vec2& p) const {
  for (ObstacleId o = 0; o < world_.region_count(); ++o) {
    const bool is_bounds = o == world_.obstacle_count();
    if (!world_.box_of(o).contains(p)) {
      if (is_bounds) return o;
      continue;
    }
    bool inside = false;
    const auto [first, last] = world_.vertices_of(o);
    for (VertexId v = first; v < last; ++v) {
      const auto& [a, b] = world_.edges()[v];
      if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
        inside = !inside;
      }
    }
    if (inside != is_bounds) return o;
  }
  return std::nullopt;
}

/// Calls visit(edge) for all edges that can come nearer to the box than the clearance so far.
template <typename Visit>
void MotionCheck::for_near(const Box& swept, const Visit& visit) const {
  grid_.visit_near(swept.grown(upper_ + rounding_), [&](VertexId e) {
    if (box_of(world_.edges()[e]).overlaps(swept.grown(upper_ + rounding_))) visit(e);
  });
}

void MotionCheck::add_hit(std::vector<Hit>& hits, const Hit& hit) const {
  const auto same_kind = [&](const Hit& h) {
    return (h.region == world_.obstacle_count()) == (hit.region == world_.obstacle_count());
  };
  const auto known = std::find_if(hits.begin(), hits.end(), same_kind);
  if (known == hits.end()) {
    hits.push_back(hit);
  } else if (hit.arc_length < known->arc_length) {
    *known = hit;
  }
}

void MotionCheck::check_line(const PathSegment& line, std::vector<Hit>& hits) {
  const Frame frame(line.start);
  const bool backwards = line.gear == Gear::kReverse;
  const Rectangle swept{body_.x0 - (backwards ? line.length : 0.0), body_.x1 + (backwards ? 0.0 : line.length),
                        body_.y0, body_.y1};
  Box box;
  for (const double x : {swept.x0, swept.x1}) {
    for (const double y : {swept.y0, swept.y1}) {
      box.extend(Vec2(frame.origin + x * frame.axis + y * perpendicular(frame.axis)));
    }
  }
  for_near(box, [&](VertexId e) {
    const Ends ends = frame(world_.edges()[e]);
    if (swept.gap_to(box_of(ends)) > upper_ + rounding_) return;  // as those that are not visited
    const auto& [a, b] = ends;
    const Vec2 way((backwards ? 1.0 : -1.0) * line.length, 0.0);
    const double distance = parts_.empty() ? segment_to_rectangle(swept, a, b) : hull_to_body({a, b, a + way, b + way});
    lower_ = std::min(lower_, distance - rounding_);
    upper_ = std::min(upper_, distance);
    if (distance > rounding_) return;
    add_hit(hits, {world_.obstacle_of(e), driven_to(ends, line), e});
  });
}

/// How far a line is driven until the body touches an edge that it touches on the line.
double MotionCheck::driven_to(const Ends& ends, const PathSegment& line) const {
  const auto& [a, b] = ends;
  const bool backwards = line.gear == Gear::kReverse;
  if (parts_.empty()) {
    const Rectangle swept{body_.x0 - (backwards ? line.length : 0.0), body_.x1 + (backwards ? 0.0 : line.length),
                          body_.y0, body_.y1};
    const auto [t0, t1] = clip(swept, a, b);
    const double x0 = t0 <= t1 ? a.x() + t0 * (b.x() - a.x()) : a.x();
    const double x1 = t0 <= t1 ? a.x() + t1 * (b.x() - a.x()) : a.x();
    return std::clamp(backwards ? body_.x0 - std::max(x0, x1) : std::min(x0, x1) - body_.x1, 0.0, line.length);
  }
  double free = 0.0, touching = line.length;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (free + touching);
    const Vec2 way((backwards ? 1.0 : -1.0) * middle, 0.0);
    (hull_to_body({a, b, a + way, b + way}) <= rounding_ ? touching : free) = middle;
  }
  return touching;
}

/// The travel of the fastest body point along the arc, for each meter of F. It is the corner furthest from the rotation
/// center, which lies 1 / curvature to the left of F.
double MotionCheck::travel_per_meter(double curvature) const {
  double most = 0.0;
  for (const double x : {body_.x0, body_.x1})
    for (const double y : {body_.y0, body_.y1}) most = std::max(most, std::hypot(curvature * x, 1.0 - curvature * y));
  return most;
}

/// A lower bound on the distance of an edge during an interval of an arc; lowers the upper bound as well. The bound is
/// the larger of two:
/// 1. First order: no body point moves further than `travel` from its place at the middle.
/// 2. Second order: seen from the body, the edge's ends move on arcs about the rotation center. The edge stays in the
///    hull of its two extreme places, grown by the height of those arcs. Boxes around these places decide most cases.
double MotionCheck::lower_bound_of(double curvature, const Interval& interval, double travel, bool& contact) {
  const auto& [before, middle, after] = std::tie(interval.before, interval.middle, interval.after);
  contact = false;
  const double beside = body_.gap_to(box_of(middle)) - travel - rounding_;
  if (proved(beside)) return beside;
  const double distance = distance_to_body(middle.a, middle.b);
  upper_ = std::min(upper_, distance);
  contact = distance <= rounding_;
  const double first_order = distance - travel - rounding_;
  const double half = 0.5 * (interval.s1 - interval.s0);
  if (contact || proved(first_order) || curvature * half > 0.25 * std::numbers::pi) return first_order;
  const double sine = std::sin(0.5 * curvature * half);
  const double height = (1.0 / curvature + std::max(middle.a.norm(), middle.b.norm())) * 2.0 * sine * sine;
  const double box = body_.gap_to(box_of(before, after)) - height - rounding_;
  if (proved(box)) return box;
  const double hull = hull_to_body({before.a, before.b, after.a, after.b});
  return std::max(first_order, hull - height - rounding_);
}

bool MotionCheck::proved(double lower) const { return lower > 0.0 && lower >= upper_ - tolerance_; }

void MotionCheck::check_arc(const PathSegment& arc, std::vector<Hit>& hits) {
  // A second lap sweeps nothing new.
  const double length = std::min(arc.length, 2.0 * std::numbers::pi / std::abs(arc.curvature));
  const Vec2 middle = arc.at(0.5 * length).position();
  const Vec2 margin = Vec2::Constant(0.5 * length + reach_);
  // Long intervals of little turn and short ones of much turn are told apart by what the body sweeps, not by what F
  // does.
  const double swing = travel_per_meter(arc.curvature);
  const double curvature = std::abs(arc.curvature);
  const auto seen_at = [&](double s, VertexId e) { return Frame(arc.at(s))(world_.edges()[e]); };
  std::priority_queue<Interval> queue;
  const auto consider = [&](Interval interval) {
    const auto [s0, s1] = std::pair(interval.s0, interval.s1);
    bool contact = false;
    const double travel = swing * (s1 - s0);
    interval.lower = lower_bound_of(curvature, interval, 0.5 * travel, contact);
    const bool is_shortest = travel < shortest_travel_ || s1 - s0 < kShortestInterval * length;
    if (contact || (is_shortest && !(interval.lower > 0.0))) {
      add_hit(hits, {world_.obstacle_of(interval.edge), 0.5 * (s0 + s1), interval.edge});
    } else if (is_shortest) {
      lower_ = std::min(lower_, interval.lower);
    } else {
      queue.push(interval);
    }
  };
  const Frame at_start(arc.start), at_middle(arc.at(0.5 * length)), at_end(arc.at(length));
  for_near({middle - margin, middle + margin}, [&](VertexId e) {
    const LineSegment& edge = world_.edges()[e];
    consider({0.0, 0.0, length, e, at_start(edge), at_middle(edge), at_end(edge)});
  });
  while (!queue.empty()) {
    const Interval node = queue.top();
    if (proved(node.lower)) {  // and so are all others, whose bounds are larger
      lower_ = std::min(lower_, node.lower);
      return;
    }
    queue.pop();
    // A collision with this kind of region is known: only an earlier contact would matter, which is not worth the
    // search.
    if (!hits.empty() && std::any_of(hits.begin(), hits.end(), [&](const Hit& h) {
          return (h.region == world_.obstacle_count()) == (world_.obstacle_of(node.edge) == world_.obstacle_count());
        })) {
      continue;
    }
    const double s = 0.5 * (node.s0 + node.s1);
    consider({0.0, node.s0, s, node.edge, node.before, seen_at(0.5 * (node.s0 + s), node.edge), node.middle});
    consider({0.0, s, node.s1, node.edge, node.middle, seen_at(0.5 * (s + node.s1), node.edge), node.after});
  }
}

}  // namespace arcway::internal

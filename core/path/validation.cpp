#include "core/path/validation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <stdexcept>
#include <utility>

#include "core/shortest_text.h"

namespace arcway {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kShortestInterval = 1e-9;  ///< one that is not proved free by then is a collision [m]
constexpr double kClearanceTolerance = 1e-6;

/// An axis-parallel rectangle in a frame of the body.
struct Rectangle {
  double x0, x1, y0, y1;

  [[nodiscard]] double distance_to(const Vec2& p) const {
    const double dx = std::max({x0 - p.x(), 0.0, p.x() - x1});
    const double dy = std::max({y0 - p.y(), 0.0, p.y() - y1});
    return std::hypot(dx, dy);
  }
};

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

/// Distance of a rectangle to the convex hull of four points.
double hull_to_rectangle(const Rectangle& r, const std::array<Vec2, 4>& q) {
  const Vec2 corner(r.x0, r.y0);
  if (in_triangle(corner, q[0], q[1], q[2]) || in_triangle(corner, q[0], q[1], q[3]) ||
      in_triangle(corner, q[0], q[2], q[3]) || in_triangle(corner, q[1], q[2], q[3])) {
    return 0.0;
  }
  double distance = kInfinity;  // the six joins contain the hull's sides
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) distance = std::min(distance, segment_to_rectangle(r, q[i], q[j]));
  }
  return distance;
}

/// World coordinates seen from a pose.
struct Frame {
  explicit Frame(const Pose& pose) : origin(pose.position()), axis(direction_of(pose.heading)) {}
  [[nodiscard]] Vec2 operator()(const Vec2& p) const {
    const Vec2 d = p - origin;
    return {axis.dot(d), cross(axis, d)};
  }
  Vec2 origin;
  Vec2 axis;
};

/// Collision and clearance of the motion, segment by segment.
class MotionCheck {
 public:
  MotionCheck(const World& world, const Vehicle& vehicle) : world_(world) {
    const VehicleParameters& p = vehicle.parameters();
    const double shift = p.steering == Steering::kSymmetric ? 0.0 : 0.5 * p.wheelbase;
    const double ahead = p.steering == Steering::kRear ? -shift : shift;  // from F to the body's centre
    body_ = {ahead - 0.5 * p.length, ahead + 0.5 * p.length, -0.5 * p.width, 0.5 * p.width};
    reach_ = std::hypot(std::max(std::abs(body_.x0), std::abs(body_.x1)), body_.y1);
    boxes_.reserve(world.edges().size());
    for (const LineSegment& e : world.edges()) {
      Box box;
      box.extend(e.a);
      box.extend(e.b);
      boxes_.push_back(box);
    }
    if (!world.box().empty()) {
      const double largest = std::max(world.box().min.cwiseAbs().maxCoeff(), world.box().max.cwiseAbs().maxCoeff());
      rounding_ = 16.0 * std::numeric_limits<double>::epsilon() * (largest + reach_);
    }
  }

  struct Hit {
    ObstacleId region;
    double arc_length;
    VertexId edge;  ///< none: the body is inside
  };

  /// The first contact found, if any; lowers `clearance`.
  std::vector<Hit> check(const PathSegment& segment) {
    std::vector<Hit> hits;
    if (const auto region = swallowing(segment.start)) hits.push_back({*region, 0.0, kNone});
    if (upper_ == kInfinity) upper_ = body_distance(segment.start);
    if (segment.is_line()) {
      check_line(segment, hits);
    } else {
      check_arc(segment, hits);
    }
    if (!hits.empty()) upper_ = lower_ = 0.0;
    return hits;
  }

  [[nodiscard]] double clearance() const { return std::max(0.0, lower_); }

 private:
  /// An interval of an arc and an edge that is not proved to keep away from the body during it.
  struct Node {
    double lower;  ///< bound on their distance
    double s0, s1;
    VertexId edge;
    bool operator<(const Node& other) const { return lower > other.lower; }  // the lowest on top of the queue
  };

  double body_distance(const Pose& pose) const {
    const Frame frame(pose);
    double distance = kInfinity;
    for (const LineSegment& e : world_.edges()) {
      distance = std::min(distance, segment_to_rectangle(body_, frame(e.a), frame(e.b)));
    }
    return distance;
  }

  /// The obstacle around a body point by ray crossings of all its rings, or the bounds if it is not in them.
  std::optional<ObstacleId> swallowing(const Pose& pose) const {
    const Vec2 p = pose.position() + 0.5 * (body_.x0 + body_.x1) * direction_of(pose.heading);
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
  void for_near(const Box& swept, const Visit& visit) const {
    for (VertexId e = 0; e < boxes_.size(); ++e) {
      const double grow = upper_ + rounding_;
      const Box& box = boxes_[e];
      if (box.min.x() <= swept.max.x() + grow && swept.min.x() - grow <= box.max.x() &&
          box.min.y() <= swept.max.y() + grow && swept.min.y() - grow <= box.max.y()) {
        visit(e);
      }
    }
  }

  void add_hit(std::vector<Hit>& hits, const Hit& hit) const {
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

  void check_line(const PathSegment& line, std::vector<Hit>& hits) {
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
      const Vec2 a = frame(world_.edges()[e].a);
      const Vec2 b = frame(world_.edges()[e].b);
      const double distance = segment_to_rectangle(swept, a, b);
      lower_ = std::min(lower_, distance - rounding_);
      upper_ = std::min(upper_, distance);
      if (distance > rounding_) return;
      const auto [t0, t1] = clip(swept, a, b);
      const double x0 = t0 <= t1 ? a.x() + t0 * (b.x() - a.x()) : a.x();
      const double x1 = t0 <= t1 ? a.x() + t1 * (b.x() - a.x()) : a.x();
      const double driven = backwards ? body_.x0 - std::max(x0, x1) : std::min(x0, x1) - body_.x1;
      add_hit(hits, {world_.obstacle_of(e), std::clamp(driven, 0.0, line.length), e});
    });
  }

  /// The edge during an interval of the arc: lowers the upper bound, gives the lower one.
  /// First order: no body point moves further than `travel` from its place at the middle. Second order: seen from the
  /// body the edge's ends move on arcs about the rotation centre, so that the edge keeps to the hull of its two extreme
  /// places, grown by those arcs' height.
  double bound(const PathSegment& arc, double s0, double s1, VertexId e, bool& contact) {
    const auto& [a, b] = world_.edges()[e];
    const double curvature = std::abs(arc.curvature);
    const double half = 0.5 * (s1 - s0);
    const Frame middle(arc.at(0.5 * (s0 + s1)));
    const Vec2 am = middle(a);
    const Vec2 bm = middle(b);
    const double distance = segment_to_rectangle(body_, am, bm);
    upper_ = std::min(upper_, distance);
    contact = distance <= rounding_;
    const double travel = (1.0 + curvature * reach_) * half;
    const double first_order = distance - travel - rounding_;
    if (contact || proved(first_order) || curvature * half > 0.25 * std::numbers::pi) return first_order;
    const Frame before(arc.at(s0));
    const Frame after(arc.at(s1));
    const double sine = std::sin(0.5 * curvature * half);
    const double height = (1.0 / curvature + std::max(am.norm(), bm.norm())) * 2.0 * sine * sine;
    const double hull = hull_to_rectangle(body_, {before(a), before(b), after(a), after(b)});
    return std::max(first_order, hull - height - rounding_);
  }

  [[nodiscard]] bool proved(double lower) const { return lower > 0.0 && lower >= upper_ - kClearanceTolerance; }

  void check_arc(const PathSegment& arc, std::vector<Hit>& hits) {
    // A second lap sweeps nothing new.
    const double length = std::min(arc.length, 2.0 * std::numbers::pi / std::abs(arc.curvature));
    const Vec2 middle = arc.at(0.5 * length).position();
    const Vec2 margin = Vec2::Constant(0.5 * length + reach_);
    std::priority_queue<Node> queue;
    const auto consider = [&](double s0, double s1, VertexId e) {
      bool contact = false;
      const double lower = bound(arc, s0, s1, e, contact);
      if (contact || (!(lower > 0.0) && s1 - s0 < kShortestInterval)) {
        add_hit(hits, {world_.obstacle_of(e), 0.5 * (s0 + s1), e});
        return;
      }
      if (s1 - s0 < kShortestInterval) {
        lower_ = std::min(lower_, lower);
      } else {
        queue.push({lower, s0, s1, e});
      }
    };
    for_near({middle - margin, middle + margin}, [&](VertexId e) { consider(0.0, length, e); });
    while (!queue.empty()) {
      const Node node = queue.top();
      if (proved(node.lower)) {  // then all others are as well
        lower_ = std::min(lower_, node.lower);
        return;
      }
      queue.pop();
      // Known to collide: of this kind of region only an earlier contact is of interest, and not worth the search.
      if (!hits.empty() && std::any_of(hits.begin(), hits.end(), [&](const Hit& h) {
            return (h.region == world_.obstacle_count()) == (world_.obstacle_of(node.edge) == world_.obstacle_count());
          })) {
        continue;
      }
      const double s = 0.5 * (node.s0 + node.s1);
      consider(node.s0, s, node.edge);
      consider(s, node.s1, node.edge);
    }
  }

  World world_;
  Rectangle body_{};
  double reach_ = 0.0;        ///< of the body from F
  std::vector<Box> boxes_;    ///< of the edges
  double rounding_ = 0.0;     ///< of a distance
  double upper_ = kInfinity;  ///< a clearance that occurs on the path
  double lower_ = kInfinity;  ///< a proved bound so far
};

double heading_difference(double a, double b) { return std::abs(std::remainder(a - b, 2.0 * std::numbers::pi)); }

bool is_finite(const Pose& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.heading); }

class Validator {
 public:
  Validator(const World& world, const Vehicle& vehicle, const TimedPath& path, const ValidationOptions& options)
      : world_(world), vehicle_(vehicle), path_(path), options_(options) {}

  ValidationReport run(const Pose& start, const Pose& goal) {
    const std::size_t n = path_.segments.size();
    if (!is_finite(start)) add(Violation::kNotFinite, 0, 0.0, "the start pose has a value that is not finite");
    if (!is_finite(goal)) add(Violation::kNotFinite, 0, 0.0, "the goal pose has a value that is not finite");
    for (std::size_t i = 0; i < n; ++i) check_numbers(i);
    if (report_.valid()) {
      check_ends(start, goal);
      for (std::size_t i = 0; i < n; ++i) check_shape(i);
      check_motion(start);
      if (!path_.durations.empty() || !path_.speed_in.empty() || !path_.speed_out.empty()) check_times();
    }
    return std::move(report_);
  }

 private:
  void add(Violation violation, std::size_t segment, double arc_length, std::string message) {
    for (const ValidationIssue& issue : report_.issues) {
      if (issue.violation == violation && issue.segment == segment) return;
    }
    report_.issues.push_back({violation, segment, arc_length, std::move(message)});
  }

  void check_numbers(std::size_t i) {
    const PathSegment& s = path_.segments[i];
    if (!is_finite(s.start) || !std::isfinite(s.length) || !std::isfinite(s.curvature)) {
      add(Violation::kNotFinite, i, 0.0, "the segment has a value that is not finite");
    } else if (s.length < 0.0) {
      add(Violation::kNegativeLength, i, 0.0, "the length is " + shortest_text(s.length) + " m");
    } else if (!is_finite(s.end())) {
      add(Violation::kNotFinite, i, s.length, "the end pose has a value that is not finite");
    }
  }

  void check_pose(const Pose& is, const Pose& should, Violation position, Violation heading, std::size_t segment,
                  double arc_length, const std::string& what) {
    const double gap = (is.position() - should.position()).norm();
    if (!(gap <= options_.position_tolerance)) {
      add(position, segment, arc_length,
          what + " is " + shortest_text(gap) + " m off, allowed are " + shortest_text(options_.position_tolerance));
    }
    const double turn = heading_difference(is.heading, should.heading);
    if (!(turn <= options_.heading_tolerance)) {
      add(heading, segment, arc_length,
          what + " is turned by " + shortest_text(turn) + " rad, allowed are " +
              shortest_text(options_.heading_tolerance));
    }
  }

  void check_ends(const Pose& start, const Pose& goal) {
    const Path& path = path_.segments;
    const Pose first = path.empty() ? start : path.front().start;
    const Pose last = path.empty() ? start : path.back().end();
    const std::size_t back = path.empty() ? 0 : path.size() - 1;
    check_pose(first, start, Violation::kStartPose, Violation::kStartPose, 0, 0.0, "the path's start");
    check_pose(last, goal, Violation::kGoalPose, Violation::kGoalPose, back, path.empty() ? 0.0 : path[back].length,
               "the path's end");
  }

  void check_shape(std::size_t i) {
    const PathSegment& s = path_.segments[i];
    report_.length += s.length;
    if (i > 0) {
      check_pose(s.start, path_.segments[i - 1].end(), Violation::kPositionJump, Violation::kHeadingJump, i, 0.0,
                 "the start of the segment");
    }
    const double limit = 1.0 / vehicle_.min_turning_radius();
    if (std::abs(s.curvature) > limit * (1.0 + options_.relative_tolerance)) {
      add(Violation::kCurvature, i, 0.0,
          "the curvature is " + shortest_text(s.curvature) + " 1/m, the limit " + shortest_text(limit));
    }
    if (s.gear == Gear::kReverse && !options_.reverse) {
      add(Violation::kReverse, i, 0.0, "the segment is driven backwards, which is not allowed");
    }
  }

  void check_motion(const Pose& start) {
    MotionCheck motion(world_, vehicle_);
    const auto check = [&](std::size_t i, const PathSegment& segment) {
      for (const MotionCheck::Hit& hit : motion.check(segment)) {
        const bool bounds = world_.has_bounds() && hit.region == world_.obstacle_count();
        const std::string place = " at " + shortest_text(hit.arc_length) + " m";
        const std::string region = bounds ? "the bounds" : "obstacle " + std::to_string(hit.region);
        std::string message = "the body ";
        message += hit.edge != kNone ? "touches edge " + std::to_string(hit.edge) + " of "
                   : bounds          ? "is outside of "
                                     : "is inside ";
        message += region;
        message += place;
        add(bounds ? Violation::kOutsideBounds : Violation::kCollision, i, hit.arc_length, message);
      }
    };
    for (std::size_t i = 0; i < path_.segments.size(); ++i) check(i, path_.segments[i]);
    if (path_.segments.empty()) check(0, {start, 0.0, 0.0});
    report_.min_clearance = motion.clearance();
  }

  void check_times() {
    const std::size_t n = path_.segments.size();
    if (path_.speed_in.size() != n || path_.speed_out.size() != n || path_.durations.size() != n) {
      throw std::invalid_argument("validate: " + std::to_string(n) + " segments, but " +
                                  std::to_string(path_.speed_in.size()) + " speeds in, " +
                                  std::to_string(path_.speed_out.size()) + " speeds out, " +
                                  std::to_string(path_.durations.size()) + " durations");
    }
    for (std::size_t i = 0; i < n; ++i) check_time(i);
  }

  void check_time(std::size_t i) {
    const PathSegment& s = path_.segments[i];
    const double tolerance = options_.relative_tolerance;
    const double a = vehicle_.max_acceleration();
    const double v1 = path_.speed_in[i];
    const double v3 = path_.speed_out[i];
    const double duration = path_.durations[i];
    if (!std::isfinite(v1) || !std::isfinite(v3) || !std::isfinite(duration)) {
      add(Violation::kNotFinite, i, 0.0, "a speed or the duration is not finite");
      return;
    }
    report_.travel_time += duration;
    const bool backwards = s.gear == Gear::kReverse;
    const double radius = 1.0 / std::abs(s.curvature);
    double limit = backwards ? vehicle_.max_reverse_speed() : vehicle_.max_speed();
    if (!s.is_line()) limit = backwards ? vehicle_.reverse_turn_speed(radius) : vehicle_.turn_speed(radius);
    for (const auto& [speed, at] : {std::pair(v1, 0.0), std::pair(v3, s.length)}) {
      if (speed >= 0.0 && speed <= limit * (1.0 + tolerance)) continue;
      add(Violation::kSpeedLimit, i, at,
          "the speed is " + shortest_text(speed) + " m/s, the limit " + shortest_text(limit));
    }
    check_speed_jump(i, 0.0, i == 0 ? 0.0 : path_.speed_out[i - 1], v1);
    if (i > 0 && s.gear != path_.segments[i - 1].gear) check_cusp(i, std::max(path_.speed_out[i - 1], v1));
    if (i + 1 == path_.segments.size()) check_speed_jump(i, s.length, 0.0, v3);

    const double change = std::abs(v3 - v1) * (v3 + v1);
    const double rounding = tolerance * tolerance * vehicle_.max_speed() * vehicle_.max_speed();
    if (change > 2.0 * a * s.length * (1.0 + tolerance) + rounding) {
      add(Violation::kAcceleration, i, 0.0,
          "from " + shortest_text(v1) + " to " + shortest_text(v3) + " m/s within " + shortest_text(s.length) +
              " m takes " + shortest_text(change / (2.0 * s.length)) + " m/s^2, the limit is " + shortest_text(a));
      return;
    }
    // Up to the peak, along at it, down from it.
    const double reached = std::sqrt(a * s.length + 0.5 * (v1 * v1 + v3 * v3));
    const double peak = std::max({v1, v3, std::min(limit, reached)});
    const double ramps = (peak * peak - 0.5 * (v1 * v1 + v3 * v3)) / a;
    double fastest = (2.0 * peak - v1 - v3) / a;
    if (peak > 0.0) fastest += std::max(0.0, s.length - ramps) / peak;
    const double slack = tolerance * fastest + 1e-12 * (1.0 + vehicle_.max_speed() / a);
    if (!(duration >= fastest - slack)) {
      add(Violation::kDuration, i, 0.0,
          "the duration is " + shortest_text(duration) + " s, the shortest possible " + shortest_text(fastest));
    }
  }

  void check_speed_jump(std::size_t i, double at, double before, double after) {
    if (std::abs(before - after) <= options_.relative_tolerance * std::max(1.0, std::abs(before))) return;
    add(Violation::kSpeedJump, i, at,
        "the speed jumps from " + shortest_text(before) + " to " + shortest_text(after) + " m/s");
  }

  void check_cusp(std::size_t i, double speed) {
    if (speed <= options_.relative_tolerance) return;
    add(Violation::kCuspSpeed, i, 0.0, "the gear changes at " + shortest_text(speed) + " m/s");
  }

  const World& world_;
  const Vehicle& vehicle_;
  const TimedPath& path_;
  const ValidationOptions& options_;
  ValidationReport report_;
};

}  // namespace

const char* name_of(Violation violation) {
  switch (violation) {
    case Violation::kNotFinite:
      return "not finite";
    case Violation::kStartPose:
      return "start pose";
    case Violation::kGoalPose:
      return "goal pose";
    case Violation::kPositionJump:
      return "position jump";
    case Violation::kHeadingJump:
      return "heading jump";
    case Violation::kCurvature:
      return "curvature";
    case Violation::kCollision:
      return "collision";
    case Violation::kOutsideBounds:
      return "outside bounds";
    case Violation::kSpeedLimit:
      return "speed limit";
    case Violation::kSpeedJump:
      return "speed jump";
    case Violation::kAcceleration:
      return "acceleration";
    case Violation::kDuration:
      return "duration";
    case Violation::kNegativeLength:
      return "negative length";
    case Violation::kReverse:
      return "driven backwards";
    case Violation::kCuspSpeed:
      return "speed at a cusp";
  }
  return "unknown";
}

ValidationReport validate(const World& world, const Vehicle& vehicle, const Pose& start, const Pose& goal,
                          const TimedPath& path, const ValidationOptions& options) {
  return Validator(world, vehicle, path, options).run(start, goal);
}

}  // namespace arcway

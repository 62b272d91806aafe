#include "arcway/validation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "core/model/pose_text.h"
#include "core/validate/edge_grid.h"
#include "core/validate/motion_check.h"
#include "core/validate/zone_check.h"

namespace arcway {

using namespace internal;
namespace {

double heading_difference(double a, double b) { return std::abs(std::remainder(a - b, 2.0 * std::numbers::pi)); }

bool is_finite(const Pose& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.heading); }

class Validation {
 public:
  Validation(const World& world, const EdgeGrid& grid, const Vehicle& vehicle, const TimedPath& path,
             const ValidationOptions& options)
      : world_(world), grid_(grid), vehicle_(vehicle), path_(path), options_(options) {
    for (std::size_t i = 0; i < world.zones().size(); ++i)
      if (const auto* limit = std::get_if<SpeedLimit>(&world.zones()[i].rule)) {
        limits_.push_back({ZoneCheck(world.zones()[i].area), limit->max_speed, i});
      } else if (const auto* way = std::get_if<OneWay>(&world.zones()[i].rule)) {
        ways_.push_back({ZoneCheck(world.zones()[i].area), *way, i});
      }
  }

  ValidationReport run(const Pose& start, const Pose& goal) {
    const std::size_t n = path_.segments.size();
    if (has_times()) require_times_of_all();
    if (!is_finite(start)) add(Violation::kNotFinite, 0, 0.0, "the start pose has a value that is not finite");
    if (!is_finite(goal)) add(Violation::kNotFinite, 0, 0.0, "the goal pose has a value that is not finite");
    for (std::size_t i = 0; i < n; ++i) check_numbers(i);
    if (report_.valid()) {
      check_ends(start, goal);
      for (std::size_t i = 0; i < n; ++i) check_shape(i);
      for (std::size_t i = 0; i < n; ++i) check_directions(i);
      check_motion(start);
      for (std::size_t i = 0; has_times() && i < n; ++i) check_time(i);
      check_end_speeds();
    }
    if (report_.valid() && n > 0 && !options_.moving.empty()) find_conflicts();
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

  // Many parameters because each caller names both violations and the place.
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
    const double limit = 1.0 / vehicle_.min_turning_radius(s.curvature > 0.0 ? Side::kLeft : Side::kRight);
    if (std::abs(s.curvature) > limit * (1.0 + options_.relative_tolerance)) {
      add(Violation::kCurvature, i, 0.0,
          "the curvature is " + shortest_text(s.curvature) + " 1/m, the limit " + shortest_text(limit));
    }
    if (s.gear == Gear::kReverse && !options_.reverse) {
      add(Violation::kReverse, i, 0.0, "the segment is driven backwards, which is not allowed");
    }
  }

  void check_directions(std::size_t i) {
    const PathSegment& segment = path_.segments[i];
    for (const Way& way : ways_) {
      const auto place = way.zone.against(segment, way.rule.heading, way.rule.tolerance + options_.heading_tolerance);
      if (!place) continue;
      const double body = segment.at(*place).heading;
      const double direction = segment.gear == Gear::kForward ? body : body + std::numbers::pi;
      add(Violation::kDirection, i, *place,
          "the direction of motion is " + shortest_text(heading_difference(direction, way.rule.heading)) +
              " rad off that of " + zone_text(world_.zones()[way.index], way.index) + ", allowed are " +
              shortest_text(way.rule.tolerance));
    }
  }

  void check_motion(const Pose& start) {
    MotionCheck motion(world_, grid_, vehicle_);
    const auto check = [&](std::size_t i, const PathSegment& segment) {
      for (const MotionCheck::Hit& hit : motion.check(segment)) {
        const bool bounds = world_.has_bounds() && hit.region == world_.obstacle_count();
        const std::string place = " at " + shortest_text(hit.arc_length) + " m";
        const std::uint32_t zone = world_.keep_out_of(hit.region);
        const std::string region = bounds          ? "the bounds"
                                   : zone != kNone ? zone_text(world_.zones()[zone], zone)
                                                   : "obstacle " + std::to_string(hit.region);
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

  [[nodiscard]] bool has_times() const {
    return !path_.durations.empty() || !path_.speed_in.empty() || !path_.speed_out.empty();
  }

  void require_times_of_all() const {
    const std::size_t n = path_.segments.size();
    if (path_.speed_in.size() != n || path_.speed_out.size() != n || path_.durations.size() != n) {
      throw std::invalid_argument("validate: " + std::to_string(n) + " segments, but " +
                                  std::to_string(path_.speed_in.size()) + " speeds in, " +
                                  std::to_string(path_.speed_out.size()) + " speeds out, " +
                                  std::to_string(path_.durations.size()) + " durations");
    }
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
    if (i > 0) check_speed_jump(i, 0.0, path_.speed_out[i - 1], v1);
    if (i > 0 && s.gear != path_.segments[i - 1].gear) check_cusp(i, std::max(path_.speed_out[i - 1], v1));

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
      return;
    }
    if (limits_.empty() || !(s.length > 0.0)) return;
    SegmentSpeeds speeds{v1, v3, limit, a, s.length};
    speeds.top = top_speed_within(speeds, duration);
    check_zones(i, speeds);
  }

  void check_zones(std::size_t i, const SegmentSpeeds& speeds) {
    const PathSegment& segment = path_.segments[i];
    for (const Limit& limit : limits_) {
      const auto place = limit.zone.too_fast(segment, speeds, limit.speed * (1.0 + options_.relative_tolerance));
      if (!place) continue;
      add(Violation::kSpeedLimit, i, *place,
          "the speed is " + shortest_text(speeds.at(*place)) + " m/s in " +
              zone_text(world_.zones()[limit.index], limit.index) + ", the limit " + shortest_text(limit.speed));
    }
  }

  void find_conflicts() {
    try {
      report_.conflicts = conflicts(Trajectory(path_, vehicle_), options_.moving);
    } catch (const std::invalid_argument& error) {
      add(Violation::kDuration, 0, 0.0, std::string("moving obstacles cannot be looked at: ") + error.what());
    }
  }

  void check_speed_jump(std::size_t i, double at, double before, double after) {
    if (std::abs(before - after) <= options_.relative_tolerance * std::max(1.0, std::abs(before))) return;
    add(Violation::kSpeedJump, i, at,
        "the speed jumps from " + shortest_text(before) + " to " + shortest_text(after) + " m/s");
  }

  // Speeds at the ends count backwards where the gear is reverse.
  void check_end_speeds() {
    const Path& path = path_.segments;
    if (path.empty()) {
      check_speed_jump(0, 0.0, options_.start_speed, options_.goal_speed);
    } else if (has_times()) {
      const std::size_t last = path.size() - 1;
      const double first_speed = sign_of(path.front().gear) * path_.speed_in.front();
      const double last_speed = sign_of(path.back().gear) * path_.speed_out.back();
      if (std::isfinite(first_speed)) check_speed_jump(0, 0.0, options_.start_speed, first_speed);
      if (std::isfinite(last_speed)) check_speed_jump(last, path[last].length, last_speed, options_.goal_speed);
    }
  }

  void check_cusp(std::size_t i, double speed) {
    if (speed <= options_.relative_tolerance) return;
    add(Violation::kCuspSpeed, i, 0.0, "the gear changes at " + shortest_text(speed) + " m/s");
  }

  // A zone that limits the speed.
  struct Limit {
    ZoneCheck zone;
    double speed;
    std::size_t index;  // among the world's zones
  };

  // A zone that is driven in one direction.
  struct Way {
    ZoneCheck zone;
    OneWay rule;
    std::size_t index;  // among the world's zones
  };

  const World& world_;
  const EdgeGrid& grid_;
  std::vector<Limit> limits_;
  std::vector<Way> ways_;
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
    case Violation::kDirection:
      return "driving direction";
  }
  return "unknown";
}

struct Validator::Data {
  explicit Data(const World& w) : world(w), grid(world.edges()) {}
  World world;
  EdgeGrid grid;
};

Validator::Validator(const World& world) : data_(std::make_shared<const Data>(world)) {}

ValidationReport Validator::operator()(const Vehicle& vehicle, const Pose& start, const Pose& goal,
                                       const TimedPath& path, const ValidationOptions& options) const {
  const World world = data_->world.for_vehicle(vehicle);
  if (world.vertices().data() != data_->world.vertices().data())
    return Validator(world)(vehicle, start, goal, path, options);
  return Validation(data_->world, data_->grid, vehicle, path, options).run(start, goal);
}

// Many parameters because this is a Validator's two calls in one.
ValidationReport validate(const World& world, const Vehicle& vehicle, const Pose& start, const Pose& goal,
                          const TimedPath& path, const ValidationOptions& options) {
  return Validator(world)(vehicle, start, goal, path, options);
}

std::string to_string(const ValidationIssue& issue) {
  return std::string(name_of(issue.violation)) + " in segment " + std::to_string(issue.segment) + " after " +
         rounded_text(issue.arc_length) + " m: " + issue.message;
}

std::string to_string(const ValidationReport& report) {
  if (report.valid())
    return "valid: " + rounded_text(report.length) + " m, " + rounded_text(report.travel_time) + " s, clearance " +
           rounded_text(report.min_clearance) + " m";
  std::string text = std::to_string(report.issues.size()) + (report.issues.size() == 1 ? " issue" : " issues");
  for (const ValidationIssue& issue : report.issues) text += "\n" + to_string(issue);
  for (const Conflict& conflict : report.conflicts) text += "\nconflict: " + to_string(conflict);
  return text;
}

}  // namespace arcway

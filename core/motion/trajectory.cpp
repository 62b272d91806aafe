#include "arcway/trajectory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "arcway/angle.h"
#include "core/base/shortest_text.h"
#include "core/motion/clearance.h"
#include "core/motion/motion_phases.h"
#include "core/motion/speed_profile.h"
#include "core/zones/speed_zones.h"

namespace arcway {

using namespace internal;
namespace {

/// Share by which claimed speeds and durations may differ from those that the vehicle can drive. Numbers of files are
/// rounded; a larger share would let through motions that `at` cannot follow.
constexpr double kClaimTolerance = 1e-6;
/// By how much claimed durations may differ beside that [s]. Plans have segments that last less than a femtosecond, of
/// which the times of both bounds are rounding alone.
constexpr double kClaimSlack = 1e-9;
/// Share of a step by which the last one may be longer, so that rounding adds no state right before the end.
constexpr double kLastStep = 1e-12;

double steps_of(const Phase& phase, double curvature, const PathSampling& sampling) {
  return std::ceil(
      std::max(phase.length / sampling.max_length, phase.length * std::abs(curvature) / sampling.max_angle));
}

void require_positive(double value, const char* name) {
  if (!(value > 0.0)) {
    throw std::invalid_argument("Trajectory::sample: " + std::string(name) + " is " + shortest_text(value) +
                                ", must be > 0");
  }
}

void require_few_steps(double steps, const std::string& size) {
  if (!(steps <= kMostSamplingSteps)) {
    throw std::invalid_argument("Trajectory::sample: the path has " + shortest_text(steps) + " steps of at most " +
                                size + ", must be at most " + shortest_text(kMostSamplingSteps));
  }
}

std::vector<TimedSegment> timed(std::span<const PathSegment> path, const SpeedProfile& profile) {
  std::vector<TimedSegment> segments;
  segments.reserve(path.size());
  for (std::size_t i = 0; i < path.size(); ++i)
    segments.push_back({path[i], profile.speeds[i], profile.speeds[i + 1], profile.durations[i]});
  return segments;
}

[[noreturn]] void refuse(std::size_t segment, const std::string& what) {
  throw std::invalid_argument("Trajectory: segment " + std::to_string(segment) + ": " + what);
}

// Finite numbers, lengths >= 0.
void check_geometry(const PathSegment& s, std::size_t index) {
  for (const double value : {s.start.x, s.start.y, s.start.heading, s.length, s.curvature})
    if (!std::isfinite(value)) refuse(index, "a number is " + shortest_text(value) + ", must be finite");
  if (s.length < 0.0) refuse(index, "length is " + shortest_text(s.length) + " m, must be >= 0");
}

// Whether the vehicle can drive a segment with these speeds in this time, without braking below both.
void check_claim(const TimedSegment& timed, const Vehicle& vehicle, std::size_t index) {
  const double limit = speed_limit(timed.segment, vehicle), a = vehicle.max_acceleration();
  const double v1 = timed.speed_in, v3 = timed.speed_out, length = timed.segment.length;
  for (const double speed : {v1, v3}) {
    if (!(speed >= 0.0 && speed <= limit * (1.0 + kClaimTolerance)))
      refuse(index, "a speed is " + shortest_text(speed) + " m/s, must be >= 0 and <= " + shortest_text(limit));
  }
  const double reachable = std::sqrt(std::min(v1, v3) * std::min(v1, v3) + 2.0 * a * length);
  if (std::max(v1, v3) > reachable * (1.0 + kClaimTolerance)) {
    refuse(index, "its speeds are " + shortest_text(v1) + " and " + shortest_text(v3) + " m/s, but " +
                      shortest_text(length) + " m are long enough for " + shortest_text(reachable) + " m/s only");
  }
  const double fastest = relaxed_segment_time(length, v1, limit, v3, a), top = std::max(v1, v3);
  const double slowest = top > 0.0 ? relaxed_segment_time(length, v1, top, v3, a) : INFINITY;
  if (!(timed.duration >= fastest * (1.0 - kClaimTolerance) - kClaimSlack)) {
    refuse(index, "duration is " + shortest_text(timed.duration) + " s, but the fastest motion takes " +
                      shortest_text(fastest) + " s");
  }
  if (!(timed.duration <= slowest * (1.0 + kClaimTolerance) + kClaimSlack) || timed.duration == INFINITY) {
    refuse(index, "duration is " + shortest_text(timed.duration) + " s, but without braking below " +
                      shortest_text(top) + " m/s it takes at most " + shortest_text(slowest) +
                      " s; give segments with lower speeds");
  }
}

}  // namespace

struct Trajectory::Data {
  Data(std::vector<TimedSegment> segments_driven, const Vehicle& its_vehicle, const std::optional<World>& its_world)
      : segments(std::move(segments_driven)), vehicle(its_vehicle), world(its_world) {
    if (segments.empty()) throw std::invalid_argument("Trajectory: the path has no segments");
    times.reserve(segments.size() + 1);
    distances.reserve(segments.size() + 1);
    times.push_back(0.0);
    distances.push_back(0.0);
    for (std::size_t i = 0; i < segments.size(); ++i) {
      check_geometry(segments[i].segment, i);
      check_claim(segments[i], vehicle, i);
      top_speeds.push_back(top_speed(segments[i], vehicle));
      times.push_back(times.back() + segments[i].duration);
      distances.push_back(distances.back() + segments[i].segment.length);
    }
  }

  [[nodiscard]] MotionPhases phases(std::size_t k) const {
    return {segments[k], top_speeds[k], vehicle.max_acceleration()};
  }

  /// Where in a segment the vehicle is, and how it moves.
  struct Moment {
    double s, t;  // from the start of the segment [m], [s]
    double speed, acceleration;
  };

  [[nodiscard]] TrajectoryState state(std::size_t k, const Moment& moment) const {
    const PathSegment& segment = segments[k].segment;
    const Pose pose = segment.at(moment.s);
    return {.time = times[k] + moment.t,
            .distance = distances[k] + moment.s,
            .pose = {pose.x, pose.y, wrap_signed(pose.heading)},
            .speed = moment.speed,
            .acceleration = moment.acceleration,
            .curvature = segment.curvature,
            .steering_angle = vehicle.steering_angle(segment.curvature),
            .gear = segment.gear,
            .segment = k};
  }

  /// The segment that begins at or before a time or a distance, the last of several.
  [[nodiscard]] std::size_t segment_at(const std::vector<double>& starts, double value) const {
    const auto after = std::upper_bound(starts.begin(), starts.end(), value);
    return std::min(static_cast<std::size_t>(after - starts.begin()) - 1, segments.size() - 1);
  }

  /// The end of a segment. The acceleration is that of its last phase.
  [[nodiscard]] TrajectoryState end_of(std::size_t k) const {
    const TimedSegment& timed = segments[k];
    const MotionPhases driven = phases(k);
    const double acceleration = driven.begin() == driven.end() ? 0.0 : (driven.end() - 1)->acceleration();
    return state(k, {timed.segment.length, timed.duration, timed.speed_out, acceleration});
  }

  [[nodiscard]] TrajectoryState at(double time) const {
    const std::size_t k = segment_at(times, time);
    const TimedSegment& timed = segments[k];
    const double t = time - times[k];
    if (t >= timed.duration) return end_of(k);
    double from = 0.0, begun = 0.0;
    Moment moment{0.0, t, timed.speed_in, 0.0};
    for (const Phase& phase : phases(k)) {
      const double duration = phase.time(phase.length), in_phase = std::min(t - begun, duration);
      const double a = phase.acceleration();
      moment.s = std::min(from + std::min(in_phase * (phase.speed_in + 0.5 * a * in_phase), phase.length),
                          timed.segment.length);
      moment.speed = std::max(0.0, phase.speed_in + a * in_phase);
      moment.acceleration = a;
      from += phase.length;
      begun += duration;
      if (t < begun) break;
    }
    return state(k, moment);
  }

  [[nodiscard]] TrajectoryState at_distance(double distance) const {
    const std::size_t k = segment_at(distances, distance);
    const TimedSegment& timed = segments[k];
    const double s = distance - distances[k];
    if (s >= timed.segment.length) return end_of(k);
    double from = 0.0, begun = 0.0;
    Moment moment{s, 0.0, timed.speed_in, 0.0};
    for (const Phase& phase : phases(k)) {
      const double in_phase = std::min(s - from, phase.length);
      moment.t = std::min(begun + phase.time(in_phase), timed.duration);
      moment.speed = phase.speed(in_phase);
      moment.acceleration = phase.acceleration();
      from += phase.length;
      begun += phase.time(phase.length);
      if (s < from) break;
    }
    return state(k, moment);
  }

  std::vector<TimedSegment> segments;
  Vehicle vehicle;
  std::optional<World> world;
  std::vector<double> times, distances;  // at the joints, ends included
  std::vector<double> top_speeds;        // by segment
};

Trajectory::Trajectory(std::span<const TimedSegment> segments, const Vehicle& vehicle,
                       const std::optional<World>& world)
    : data_(std::make_shared<const Data>(std::vector<TimedSegment>(segments.begin(), segments.end()), vehicle, world)) {
}

Trajectory::Trajectory(std::span<const PathSegment> path, const Vehicle& vehicle, const std::optional<World>& world) {
  for (std::size_t i = 0; i < path.size(); ++i) check_geometry(path[i], i);
  const std::shared_ptr<const SpeedZones> zones = world && !path.empty() ? SpeedZones::of(*world) : nullptr;
  CappedPath capped;
  SpeedProfile profile;
  if (zones) {
    cut(path, *zones, capped);
    path = capped.segments;
    capped_travel_time(capped, vehicle, {}, profile);
  } else {
    profile = speed_profile(path, vehicle);
  }
  data_ = std::make_shared<const Data>(timed(path, profile), vehicle, world);
}

Trajectory::Trajectory(const TimedPath& path, const Vehicle& vehicle, const std::optional<World>& world) {
  const std::size_t n = path.segments.size();
  const std::array<std::size_t, 3> sizes{path.speed_in.size(), path.speed_out.size(), path.durations.size()};
  if (std::ranges::all_of(sizes, [](std::size_t size) { return size == 0; })) {
    *this = Trajectory(std::span<const PathSegment>(path.segments), vehicle, world);
    return;
  }
  if (std::ranges::any_of(sizes, [&](std::size_t size) { return size != n; })) {
    throw std::invalid_argument("Trajectory: " + std::to_string(n) + " segments have " + std::to_string(sizes[0]) +
                                " and " + std::to_string(sizes[1]) + " speeds and " + std::to_string(sizes[2]) +
                                " durations, must have one each or none");
  }
  std::vector<TimedSegment> segments;
  segments.reserve(n);
  for (std::size_t i = 0; i < n; ++i)
    segments.push_back({path.segments[i], path.speed_in[i], path.speed_out[i], path.durations[i]});
  data_ = std::make_shared<const Data>(std::move(segments), vehicle, world);
}

double Trajectory::duration() const { return data_->times.back(); }
double Trajectory::length() const { return data_->distances.back(); }

TrajectoryState Trajectory::at(double time) const {
  if (!(time >= 0.0 && time <= duration())) {
    throw std::out_of_range("Trajectory::at: time " + shortest_text(time) + " s is outside of 0 to " +
                            shortest_text(duration()) + " s");
  }
  return data_->at(time);
}

TrajectoryState Trajectory::at_distance(double distance) const {
  if (!(distance >= 0.0 && distance <= length())) {
    throw std::out_of_range("Trajectory::at_distance: distance " + shortest_text(distance) + " m is outside of 0 to " +
                            shortest_text(length()) + " m");
  }
  return data_->at_distance(distance);
}

double Trajectory::clearance_at(double time, const World& world) const {
  return clearance_along({at(time).pose, 0.0, 0.0}, vehicle().body(), world).distance;
}

double Trajectory::clearance_at(double time) const {
  if (!data_->world)
    throw std::logic_error("Trajectory::clearance_at: made without a world; pass one here or to the constructor");
  return clearance_at(time, *data_->world);
}

std::vector<Vec2> Trajectory::polyline(double step) const { return arcway::polyline(path_of(segments()), step); }

std::vector<TrajectoryState> Trajectory::sample(double dt) const {
  require_positive(dt, "dt");
  const double steps = std::max(std::ceil(duration() / dt * (1.0 - kLastStep)), duration() > 0.0 ? 1.0 : 0.0);
  require_few_steps(steps, shortest_text(dt) + " s");
  std::vector<TrajectoryState> states;
  states.reserve(static_cast<std::size_t>(steps) + 1);
  for (double i = 0.0; i < steps; ++i) states.push_back(data_->at(i * dt));
  states.push_back(data_->end_of(data_->segments.size() - 1));
  return states;
}

std::vector<TrajectoryState> Trajectory::sample(const PathSampling& sampling) const {
  require_positive(sampling.max_length, "max_length");
  require_positive(sampling.max_angle, "max_angle");
  const Data& d = *data_;
  double all_steps = 0.0;
  for (std::size_t k = 0; k < d.segments.size(); ++k)
    for (const Phase& phase : d.phases(k)) all_steps += steps_of(phase, d.segments[k].segment.curvature, sampling);
  require_few_steps(all_steps,
                    shortest_text(sampling.max_length) + " m and " + shortest_text(sampling.max_angle) + " rad");
  std::vector<TrajectoryState> states;
  for (std::size_t k = 0; k < d.segments.size(); ++k) {
    const TimedSegment& timed = d.segments[k];
    const double length = timed.segment.length;
    double from = 0.0, begun = 0.0;  // start of the phase within the segment [m], [s]
    const bool joined = k > 0 && d.segments[k - 1].segment.curvature == timed.segment.curvature &&
                        d.segments[k - 1].segment.gear == timed.segment.gear;
    const MotionPhases phases = d.phases(k);
    if (!joined)
      states.push_back(d.state(
          k, {0.0, 0.0, timed.speed_in, phases.begin() == phases.end() ? 0.0 : phases.begin()->acceleration()}));
    for (const Phase& phase : phases) {
      const double acceleration = phase.acceleration();
      if (from > 0.0) states.push_back(d.state(k, {from, begun, phase.speed_in, acceleration}));
      const double steps = steps_of(phase, timed.segment.curvature, sampling);
      for (double i = 1.0; i < steps; ++i) {
        const double s = phase.length * (i / steps);
        states.push_back(d.state(k, {from + s, begun + phase.time(s), phase.speed(s), acceleration}));
      }
      // Rounding may not lead past the segment's end.
      from = std::min(from + phase.length, length);
      begun = std::min(begun + phase.time(phase.length), timed.duration);
    }
    // The segment's end; its duration is the plan's, not ours, so that errors do not add up.
    if (length > 0.0 || timed.duration > 0.0) states.push_back(d.end_of(k));
  }
  return states;
}

std::span<const TimedSegment> Trajectory::segments() const { return data_->segments; }
const Vehicle& Trajectory::vehicle() const { return data_->vehicle; }

std::string to_string(const TrajectoryState& state) {
  return rounded_text(state.time) + " s, " + rounded_text(state.distance) + " m: (" + rounded_text(state.pose.x) +
         ", " + rounded_text(state.pose.y) + ", " + rounded_text(state.pose.heading) + ") at " +
         rounded_text(state.speed) + " m/s " + to_string(state.gear) + ", " + rounded_text(state.acceleration) +
         " m/s^2, curvature " + rounded_text(state.curvature) + " 1/m";
}

std::string to_string(const Trajectory& trajectory) {
  const std::size_t segments = trajectory.segments().size();
  return rounded_text(trajectory.duration()) + " s, " + rounded_text(trajectory.length()) + " m, " +
         std::to_string(segments) + (segments == 1 ? " segment" : " segments");
}

}  // namespace arcway

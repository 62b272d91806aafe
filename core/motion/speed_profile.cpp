#include "core/motion/speed_profile.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/base/infinity.h"
#include "core/base/shortest_text.h"

namespace arcway::internal {
namespace {

/// Share by which a duration may exceed that of the fastest motion by rounding, as in files.
constexpr double kSameTime = 1e-6;

double reachable(double speed, double acceleration, double length) {
  return std::sqrt(speed * speed + 2.0 * acceleration * length);
}

// Why no motion along a path has an end speed.
struct Refusal {
  const char* name;  // of the speed
  double speed;      // in the direction of travel [m/s]
  double bound;      // the highest one that is possible [m/s]
  bool is_limit;     // whether the bound is the segment's limit
};

std::optional<Refusal> above_limit(const char* name, double speed, double limit) {
  if (speed >= 0.0 && speed <= limit) return std::nullopt;
  return Refusal{name, speed, limit, true};
}

std::optional<Refusal> out_of_reach(const char* name, double speed, double bound) {
  if (speed <= bound) return std::nullopt;
  return Refusal{name, speed, bound, false};
}

std::invalid_argument error_of(const Refusal& refusal) {
  const std::string speed = "speed_profile: " + std::string(refusal.name) + " is " + shortest_text(refusal.speed);
  if (refusal.is_limit)
    return std::invalid_argument(speed +
                                 " m/s in the segment's gear, must be >= 0 and <= " + shortest_text(refusal.bound));
  return std::invalid_argument(speed + " m/s, but the path is long enough for " + shortest_text(refusal.bound) +
                               " only");
}

/// Inlined into segment_time, as an exported function could not be: search and refinement call that one all the time.
inline SegmentPhases phases_of(double length, double v1, double v2, double v3, double a) {
  const double to_top = (2.0 * v2 * v2 - v1 * v1 - v3 * v3) / (2.0 * a);
  if (to_top <= length) {
    return {.peak = v2,
            .accelerating = 0.5 * (v2 - v1) * (v2 + v1) / a,
            .holding = length - to_top,
            .braking = 0.5 * (v2 - v3) * (v2 + v3) / a};
  }
  const double half_change = 0.5 * (v3 - v1) * (v3 + v1) / a;
  return {.peak = std::sqrt(0.5 * (2.0 * a * length + v1 * v1 + v3 * v3)),
          .accelerating = 0.5 * std::max(0.0, length + half_change),
          .holding = 0.0,
          .braking = 0.5 * std::max(0.0, length - half_change)};
}

}  // namespace

SegmentPhases segment_phases(double length, double v1, double v2, double v3, double acceleration) {
  return phases_of(length, v1, v2, v3, acceleration);
}

double segment_time(double length, double v1, double v2, double v3, double acceleration) {
  const auto [peak, accelerating, holding, braking] = phases_of(length, v1, v2, v3, acceleration);
  if (holding > 0.0) return (2.0 * peak - v1 - v3) / acceleration + holding / peak;  // (9)
  // (10), with peak - v1 and peak - v3 rationalised: they cancel on short segments.
  return 2.0 * accelerating / (peak + v1) + 2.0 * braking / (peak + v3);
}

double relaxed_segment_time(double length, double v1, double v2, double v3, double acceleration) {
  if (!(length > 0.0)) return 0.0;
  const double change = 2.0 * acceleration * length;
  const double entry = std::min(v1, std::sqrt(v3 * v3 + change));
  const double exit = std::min(v3, std::sqrt(entry * entry + change));
  // Rounding of the roots may leave the change a unit in the last place too large for (9) and (10).
  if (std::abs(entry * entry - exit * exit) >= change) return 2.0 * length / (entry + exit);
  return segment_time(length, entry, v2, exit, acceleration);
}

double longest_motion(double time, double v1, double v2, double v3, double acceleration) {
  // The speed rises, is kept at the top if it gets there, and falls. Without that end, it would reach the peak.
  const double peak = 0.5 * (v1 + v3 + acceleration * time);
  if (peak < std::max(v1, v3)) return time * v2;  // there is no such motion
  if (peak < v2) return (2.0 * peak * peak - v1 * v1 - v3 * v3) / (2.0 * acceleration);
  return time * v2 - ((v2 - v1) * (v2 - v1) + (v2 - v3) * (v2 - v3)) / (2.0 * acceleration);
}

double speed_limit(const PathSegment& segment, const Vehicle& vehicle) {
  const bool forward = segment.gear == Gear::kForward;
  if (segment.is_line()) return forward ? vehicle.max_speed() : vehicle.max_reverse_speed();
  const double radius = 1.0 / std::abs(segment.curvature);
  return forward ? vehicle.turn_speed(radius) : vehicle.reverse_turn_speed(radius);
}

double top_speed(const TimedSegment& timed, const Vehicle& vehicle) {
  const double limit = speed_limit(timed.segment, vehicle), a = vehicle.max_acceleration();
  const double v1 = timed.speed_in, v3 = timed.speed_out, length = timed.segment.length;
  const double fastest = relaxed_segment_time(length, v1, limit, v3, a);
  if (!(length > 0.0) || timed.duration <= fastest * (1.0 + kSameTime)) return limit;
  // (9) for the top speed p: p^2 - (v1 + v3 + a t) p + a L + (v1^2 + v3^2) / 2 = 0, of which the smaller root.
  const double b = v1 + v3 + a * timed.duration, c = a * length + 0.5 * (v1 * v1 + v3 * v3);
  return std::max({v1, v3, 2.0 * c / (b + std::sqrt(std::max(0.0, b * b - 4.0 * c)))});
}

namespace {

// A vehicle that stays where it is.
std::optional<Refusal> fill_empty(const Vehicle& vehicle, const EndSpeeds& ends, SpeedProfile& profile) {
  const double start = std::abs(ends.start), goal = std::abs(ends.goal);
  profile.speeds.assign(1, start);
  if (auto refusal = above_limit("start_speed", start, vehicle.top_speed())) return refusal;
  if (auto refusal = above_limit("goal_speed", goal, vehicle.top_speed())) return refusal;
  if (ends.start != ends.goal) return Refusal{"goal_speed", ends.goal, ends.start, false};
  return std::nullopt;
}

// The segments of a path, and their limits.
struct LimitedPath {
  std::span<const PathSegment> segments;
  std::span<const double> caps;  // of zones; empty: none
  const Vehicle& vehicle;

  [[nodiscard]] double limit(std::size_t i) const {
    const double own = speed_limit(segments[i], vehicle);
    return caps.empty() ? own : std::min(own, caps[i]);
  }
};

std::optional<Refusal> find_speeds(const LimitedPath& limited, const EndSpeeds& ends, double a,
                                   std::vector<double>& v) {
  const std::span<const PathSegment> path = limited.segments;
  const std::size_t n = path.size();
  const double start = sign_of(path.front().gear) * ends.start, goal = sign_of(path.back().gear) * ends.goal;
  if (auto refusal = above_limit("start_speed", start, limited.limit(0))) return refusal;
  if (auto refusal = above_limit("goal_speed", goal, limited.limit(n - 1))) return refusal;
  v.resize(n + 1);
  v[n] = goal;
  for (std::size_t i = n; i-- > 0;) {
    double limit = i == 0 ? limited.limit(0) : std::min(limited.limit(i - 1), limited.limit(i));
    if (i > 0 && path[i - 1].gear != path[i].gear) limit = 0.0;
    v[i] = std::min(limit, reachable(v[i + 1], a, path[i].length));
  }
  if (auto refusal = out_of_reach("start_speed", start, v[0])) return refusal;
  v[0] = start;
  for (std::size_t i = 0; i + 1 < n; ++i) v[i + 1] = std::min(v[i + 1], reachable(v[i], a, path[i].length));
  return out_of_reach("goal_speed", goal, reachable(v[n - 1], a, path[n - 1].length));
}

std::optional<Refusal> fill(const LimitedPath& limited, const EndSpeeds& ends, SpeedProfile& profile) {
  const std::span<const PathSegment> path = limited.segments;
  const Vehicle& vehicle = limited.vehicle;
  profile.durations.clear();
  profile.total_time = 0.0;
  if (path.empty()) return fill_empty(vehicle, ends, profile);
  std::vector<double>& v = profile.speeds;
  double a = vehicle.max_acceleration();
  if (auto refusal = find_speeds(limited, ends, a, v)) {
    if (refusal->is_limit) return refusal;
    a *= 1.0 + kEndTolerance;
    if (find_speeds(limited, ends, a, v)) return refusal;
  }
  profile.durations.reserve(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double duration =
        path[i].length > 0.0 ? segment_time(path[i].length, v[i], limited.limit(i), v[i + 1], a) : 0.0;
    profile.durations.push_back(duration);
    profile.total_time += duration;
  }
  return std::nullopt;
}

// Sums the parts of each segment of the path that was cut.
void join_parts(const CappedPath& capped, SpeedProfile& profile) {
  const std::size_t n = capped.first.size() - 1;
  for (std::size_t i = 0; i < n; ++i) {
    double duration = 0.0;
    for (std::size_t part = capped.first[i]; part < capped.first[i + 1]; ++part) duration += profile.durations[part];
    profile.speeds[i + 1] = profile.speeds[capped.first[i + 1]];
    profile.durations[i] = duration;
  }
  profile.speeds.resize(n + 1);
  profile.durations.resize(n);
}

std::optional<Refusal> fill(const LimitedPath& path, const EndSpeeds& ends, SpeedProfile& profile,
                            const SpeedZones* zones) {
  if (zones == nullptr || path.segments.empty()) return fill(path, ends, profile);
  CappedPath capped;
  cut(path.segments, *zones, capped);
  auto refusal = fill({capped.segments, capped.caps, path.vehicle}, ends, profile);
  if (!refusal) join_parts(capped, profile);
  return refusal;
}

}  // namespace

SpeedProfile speed_profile(std::span<const PathSegment> path, const Vehicle& vehicle, const EndSpeeds& ends,
                           const SpeedZones* zones) {
  SpeedProfile profile;
  if (const auto refusal = fill({path, {}, vehicle}, ends, profile, zones)) throw error_of(*refusal);
  return profile;
}

double travel_time(std::span<const PathSegment> path, const Vehicle& vehicle, const EndSpeeds& ends,
                   SpeedProfile& profile, const SpeedZones* zones) {
  if (fill({path, {}, vehicle}, ends, profile, zones)) profile.total_time = kInfinity;
  return profile.total_time;
}

double capped_travel_time(const CappedPath& capped, const Vehicle& vehicle, const EndSpeeds& ends,
                          SpeedProfile& profile) {
  if (fill({capped.segments, capped.caps, vehicle}, ends, profile)) profile.total_time = kInfinity;
  return profile.total_time;
}

}  // namespace arcway::internal

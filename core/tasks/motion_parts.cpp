#include "core/tasks/motion_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/motion/speed_profile.h"

namespace arcway::internal {
namespace {

// A segment that lasts no longer is over [s]: its length and speeds are no more than rounding. The vehicle moves by
// less than a micrometer in that time.
constexpr double kMoment = 1e-9;

// Lowers the greater of the speeds at both ends of a segment to what the vehicle can reach from the other one. It may
// be more by rounding and by what motions are allowed to claim. That is a tiny share of the greater speed, but may be a
// large one of the other.
void lower_to_reachable(TimedSegment& timed, const Vehicle& vehicle) {
  double& greater = timed.speed_in > timed.speed_out ? timed.speed_in : timed.speed_out;
  const double other = std::min(timed.speed_in, timed.speed_out);
  greater = std::min(greater, std::sqrt(other * other + 2.0 * vehicle.max_acceleration() * timed.segment.length));
}

// The time nearest to another one in which a vehicle drives a segment with its speeds. It counts shortly before an end
// of the segment, where its numbers are rounded one by one.
double possible_time(double time, const TimedSegment& timed, const Vehicle& vehicle) {
  const auto time_at = [&](double top) {
    return relaxed_segment_time(timed.segment.length, timed.speed_in, top, timed.speed_out, vehicle.max_acceleration());
  };
  const double top = std::max(timed.speed_in, timed.speed_out);
  return std::max(top > 0.0 ? std::min(time, time_at(top)) : time, time_at(speed_limit(timed.segment, vehicle)));
}

TimedSegment rest_of(TimedSegment timed, double driven, const TrajectoryState& now, double ended,
                     const Vehicle& vehicle) {
  PathSegment& segment = timed.segment;
  segment.start = segment.at(std::clamp(driven, 0.0, segment.length));
  segment.length = std::max(0.0, segment.length - driven);
  timed.speed_in = now.speed;
  lower_to_reachable(timed, vehicle);
  timed.duration = possible_time(ended - now.time, timed, vehicle);
  return timed;
}

}  // namespace

std::vector<TimedSegment> rest_of(const Trajectory& motion, const TrajectoryState& now) {
  std::vector<TimedSegment> rest;
  const std::span<const TimedSegment> segments = motion.segments();
  double begun = 0.0, before = 0.0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const TimedSegment& timed = segments[i];
    const double ended = begun + timed.duration, driven_here = now.distance - before;
    begun = ended;
    before += timed.segment.length;
    if (i < now.segment) continue;
    if (i > now.segment) {
      rest.push_back(timed);
    } else if (ended - now.time > kMoment) {
      rest.push_back(rest_of(timed, driven_here, now, ended, motion.vehicle()));
    }
  }
  return rest;
}

std::vector<TimedSegment> begin_of(const Trajectory& motion, const TrajectoryState& there) {
  const std::span<const TimedSegment> whole = motion.segments().first(there.segment);
  std::vector<TimedSegment> begin(whole.begin(), whole.end());
  double length = 0.0;
  for (const TimedSegment& timed : begin) length += timed.segment.length;
  const double time = there.time - time_of(begin);
  if (!(time > kMoment)) return begin;
  TimedSegment last = motion.segments()[there.segment];
  last.segment.length = std::clamp(there.distance - length, 0.0, last.segment.length);
  last.speed_out = there.speed;
  lower_to_reachable(last, motion.vehicle());
  last.duration = possible_time(time, last, motion.vehicle());
  begin.push_back(last);
  return begin;
}

std::vector<TimedSegment> begun_at(double speed, std::vector<TimedSegment> motion, const Vehicle& vehicle) {
  const double a = vehicle.max_acceleration();
  for (TimedSegment& timed : motion) {
    if (speed >= timed.speed_in) break;
    const double length = timed.segment.length, top = top_speed(timed, vehicle);
    timed.speed_in = speed;
    timed.speed_out = std::min(timed.speed_out, std::sqrt(speed * speed + 2.0 * a * length));
    timed.duration = relaxed_segment_time(length, speed, top, timed.speed_out, a);
    speed = timed.speed_out;
  }
  return motion;
}

double time_of(std::span<const TimedSegment> motion) {
  double time = 0.0;
  for (const TimedSegment& timed : motion) time += timed.duration;
  return time;
}

}  // namespace arcway::internal

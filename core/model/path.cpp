#include "arcway/path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "arcway/angle.h"
#include "core/model/merge_motions.h"
#include "core/model/pose_text.h"

namespace arcway {

using internal::rounded_text;
using internal::shortest_text;

namespace {

// Difference of headings below which segments count as one line or circle: the rounding of sums [rad].
constexpr double kSameHeading = 1e-14;

}  // namespace

Pose PathSegment::at(double s) const {
  // The chord, not a difference of two points of the circle, which cancels when the curvature is small.
  const double ahead = sign_of(gear) * s;
  const double half_turn = 0.5 * curvature * ahead;
  const double chord = half_turn == 0.0 ? ahead : ahead * (std::sin(half_turn) / half_turn);
  const Vec2 p = start.position() + chord * direction_of(start.heading + half_turn);
  return {p.x(), p.y(), start.heading + curvature * ahead};
}

Pose Path::at(double s) const {
  const auto refuse = [&](const std::string& what) {
    throw std::out_of_range("Path::at: arc length " + shortest_text(s) + " m " + what);
  };
  if (empty()) refuse("of a path without segments");
  double begin = 0.0;
  if (s >= 0.0) {
    for (const PathSegment& segment : *this) {
      const double end = begin + segment.length;
      if (s < end) return segment.at(std::min(s - begin, segment.length));
      begin = end;
    }
    if (s == begin) return back().end();
  } else {
    begin = length();
  }
  refuse("is outside of the path, 0 to " + shortest_text(begin));
  return {};
}

double Path::length() const { return length_of(*this); }

std::vector<Vec2> polyline(std::span<const PathSegment> path, double step) {
  if (!(step > 0.0)) throw std::invalid_argument("polyline: step is " + shortest_text(step) + " m, must be > 0");
  double steps = 0.0;
  for (const PathSegment& segment : path) steps += std::ceil(segment.length / step);
  if (!(steps <= kMostSamplingSteps)) {
    throw std::invalid_argument("polyline: the path has " + shortest_text(steps) + " steps of at most " +
                                shortest_text(step) + " m, must be at most " + shortest_text(kMostSamplingSteps));
  }
  std::vector<Vec2> points;
  points.reserve(static_cast<std::size_t>(steps) + 1);
  for (const PathSegment& segment : path) {
    const double count = std::max(std::ceil(segment.length / step), segment.length > 0.0 ? 1.0 : 0.0);
    for (double k = 0.0; k < count; ++k) points.push_back(segment.at(segment.length * k / count).position());
  }
  if (!path.empty()) points.push_back(path.back().end().position());
  return points;
}

double length_of(std::span<const PathSegment> path) {
  double length = 0.0;
  for (const PathSegment& segment : path) length += segment.length;
  return length;
}

Path reversed(std::span<const PathSegment> path) {
  Path back;
  back.reserve(path.size());
  for (auto segment = path.rbegin(); segment != path.rend(); ++segment) back.push_back(segment->reversed());
  return back;
}

Path merged(std::span<const PathSegment> path) {
  Path whole(path.begin(), path.end());
  internal::merge_motions(whole);
  return whole;
}

void internal::merge_motions(Path& path) {
  std::size_t count = 0;  // of segments so far
  for (std::size_t i = 0; i < path.size(); ++i) {
    const PathSegment next = path[i];
    if (count > 0) {
      PathSegment& last = path[count - 1];
      const double length = last.length + next.length;
      if (next.gear == last.gear && next.curvature == last.curvature && length * std::abs(next.curvature) < kTwoPi &&
          std::abs(wrap_signed(next.start.heading - last.end().heading)) <= kSameHeading) {
        last.length = length;
        continue;
      }
    }
    path[count++] = next;
  }
  path.erase(path.begin() + static_cast<std::ptrdiff_t>(count), path.end());
}

std::string to_string(const Pose& pose) { return shortest_text(pose); }

std::string to_string(Side side) { return side == Side::kLeft ? "left" : "right"; }

std::string to_string(Gear gear) { return gear == Gear::kForward ? "forwards" : "backwards"; }

std::string to_string(const PathSegment& segment) {
  const std::string motion = " " + to_string(segment.gear) + " from " + to_string(segment.start);
  if (segment.is_line()) return "line of " + rounded_text(segment.length) + " m" + motion;
  return std::string(segment.curvature > 0.0 ? "left" : "right") + " arc of " + rounded_text(segment.length) +
         " m with radius " + rounded_text(1.0 / std::abs(segment.curvature)) + " m" + motion;
}

std::string to_string(const Path& path) {
  const std::size_t cusps = cusps_of(path);
  return std::to_string(path.size()) + (path.size() == 1 ? " segment, " : " segments, ") + rounded_text(path.length()) +
         " m, " + std::to_string(cusps) + (cusps == 1 ? " gear change" : " gear changes");
}

std::string to_string(const TimedSegment& timed) {
  return to_string(timed.segment) + ", from " + rounded_text(timed.speed_in) + " to " + rounded_text(timed.speed_out) +
         " m/s in " + rounded_text(timed.duration) + " s";
}

Path path_of(std::span<const TimedSegment> segments) {
  Path path;
  path.reserve(segments.size());
  for (const TimedSegment& timed : segments) path.push_back(timed.segment);
  return path;
}

TimedPath timed_path_of(std::span<const TimedSegment> segments) {
  TimedPath path{.segments = path_of(segments), .speed_in = {}, .speed_out = {}, .durations = {}};
  for (const TimedSegment& timed : segments) {
    path.speed_in.push_back(timed.speed_in);
    path.speed_out.push_back(timed.speed_out);
    path.durations.push_back(timed.duration);
  }
  return path;
}

std::size_t cusps_of(std::span<const PathSegment> path) {
  std::size_t cusps = 0;
  for (std::size_t i = 1; i < path.size(); ++i) cusps += path[i].gear != path[i - 1].gear ? 1 : 0;
  return cusps;
}

}  // namespace arcway

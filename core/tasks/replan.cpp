#include "arcway/replan.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "core/motion/speed_profile.h"

namespace arcway {

using namespace internal;
namespace {

// What is left of a motion from a moment on.
std::vector<TimedSegment> rest_of(const Trajectory& driven, const TrajectoryState& now) {
  std::vector<TimedSegment> rest;
  const std::span<const TimedSegment> segments = driven.segments();
  double begun = 0.0, before = 0.0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    TimedSegment timed = segments[i];
    const double ended = begun + timed.duration, driven_here = now.distance - before;
    begun = ended;
    before += timed.segment.length;
    if (i < now.segment) continue;
    if (i == now.segment) {
      const double length = timed.segment.length - driven_here;
      if (!(length > 0.0) && !(ended > now.time)) continue;
      timed.segment.start = timed.segment.at(std::clamp(driven_here, 0.0, timed.segment.length));
      timed.segment.length = std::max(0.0, length);
      timed.speed_in = now.speed;
      timed.duration = ended - now.time;
    }
    rest.push_back(timed);
  }
  return rest;
}

Path path_of(std::span<const TimedSegment> segments) {
  Path path;
  for (const TimedSegment& timed : segments) path.push_back(timed.segment);
  return path;
}

double time_of(std::span<const TimedSegment> segments) {
  double time = 0.0;
  for (const TimedSegment& timed : segments) time += timed.duration;
  return time;
}

class Replanner {
 public:
  Replanner(const Planner& planner, const Trajectory& driven, double time)
      : planner_(planner), driven_(driven), now_(driven.at(time)), rest_(rest_of(driven, now_)) {
    if (!(driven.vehicle() == planner.vehicle()))
      throw std::invalid_argument("replan: the motion is of another vehicle than the planner's");
  }

  Replan run(const PlanLimits& limits) {
    const auto begun = std::chrono::steady_clock::now();
    const bool is_rest_free = planner_.is_free(path_of(rest_));
    Replan next;
    PlanLimits left = limits;
    left.time -= std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    if (left.time > 0.0 && !limits.stop.stop_requested()) next.plan = planner_.plan(request(), left);
    const double rest_time = time_of(rest_);
    if (next.plan.solved() && !(is_rest_free && rest_time <= next.plan.travel_time)) {
      next.motion = NextMotion::kPlanned;
      next.segments = next.plan.segments;
      next.travel_time = next.plan.travel_time;
    } else if (is_rest_free) {
      next.motion = NextMotion::kKept;
      next.segments = std::move(rest_);
      next.travel_time = rest_time;
    } else {
      brake(next);
    }
    return next;
  }

 private:
  [[nodiscard]] PlanRequest request() const {
    const std::span<const TimedSegment> segments = driven_.segments();
    const TimedSegment& last = segments.back();
    const bool reverses =
        std::ranges::any_of(segments, [](const TimedSegment& t) { return t.segment.gear == Gear::kReverse; });
    return {.start = now_.pose,
            .goal = last.segment.end(),
            .reverse = reverses,
            .start_speed = now_.signed_speed(),
            .goal_speed = sign_of(last.segment.gear) * last.speed_out};
  }

  void brake(Replan& next) const {
    next.reason = next.plan.reason.empty() ? "the rest of the motion is blocked, and there was no time for a plan"
                                           : next.plan.reason;
    const double a = planner_.vehicle().max_acceleration(), length = 0.5 * now_.speed * now_.speed / a;
    const PathSegment curve{now_.pose, length, now_.curvature, now_.gear}, line{now_.pose, length, 0.0, now_.gear};
    for (const Path& path : {along_rest(length), Path{curve}, Path{line}}) {
      if (path.empty() || !planner_.is_free(path)) continue;
      next.motion = NextMotion::kBraking;
      double speed = now_.speed;
      for (const PathSegment& segment : path) {
        const double out = std::sqrt(std::max(0.0, speed * speed - 2.0 * a * segment.length));
        const bool is_last = &segment == &path.back();
        next.segments.push_back({segment, speed, is_last ? 0.0 : out, (speed - (is_last ? 0.0 : out)) / a});
        next.travel_time += next.segments.back().duration;
        speed = out;
      }
      return;
    }
    next.reason += "; neither does any braking tried stay free";
  }

  [[nodiscard]] Path along_rest(double length) const {
    Path path;
    for (const TimedSegment& timed : rest_) {
      if (!(length > 0.0)) break;
      if (!(timed.segment.length > 0.0)) continue;
      path.push_back(timed.segment);
      path.back().length = std::min(length, timed.segment.length);
      length -= path.back().length;
    }
    // The rest is too short for it only by rounding, unless it ends at speed.
    constexpr double kRounding = 1e-9;
    if (length > kRounding * planner_.vehicle().footprint().length()) path.clear();
    return path;
  }

  const Planner& planner_;
  const Trajectory& driven_;
  TrajectoryState now_;
  std::vector<TimedSegment> rest_;
};

}  // namespace

const char* name_of(NextMotion motion) {
  switch (motion) {
    case NextMotion::kKept:
      return "kept";
    case NextMotion::kPlanned:
      return "planned";
    case NextMotion::kBraking:
      return "braking";
    case NextMotion::kNoMotion:
      break;
  }
  return "none";
}

Replan replan(const Planner& planner, const Trajectory& driven, double time, const PlanLimits& limits) {
  return Replanner(planner, driven, time).run(limits);
}

}  // namespace arcway

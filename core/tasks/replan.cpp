#include "arcway/replan.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/motion/speed_profile.h"
#include "core/tasks/plan_cost.h"
#include "core/tasks/replan_by.h"

namespace arcway {

using namespace internal;
namespace {

// A segment that lasts no longer is over [s]: its length and speeds are no more than rounding. The vehicle moves by
// less than a micrometer in that time.
constexpr double kMoment = 1e-9;

// What is left of a segment that is driven. Its numbers are rounded one by one; speed and time are moved to where the
// vehicle can drive the length so, which counts shortly before the end.
TimedSegment rest_of(TimedSegment timed, double driven, double time_left, double speed, const Vehicle& vehicle) {
  PathSegment& segment = timed.segment;
  segment.start = segment.at(std::clamp(driven, 0.0, segment.length));
  segment.length = std::max(0.0, segment.length - driven);
  const double a = vehicle.max_acceleration(), out = timed.speed_out, change = 2.0 * a * segment.length;
  timed.speed_in = std::clamp(speed, std::sqrt(std::max(0.0, out * out - change)), std::sqrt(out * out + change));
  const auto time_at = [&](double top) { return relaxed_segment_time(segment.length, timed.speed_in, top, out, a); };
  const double top = std::max(timed.speed_in, out);
  const double slowest = top > 0.0 ? time_at(top) : time_left;
  timed.duration = std::max(std::min(time_left, slowest), time_at(speed_limit(segment, vehicle)));
  return timed;
}

// What is left of a motion from a moment on.
std::vector<TimedSegment> rest_of(const Trajectory& driven, const TrajectoryState& now) {
  std::vector<TimedSegment> rest;
  const std::span<const TimedSegment> segments = driven.segments();
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
      rest.push_back(rest_of(timed, driven_here, ended - now.time, now.speed, driven.vehicle()));
    }
  }
  return rest;
}

double time_of(std::span<const TimedSegment> segments) {
  double time = 0.0;
  for (const TimedSegment& timed : segments) time += timed.duration;
  return time;
}

class Replanner {
 public:
  Replanner(const ReplanQueries& queries, const Trajectory& driven, double time, const ReplanOptions& options)
      : queries_(queries),
        last_(driven.segments().back()),
        options_(options),
        now_(driven.at(time)),
        rest_(rest_of(driven, now_)) {}

  Replan run() {
    const auto begun = std::chrono::steady_clock::now();
    const bool is_rest_free = queries_.is_free(path_of(rest_)), is_kept = is_rest_free && leads_to_goal();
    Replan next;
    PlanLimits left = options_.limits;
    left.time -= std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    if (left.time > 0.0 && !left.stop.stop_requested()) next.plan = queries_.plan(request(), left);
    const double rest_time = time_of(rest_);
    const auto rest_cost = [&] {
      return rest_time + (queries_.clearance_cost ? queries_.clearance_cost(path_of(rest_)) : 0.0);
    };
    if (next.plan.solved() && !(is_kept && rest_cost() <= next.plan.cost())) {
      next.motion = NextMotion::kPlanned;
      next.segments = next.plan.segments;
      next.travel_time = next.plan.travel_time;
    } else if (is_kept || (is_rest_free && last_.speed_out == 0.0)) {
      next.motion = is_kept ? NextMotion::kKept : NextMotion::kBraking;
      if (!is_kept) next.reason = reason_of(next.plan, "the motion before leads elsewhere");
      next.segments = std::move(rest_);
      next.travel_time = rest_time;
    } else {
      next.reason = reason_of(next.plan,
                              is_rest_free ? "the motion before leads elsewhere" : "the rest of the motion is blocked");
      brake(next);
    }
    return next;
  }

 private:
  [[nodiscard]] bool leads_to_goal() const {
    const Pose end = last_.segment.end();
    return !options_.goal || (options_.goal->position() == end.position() && options_.goal->heading == end.heading);
  }
  [[nodiscard]] PlanRequest request() const {
    return {.start = now_.pose,
            .goal = options_.goal.value_or(last_.segment.end()),
            .reverse = options_.reverse,
            .start_speed = now_.signed_speed(),
            .goal_speed = options_.goal ? 0.0 : sign_of(last_.segment.gear) * last_.speed_out};
  }
  static std::string reason_of(const PlanResult& plan, const std::string& otherwise) {
    return plan.reason.empty() ? otherwise + ", and there was no time for a plan" : plan.reason;
  }

  void brake(Replan& next) const {
    const double a = queries_.vehicle.max_acceleration(), length = 0.5 * now_.speed * now_.speed / a;
    const PathSegment curve{now_.pose, length, now_.curvature, now_.gear}, line{now_.pose, length, 0.0, now_.gear};
    for (const Path& path : {along_rest(length), Path{curve}, Path{line}}) {
      if (path.empty() || !queries_.is_free(path)) continue;
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
    if (length > kRounding * queries_.vehicle.footprint().length()) path.clear();
    return path;
  }

  const ReplanQueries& queries_;
  const TimedSegment& last_;
  const ReplanOptions& options_;
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

Replan internal::replan_by(const ReplanQueries& queries, const Trajectory& driven, double time,
                           const ReplanOptions& options) {
  return Replanner(queries, driven, time, options).run();
}

Replan replan(const Planner& planner, const Trajectory& driven, double time, const ReplanOptions& options) {
  if (!(driven.vehicle() == planner.vehicle()))
    throw std::invalid_argument("replan: the motion is of another vehicle than the planner's");
  return replan_by({planner.vehicle(), [&](std::span<const PathSegment> path) { return planner.is_free(path); },
                    [&](const PlanRequest& request, const PlanLimits& limits) { return planner.plan(request, limits); },
                    [&](std::span<const PathSegment> path) { return clearance_cost(planner, path); }},
                   driven, time, options);
}

}  // namespace arcway

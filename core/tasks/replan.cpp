#include "arcway/replan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/base/infinity.h"
#include "core/base/stopwatch.h"
#include "core/tasks/motion_parts.h"
#include "core/tasks/path_repair.h"
#include "core/tasks/plan_cost.h"
#include "core/tasks/replan_by.h"

namespace arcway {

using namespace internal;
namespace {

// Share of the time for a repair at most; the rest is left for a plan.
constexpr double kRepairShare = 0.5;

class Replanner {
 public:
  Replanner(const ReplanQueries& queries, const Trajectory& driven, double time, const ReplanOptions& options)
      : queries_(queries),
        last_(driven.segments().back()),
        options_(options),
        now_(driven.at(time)),
        rest_(rest_of(driven, now_)) {}

  Replan run() {
    const Stopwatch watch;
    const bool is_rest_free = queries_.is_free(path_of(rest_)), is_kept = is_rest_free && leads_to_goal(rest_);
    Replan next;
    if (!is_kept) {
      give_up();
      repair(options_.limits.time - watch.seconds());
    }
    PlanLimits left = options_.limits;
    left.time -= watch.seconds();
    if (left.time > 0.0 && !left.stop.stop_requested()) next.plan = queries_.plan(request(), left);
    const double other_cost = is_kept ? cost_of(rest_) : repaired_ ? cost_of(*repaired_) : kInfinity;
    if (next.plan.solved() && !(other_cost <= next.plan.cost())) {
      take(NextMotion::kPlanned, next.plan.segments, next);
    } else if (is_kept) {
      take(NextMotion::kKept, std::move(rest_), next);
    } else if (repaired_) {
      take(NextMotion::kRepaired, *std::move(repaired_), next);
    } else {
      stop(is_rest_free, next);
      next.given_up = std::move(given_up_);
    }
    return next;
  }

 private:
  [[nodiscard]] Pose goal() const { return options_.goal.value_or(last_.segment.end()); }
  [[nodiscard]] double goal_speed() const { return options_.goal ? 0.0 : last_.speed_out; }
  [[nodiscard]] bool leads_to_goal(std::span<const TimedSegment> motion) const {
    if (motion.empty()) return are_same_pose(now_.pose, goal());
    return are_same_pose(motion.back().segment.end(), goal()) && motion.back().speed_out == goal_speed();
  }
  [[nodiscard]] PlanRequest request() const {
    return {.start = now_.pose,
            .goal = goal(),
            .reverse = options_.reverse,
            .start_speed = now_.signed_speed(),
            .goal_speed = options_.goal ? 0.0 : sign_of(last_.segment.gear) * last_.speed_out};
  }
  [[nodiscard]] double cost_of(std::span<const TimedSegment> motion) const {
    return time_of(motion) + (queries_.clearance_cost ? queries_.clearance_cost(path_of(motion)) : 0.0);
  }
  static std::string reason_of(const PlanResult& plan, const std::string& otherwise) {
    return plan.reason.empty() ? otherwise + ", and there was no time for a plan" : plan.reason;
  }
  static void take(NextMotion motion, std::vector<TimedSegment> segments, Replan& next) {
    next.motion = motion;
    next.segments = std::move(segments);
    next.travel_time = time_of(next.segments);
  }

  // Finds the motion to the goal that is given up unless it is repaired: the rest, or what was given up before. A
  // vehicle that braked along the latter is on it still, and somewhere ahead of its start.
  void give_up() {
    if (leads_to_goal(rest_)) {
      given_up_ = rest_;
      return;
    }
    if (options_.given_up.empty() || !leads_to_goal(options_.given_up)) return;
    const Trajectory before(options_.given_up, queries_.vehicle);
    given_up_.assign(options_.given_up.begin(), options_.given_up.end());
    if (now_.distance > before.length()) return;
    const TrajectoryState there = before.at_distance(now_.distance);
    if (!are_same_pose(there.pose, now_.pose)) return;
    std::vector<TimedSegment> rest = rest_of(before, there);
    if (!rest.empty() && now_.speed <= there.speed) given_up_ = begun_at(now_.speed, std::move(rest), queries_.vehicle);
  }

  // @param time  that is left [s].
  void repair(double time) {
    if (given_up_.empty() || !std::isfinite(time) || !(time > 0.0)) return;
    const TimedSegment& first = given_up_.front();
    const bool begins_here = are_same_pose(first.segment.start, now_.pose) && first.speed_in == now_.speed;
    if (begins_here && queries_.is_free(path_of(given_up_))) {
      repaired_ = given_up_;
      return;
    }
    const Trajectory motion(given_up_, queries_.vehicle);
    PlanLimits limits = options_.limits;
    limits.time = kRepairShare * time;
    repaired_ = PathRepair(queries_, motion, now_, options_.reverse).find(limits);
  }

  void stop(bool is_rest_free, Replan& next) {
    if (is_rest_free && last_.speed_out == 0.0) {
      next.reason = reason_of(next.plan, "the motion before leads elsewhere");
      take(NextMotion::kBraking, std::move(rest_), next);
      return;
    }
    next.reason =
        reason_of(next.plan, is_rest_free ? "the motion before leads elsewhere" : "the rest of the motion is blocked");
    brake(next);
  }

  void brake(Replan& next) const {
    const double a = queries_.vehicle.max_acceleration(), length = 0.5 * now_.speed * now_.speed / a;
    const PathSegment curve{now_.pose, length, now_.curvature, now_.gear}, line{now_.pose, length, 0.0, now_.gear};
    const std::array<Path, 3> ways{along_rest(length), Path{curve}, Path{line}};
    const auto brake_where = [&](const auto& is_free) {
      const auto way = std::ranges::find_if(ways, [&](const Path& path) { return !path.empty() && is_free(path); });
      if (way != ways.end()) brake_along(*way, next);
      return way != ways.end();
    };
    if (brake_where(queries_.is_free)) return;
    // A contact with the margin, if only by rounding, is no reason not to stop.
    if (queries_.is_free_without_margin && brake_where(queries_.is_free_without_margin)) {
      next.reason += "; braking comes into the safety margin";
      return;
    }
    next.reason += "; neither does any braking tried stay free";
  }

  void brake_along(const Path& path, Replan& next) const {
    const double a = queries_.vehicle.max_acceleration();
    next.motion = NextMotion::kBraking;
    double speed = now_.speed;
    for (const PathSegment& segment : path) {
      const double out = std::sqrt(std::max(0.0, speed * speed - 2.0 * a * segment.length));
      const bool is_last = &segment == &path.back();
      next.segments.push_back({segment, speed, is_last ? 0.0 : out, (speed - (is_last ? 0.0 : out)) / a});
      next.travel_time += next.segments.back().duration;
      speed = out;
    }
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
  std::vector<TimedSegment> given_up_;
  std::optional<std::vector<TimedSegment>> repaired_;
};

}  // namespace

const char* name_of(NextMotion motion) {
  switch (motion) {
    case NextMotion::kKept:
      return "kept";
    case NextMotion::kPlanned:
      return "planned";
    case NextMotion::kRepaired:
      return "repaired";
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
                    [&](std::span<const PathSegment> path) { return clearance_cost(planner, path); },
                    [&](std::span<const PathSegment> path) { return planner.is_free_without_margin(path); }},
                   driven, time, options);
}

}  // namespace arcway

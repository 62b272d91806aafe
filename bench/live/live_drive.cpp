#include "bench/live/live_drive.h"

#include <algorithm>
#include <utility>

#include "bench/cpu_clock.h"

namespace arcway::internal::bench {
namespace {

constexpr double kPatience = 10.0;  // after standing so long the vehicle goes for the next goal [s]

}  // namespace

bool LiveCycle::leads_to_goal() const {
  return next.motion == NextMotion::kPlanned || next.motion == NextMotion::kKept ||
         next.motion == NextMotion::kRepaired;
}

LiveDrive::LiveDrive(LivePlanner& planner, Trajectory first, std::vector<Pose> goals, const LiveSetting& setting)
    : planner_(planner),
      goals_(std::move(goals)),
      setting_(setting),
      obstacles_(planner.world(), first.vehicle(), setting.seed),
      driven_(std::move(first)) {}

LiveCycle LiveDrive::next_cycle() {
  const double period = 1.0 / setting_.rate;
  LiveCycle cycle;
  time_ = std::min(time_ + period, driven_.duration());
  cycle.now = driven_.at(time_);
  choose_goal(cycle.now);
  const MapChange change = obstacles_.walk_on(period, driven_, time_);
  const CpuClock clock(CpuClock::Of::kThread);
  if (!change.removed.empty() || !change.added.empty()) planner_.change(change);
  cycle.change_seconds = clock.seconds();
  const double left = std::max(0.0, setting_.within - cycle.change_seconds);
  cycle.next = planner_.next(driven_, time_, {.goal = goal(), .limits = {.time = left}, .given_up = given_up_});
  cycle.plan_seconds = clock.seconds() - cycle.change_seconds;
  obstacles_.take_key(planner_.world());
  leads_to_goal_ = cycle.leads_to_goal();
  given_up_ = cycle.next.given_up;
  if (!cycle.next.segments.empty()) {
    driven_ = Trajectory(cycle.next.segments, driven_.vehicle());
    time_ = 0.0;
  }
  return cycle;
}

void LiveDrive::choose_goal(const TrajectoryState& now) {
  const bool has_arrived = now.time >= driven_.duration();
  standing_ = now.speed > 0.0 || (has_arrived && leads_to_goal_) ? 0.0 : standing_ + 1.0 / setting_.rate;
  if (has_arrived && leads_to_goal_) ++goals_reached_;
  if ((has_arrived && leads_to_goal_) || standing_ > kPatience) {
    ++goal_;
    standing_ = 0.0;
  }
}

}  // namespace arcway::internal::bench

// The step of PlanRun that plans parts of the best path again.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/collision/clearance_cost.h"
#include "core/motion/end_speeds.h"
#include "core/motion/travel_time_lower_bound.h"
#include "core/planner/plan_run.h"

namespace arcway::internal {

namespace {

// The joint of a path that is passed next to a time.
std::size_t joint_next_to(double time, std::span<const double> durations) {
  for (std::size_t i = 0; i < durations.size(); ++i) {
    if (time <= 0.5 * durations[i]) return i;
    time -= durations[i];
  }
  return durations.size();
}

}  // namespace

void PlanRun::take(const PlanParts& step, double trials) {
  keep_all();
  const bool reverse = query_.request.reverse;
  const double elsewhere = reverse ? step.both_gears_gap : step.forwards_gap;
  if (is_easy_ || !has_gap(best_cost_, is_narrow_ ? step.gap : elsewhere, true)) return;
  plan_parts(reverse ? step.parts : step.parts.first(step.forward_parts),
             {.scope = Scope::kPart,
              .gap = step.gap,
              .most_failed = step.most_failed,
              .best_gap = step.gap,
              .tree_share = step.tree_share},
             trials);
}

void PlanRun::take(const PlanPartsQuickly& step, double trials) {
  // Searches for parts have memory of their own.
  if (!is_worth_memory()) return;
  keep_all();
  plan_parts(step.parts,
             {.scope = Scope::kQuickPart,
              .gap = step.gap,
              .most_failed = step.most_failed,
              .slower = step.slower,
              .worth_length = step.worth_length},
             trials);
}

void PlanRun::plan_parts(std::span<const PathPart> parts, const PartEffort& effort, double trials) {
  std::size_t failed = 0;
  for (const PathPart& part : parts) {
    if (result_.interrupted || failed == effort.most_failed || !has_gap(best_cost_, effort.best_gap, true)) return;
    failed = plan_in_vain(part, effort, trials) ? failed + 1 : 0;
  }
}

PlanRequest PlanRun::request_between(std::size_t from, std::size_t to) const {
  const Path& whole = best();
  const std::vector<double>& speeds = workspace_.profile.speeds;
  PlanRequest request = query_.request;
  if (from > 0) {
    request.start = whole[from].start;
    request.start_speed = signed_speed(speeds[from], whole[from].gear);
  }
  if (to < whole.size()) {
    request.goal = whole[to].start;
    request.goal_speed = signed_speed(speeds[to], whole[to - 1].gear);
  }
  return request;
}

bool PlanRun::plan_in_vain(const PathPart& part, const PartEffort& effort, double trials) {
  const std::span<const PathSegment> whole = best();
  const double time = travel_time(best());
  const std::vector<double>& durations = workspace_.profile.durations;
  const std::size_t from = joint_next_to(part.begin * time, durations);
  const std::size_t to = joint_next_to(part.end * time, durations);
  if (to <= from || to - from == whole.size()) return false;

  const PlanRequest request = request_between(from, to);
  PlanLimits limits = query_.limits;
  limits.tree_poses = static_cast<std::uint32_t>(effort.tree_share * static_cast<double>(limits.tree_poses));
  const QueryContext query{query_.maps, query_.options, request, limits, query_.clock};
  PlanResult planned;
  planned.lower_bound =
      travel_time_lower_bound(request.start, request.goal, (request.goal.position() - request.start.position()).norm(),
                              map_.vehicle, request.reverse, query.ends(), map_.speed_zones.get());
  const auto of_part = std::span(durations).subspan(from, to - from);
  const double so_far = std::reduce(of_part.begin(), of_part.end());
  if (so_far <= (1.0 + effort.gap) * planned.lower_bound) return false;

  PlanRun run(query, workspace_within(), planned, effort.scope);
  const double cost = so_far + internal::clearance_cost(map_.clearance_cost.get(), whole.subspan(from, to - from));
  run.search_options_.faster_than = (1.0 + effort.slower) * cost;
  run.worth_length_ = (1.0 + effort.worth_length) * cost;
  follow_within(run);
  if (!run.found()) return true;
  Path joined = workspace_.find.search.empty_path();
  joined.insert(joined.end(), whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(from));
  joined.insert(joined.end(), run.best().begin(), run.best().end());
  joined.insert(joined.end(), whole.begin() + static_cast<std::ptrdiff_t>(to), whole.end());
  // The gear may change between parts too.
  if (cusps_of(joined) > gear_changes_.most || cost_of(joined) >= best_cost_) {
    workspace_.find.search.reuse(std::move(joined));
    return true;
  }
  const RefineMode mode = is_driven_forwards(joined) ? RefineMode::kForwards : RefineMode::kBothGears;
  keep(std::move(joined), {}, trials, mode);
  return false;
}

}  // namespace arcway::internal

#include "core/planner/plan_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

#include "arcway/angle.h"
#include "core/base/shortest_text.h"
#include "core/refine/shorten_path.h"
#include "core/reversing/find_reversing_path.h"
#include "core/roadmap/turn_circle.h"
#include "core/search/push_free.h"

namespace arcway::internal {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// A plan that may be slower than the best one by more than `gap`, a share, is tried again with maneuvers at both ends.
struct Retry {
  double gap;
  std::uint32_t poses;
};
constexpr std::array<Retry, 2> kQuickRetries{{{0.07, 6}, {0.1, 120}}};
constexpr std::array<Retry, 3> kRetries{{{0.04, 48}, {0.1, 120}, {0.2, 400}}};
// Then with circles in narrow places.
constexpr double kQuickNarrowPlacesGap = 0.1, kNarrowPlacesGap = 0.05;
// In trials of refinement, of what the options say: of a path in both gears, which has taken longer to find.
constexpr double kReversingEffort = 10.0;
// And by other ways on from the start, or to the goal: slower at first, they may be faster once refined.
constexpr double kOtherEndsGap = 0.04;
// That is, if they are slower by no more than this.
constexpr double kOtherEndsSlower = 0.03;
// Where an end is in a dead end, so that the tightest turns to both sides end before so far [rad], and the plan may be
// slower than the best one by more than the gap, trees look for wider turns out: with this share of their poses.
constexpr double kDeadEndTurn = kPi / 8.0, kTreesGap = 0.2;
constexpr double kTreesShare = 0.05;
// Trials of shortening a path of a tree, of those that the options say for refinement: each takes some microseconds.
// With as many as these, such paths are slower by up to 14 % than a known drive.
constexpr std::size_t kShorteningEffort = 10;
// Passes of finer trees where paths of slimmer bodies could not be made free: as many poses as those bodies take leave
// the last one out.
constexpr std::size_t kFinerPasses = 2;
// Of a path of a slimmer body, before it is pushed off what the real one touches: a path of fewer motions is made free
// more often, and is faster then.
constexpr std::size_t kSlimShortening = 2000;
// By this share at least that has to be faster: the ways on from where a maneuver saves next to nothing are known.
constexpr double kLeastGain = 0.001;
// No other way is looked for where it cannot be faster by more than this share.
constexpr double kOtherRoutesGap = 0.01;
// A second best path may become the best one when it is slower by no more than this share.
constexpr double kCloseSecond = 0.01;
// And is another one when it is slower by more than this.
constexpr double kSameCost = 1e-6;
// Labels of a search for another way, beside a quarter of those of the first search: where turns cost next to nothing,
// thousands of paths are as good as each other.
constexpr std::uint64_t kMoreExpanded = 1000;

}  // namespace

PlanRun::PlanRun(const PlannerOptions& options, const Roadmap& map, const PlanRequest& request,
                 const PlanLimits& limits, const StopClock& clock, PlanWorkspace& workspace, PlanResult& result)
    : options_(options),
      map_(map),
      request_(request),
      search_options_{options.heuristic, clock, request.cusp_cost},
      tree_poses_(options.maneuver_poses > 0 ? limits.tree_poses : 0),
      gear_changes_{.cost = request.cusp_cost},
      workspace_(workspace),
      result_(result),
      best_cost_(kInfinity),
      second_cost_(kInfinity) {
  if (request.max_gear_changes) gear_changes_.most = *request.max_gear_changes;
  search_options_.time_model = options.time_model;
  search_options_.suboptimality = options.suboptimality.value_or(0.0);
  search_options_.prefetch = limits.prefetch;
  workspace_.unrefined_times.clear();
}

double PlanRun::cost_of(const Path& path) {
  return travel_cost(path, map_.vehicle, request_.cusp_cost, workspace_.profile);
}

double PlanRun::travel_time(const Path& path) {
  speed_profile(path, map_.vehicle, workspace_.profile);
  return workspace_.profile.total_time;
}

// Runs a search and counts what it did.
template <class Find>
FoundPath PlanRun::search(const Find& find) {
  const Stopwatch searching;
  FoundPath found = find();
  PlanStatistics& s = result_.statistics;
  s.nodes_expanded += found.search.nodes_expanded;
  s.nodes_pushed += found.search.nodes_pushed;
  s.straights_checked += found.search.straights_checked;
  s.turns_checked += found.search.turns_checked;
  s.maneuver_poses += found.maneuver_poses;
  s.search_seconds += searching.seconds();
  result_.interrupted = result_.interrupted || found.search.interrupted;
  return found;
}

// Refines a path into the workspace.
void PlanRun::refine(const Path& path, double effort, bool reverse) {
  const Stopwatch refining;
  RefinedPath& refined = workspace_.refined;
  RefineOptions refinement = options_.refinement;
  refinement.max_trials = static_cast<std::uint32_t>(
      std::min(effort * refinement.max_trials, 1.0 * std::numeric_limits<std::uint32_t>::max()));
  if (refinement.max_trials == 0) {
    refined.path = path;
    return;
  }
  if (reverse) {
    refined = refine_reversing_path(path, map_.vehicle, *map_.queries.sweep, gear_changes_, refinement,
                                    search_options_.clock);
  } else {
    refine_path(path, request_.start, request_.goal, map_.vehicle, *map_.queries.sweep, refinement,
                search_options_.clock, workspace_.refine, refined);
  }
  PlanStatistics& s = result_.statistics;
  result_.interrupted = result_.interrupted || refined.interrupted;
  s.refine_trials += refined.trials;
  s.refine_improvements += refined.improvements;
  s.straights_checked += refined.straights_checked;
  s.turns_checked += refined.turns_checked;
  s.refine_seconds += refining.seconds();
}

// Refines a path, and keeps it if it is one of the two cheapest.
PlanRun::Times PlanRun::keep(Path&& path, double effort, bool reverse) {
  PlanStatistics& s = result_.statistics;
  const double unrefined = travel_time(path);
  workspace_.unrefined_times.push_back(unrefined);
  if (!found_) {
    first_expanded_ = s.nodes_expanded;
    s.first_path_seconds = total_.seconds();
    s.first_travel_time = unrefined;
    result_.first_path = path;
  }
  refine(path, effort, reverse);
  workspace_.find.search.reuse(std::move(path));
  const double cost = cost_of(workspace_.refined.path);
  if (cost < best_cost_) {
    // Of paths that refinement has led to the same place one is enough.
    if (best_cost_ > (1.0 + kSameCost) * cost) {
      std::swap(workspace_.second, workspace_.best);
      second_cost_ = best_cost_;
      second_unrefined_ = s.unrefined_travel_time;
    }
    std::swap(workspace_.best, workspace_.refined.path);
    best_cost_ = cost;
    s.unrefined_travel_time = unrefined;
    found_ = true;
  } else if (cost < second_cost_ && cost > (1.0 + kSameCost) * best_cost_) {
    std::swap(workspace_.second, workspace_.refined.path);
    second_cost_ = cost;
    second_unrefined_ = unrefined;
  }
  return {unrefined, cost};
}

Obstruction PlanRun::find_forwards(const PlanMaps& maps, double effort, const std::function<bool()>& no_passage) {
  FoundPath forwards = search([&] {
    return find_path(maps.plain, maps.narrow ? &*maps.narrow : nullptr, request_.start, request_.goal,
                     options_.maneuver_poses, no_passage, search_options_, workspace_.find);
  });
  if (forwards.search.path) {
    maps_ = &maps;
    const Roadmap& map = forwards.by_narrow_places ? maps.narrow->map() : maps.plain;
    const Times times = keep(std::move(*forwards.search.path), effort, false);
    fastest_ = {times, &map, 0, forwards.search.first_circle, forwards.search.last_circle};
  }
  return forwards.obstruction;
}

TreesEnd PlanRun::find_by_trees(const PlanMaps& maps, const SlimMaps& slim, double effort) {
  TreesEnd end = grow_trees(maps, {.poses = tree_poses_, .passes = 1}, effort);
  if (end.surroundings == Surroundings::kClosed) return end;
  for (std::size_t i = 0; i < SlimMaps::kSlimmer.size() && !found_; ++i) {
    const Roadmap* slimmer = search_options_.interrupted() ? nullptr : slim(i, search_options_.clock);
    if (!slimmer || !find_by_slimmer(maps, *slimmer, effort)) return end;
  }
  if (found_ || result_.interrupted || end.surroundings != Surroundings::kOpen) return end;
  return grow_trees(maps, {.poses = tree_poses_, .first_pass = 1, .passes = kFinerPasses, .looks_around = false},
                    effort);
}

bool PlanRun::find_by_slimmer(const PlanMaps& maps, const Roadmap& slim, double effort) {
  const auto widened = [&](const Path& path) -> std::optional<Path> {
    if (path.empty()) return std::nullopt;
    const Path shorter = shorten_path(path, slim.vehicle, *map_.queries.sweep, kSlimShortening, search_options_.clock);
    auto free = push_free(shorter, request_.goal, map_.body, map_, search_options_.clock);
    return free ? free : push_free(path, request_.goal, map_.body, map_, search_options_.clock);
  };
  TreesEnd end;
  FoundPath grown = search([&] {
    return search_trees(slim, request_.start, request_.goal, {.poses = tree_poses_, .passes = 1, .accept = widened},
                        search_options_, workspace_.find.search, end);
  });
  result_.statistics.tree_poses += end.poses;
  if (grown.search.path) keep_narrow(maps, std::move(*grown.search.path), effort);
  const bool is_hopeless = end.surroundings != Surroundings::kOpen || end.ran_dry;
  return found_ || end.refused > 0 || !is_hopeless;
}

TreesEnd PlanRun::grow_trees(const PlanMaps& maps, const TreeLimits& limits, double effort) {
  const Roadmap& map = maps.narrow ? maps.narrow->map(search_options_.clock) : maps.plain;
  TreesEnd end;
  FoundPath grown = search([&] {
    return search_trees(map, request_.start, request_.goal, limits, search_options_, workspace_.find.search, end);
  });
  result_.statistics.tree_poses += end.poses;
  if (grown.search.path) keep_narrow(maps, std::move(*grown.search.path), effort);
  return end;
}

// A path of many short motions.
void PlanRun::keep_narrow(const PlanMaps& maps, Path&& path, double effort) {
  const bool first = !found_;
  if (options_.refinement.max_trials > 0) {
    path = shorten_path(std::move(path), map_.vehicle, *map_.queries.sweep,
                        kShorteningEffort * options_.refinement.max_trials, search_options_.clock);
  }
  const Times times = keep(std::move(path), effort, false);
  if (!first && times.cost >= fastest_.times.cost) return;
  maps_ = &maps;
  fastest_ = {times, &maps.plain, 0, kNone, kNone};
}

// Whether obstacles end the tightest turns to both sides early.
bool PlanRun::is_in_dead_end(const Pose& pose, Direction direction) const {
  const double radius = map_.radii[0];
  return std::ranges::all_of(std::array{Side::kLeft, Side::kRight}, [&](Side side) {
    const HeadingSet free =
        map_.queries.sweep->free_headings({turn_circle(pose, radius, side).center, radius, side, map_.body});
    return free.reach(pose.heading, direction == Direction::kFromStart ? side : opposite(side)) < kDeadEndTurn;
  });
}

void PlanRun::improve_forwards(bool thorough) {
  const auto is_doubtful = [&](double gap) {
    return fastest_.times.cost > (1.0 + gap) * result_.lower_bound && !result_.interrupted;
  };
  const Roadmap& map = *fastest_.map;
  for (const Retry& retry : thorough ? std::span<const Retry>(kRetries) : kQuickRetries) {
    const auto poses = std::min(retry.poses, options_.maneuver_poses);
    if (poses <= 1 || !is_doubtful(retry.gap)) break;
    try_faster(map, poses);
  }
  if (maps_->narrow && &map == &maps_->plain && is_doubtful(thorough ? kNarrowPlacesGap : kQuickNarrowPlacesGap))
    try_faster(maps_->narrow->map(search_options_.clock), 0);
  if (thorough && is_doubtful(kOtherEndsGap)) try_other_ends();
  if (grows_trees() && is_doubtful(kTreesGap) &&
      (is_in_dead_end(request_.start, Direction::kFromStart) || is_in_dead_end(request_.goal, Direction::kToGoal)))
    grow_trees(*maps_,
               {.poses = static_cast<std::size_t>(kTreesShare * static_cast<double>(tree_poses_)),
                .passes = 1,
                .looks_around = false},
               1.0);
  for (const Roadmap* other : {&maps_->faster_turns, &maps_->slower_turns})
    find_other_route(*other, 1.0, fastest_.poses);
}

void PlanRun::try_faster(const Roadmap& map, std::size_t poses) {
  SearchOptions faster = search_options_;
  faster.least_gain = kLeastGain * fastest_.times.unrefined;
  faster.faster_than = fastest_.times.unrefined - faster.least_gain;
  faster.warm_start = true;
  FoundPath turning = search(
      [&] { return find_path_with_maneuvers(map, request_.start, request_.goal, poses, faster, workspace_.find); });
  if (!turning.search.path) return;
  const Times times = keep(std::move(*turning.search.path), 1.0, false);
  if (times.cost >= fastest_.times.cost) return;
  fastest_ = {times, &map, poses, turning.search.first_circle, turning.search.last_circle};
}

void PlanRun::try_other_ends() {
  if (fastest_.last_circle == kNone) return;
  SearchOptions other_last = search_options_;
  other_last.faster_than = (1.0 + kOtherEndsSlower) * fastest_.times.unrefined;
  SearchOptions other_first = other_last;
  other_last.not_last = fastest_.last_circle;
  other_first.not_first = fastest_.first_circle;
  for (const SearchOptions& other : {other_last, other_first})
    find_other_route(*fastest_.map, 1.0, fastest_.poses, other);
}

void PlanRun::find_other_route(const Roadmap& map, double effort, std::size_t poses) {
  find_other_route(map, effort, poses, search_options_);
}

void PlanRun::find_other_route(const Roadmap& map, double effort, std::size_t poses, SearchOptions bounded) {
  if (result_.interrupted || options_.refinement.max_trials == 0) return;
  if (best_cost_ <= (1.0 + kOtherRoutesGap) * result_.lower_bound) return;
  bounded.most_expanded = first_expanded_ / 4 + kMoreExpanded;
  FoundPath other = search(
      [&] { return find_path_with_maneuvers(map, request_.start, request_.goal, poses, bounded, workspace_.find); });
  if (!other.search.path) return;
  // Paths of one time to the last bit are one path.
  const auto& known = workspace_.unrefined_times;
  if (std::find(known.begin(), known.end(), travel_time(*other.search.path)) == known.end()) {
    keep(std::move(*other.search.path), effort, false);
  } else {
    workspace_.find.search.reuse(std::move(*other.search.path));
  }
}

void PlanRun::refine_best(double effort) {
  double& unrefined_time = result_.statistics.unrefined_travel_time;
  const auto refine_further = [&](const Path& path, double unrefined) {
    if (result_.interrupted) return;
    refine(path, effort, false);
    const double cost = cost_of(workspace_.refined.path);
    if (cost >= best_cost_) return;
    std::swap(workspace_.best, workspace_.refined.path);
    best_cost_ = cost;
    unrefined_time = unrefined;
  };
  const bool are_close = second_cost_ <= (1.0 + kCloseSecond) * best_cost_;
  refine_further(workspace_.best, unrefined_time);
  if (are_close) refine_further(workspace_.second, second_unrefined_);
}

void PlanRun::find_in_both_gears(const Roadmap& map, double distance) {
  const double unrefined = found_ ? result_.statistics.unrefined_travel_time : kInfinity;
  FoundPath both = search([&] {
    return find_reversing_path(map, {request_.start, request_.goal, distance, unrefined, gear_changes_.most},
                               search_options_, workspace_.find.search);
  });
  if (both.search.path) keep(std::move(*both.search.path), kReversingEffort, true);
}

}  // namespace arcway::internal

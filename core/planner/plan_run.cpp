#include "core/planner/plan_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "core/base/infinity.h"
#include "core/collision/close_ends.h"
#include "core/collision/path_cost.h"
#include "core/motion/travel_time_lower_bound.h"
#include "core/planner/strategy.h"
#include "core/refine/shorten_path.h"
#include "core/roadmap/turn_circle.h"

namespace arcway::internal {

PlanRun::PlanRun(const QueryContext& query, PlanWorkspace& workspace, PlanResult& result, Scope scope)
    : scope_(scope),
      query_(query),
      map_(query.map()),
      search_options_{query.options.heuristic, query.clock, query.request.cusp_cost},
      tree_poses_(query.options.maneuver_poses > 0 ? query.limits.tree_poses : 0),
      tree_effort_(kTreeEffort),
      gear_changes_{.cost = query.request.cusp_cost},
      workspace_(workspace),
      result_(result),
      why_{.reverse = query.request.reverse, .max_gear_changes = query.request.max_gear_changes},
      distance_((query.request.goal.position() - query.request.start.position()).norm()),
      are_turns_optimized_(optimizes_turns(query.map().vehicle, query.options.refinement)),
      best_cost_(kInfinity),
      second_cost_(kInfinity) {
  if (query.request.max_gear_changes) gear_changes_.most = *query.request.max_gear_changes;
  search_options_.ends = query.ends();
  search_options_.time_model = query.ends().is_moving() ? TimeModel::kProfile : query.options.time_model;
  search_options_.suboptimality = query.options.suboptimality.value_or(0.0);
  search_options_.prefetch = query.limits.prefetch;
  workspace_.best.clear();
  workspace_.unrefined_costs.clear();
  workspace_.ways.clear();
  workspace_.find.search.begin_query();
  if (map_.clearance_cost)
    close_ends_ = close_ends_cost(*map_.clearance_cost, map_.vehicle, *map_.outlines, query.request.start,
                                  query.request.goal, distance_);
}

void PlanRun::follow(std::span<const StrategyRow> rows) {
  rows_ = rows;
  for (const StrategyRow& row : rows) {
    if (has_proof_ || result_.interrupted) break;
    if (!holds(row.when)) continue;
    const double trials = query_.maps.tightest ? row.trials.several : row.trials.tightest;
    std::visit([&](const auto& step) { take(step, trials); }, row.step);
  }
  keep_all();
  if (!has_proof_ && forward_all_radii_) why_.obstruction = forward_all_radii_->obstruction();
}

bool PlanRun::holds(Known known) const {
  switch (known) {
    case Known::kAnything:
      return true;
    case Known::kNoPath:
      return !has_path();
    case Known::kPath:
      return has_path();
    case Known::kEasierPath:
      return has_path() && !is_narrowest_;
    case Known::kForwardPath:
      return has_forward_path();
    case Known::kByManeuvers:
      return has_forward_path() && fastest_.poses > 0;
    case Known::kPathElsewhere:
      return has_forward_path() && query_.maps.tightest && maps_ != &*query_.maps.tightest;
    case Known::kNarrowPath:
      return only_narrow_gears_;
    case Known::kGearChanges:
      return !is_forward_found_ && reversing_ && reversing_->path() && cusps_of(*reversing_->path()) > 0;
  }
  return false;
}

bool PlanRun::has_forward_path() const {
  const bool is_gear_path = reversing_ && reversing_->path();
  return is_forward_found_ && (!is_gear_path || best_cost_ <= (1.0 + kWorthForwards) * reversing_->cost());
}

bool PlanRun::holds(const When& when) {
  const PlanRequest& request = query_.request;
  if (when.whole && scope_ != Scope::kWhole) return false;
  if (!when.quick_parts && scope_ == Scope::kQuickPart) return false;
  if (!when.slim_body && scope_ == Scope::kSlimBody) return false;
  if (when.driving == Driving::kForwards && request.reverse) return false;
  const bool is_there = found_ && best().empty();
  if (when.driving == Driving::kBothGears && (!request.reverse || is_there)) return false;
  if (when.radii != Radii::kAny && (when.radii == Radii::kSeveral) != query_.maps.tightest.has_value()) return false;
  if (when.care != Care::kAny && (when.care == Care::kThorough) != is_thorough()) return false;
  if ((when.refines && !refines()) || (when.grows_trees && tree_poses_ == 0) || !holds(when.known)) return false;
  if (result_.statistics.tree_poses > when.most_tree_poses) return false;
  if (map_.world.vertices().size() > when.most_vertices) return false;
  if (when.has_speed_limits && !query_.maps.zone_routes) return false;
  if (when.has_one_way && !map_.one_way_zones) return false;
  if (when.gap > 0.0) {
    const double cost = when.driving == Driving::kBothGears ? reversing_search().cost() : fastest_.times.cost;
    if (!has_gap(cost, when.gap, when.gap_counts_zones)) return false;
  }
  if (when.best_gap > 0.0 && !has_gap(best_cost_, when.best_gap, when.gap_counts_zones)) return false;
  if (when.most_gap < kInfinity && has_gap(best_cost_, when.most_gap, when.gap_counts_zones)) return false;
  return when.tight_end == 0.0 || is_tight(request.start, Direction::kFromStart, when.tight_end) ||
         is_tight(request.goal, Direction::kToGoal, when.tight_end);
}

bool PlanRun::has_gap(double cost, double gap, bool counts_zones) {
  if (!(cost > (1.0 + gap) * least_cost())) return false;
  if (counts_zones || !map_.speed_zones || !is_thorough() || !found_) return true;
  const WithoutZones& without = without_zones();
  return cost - without.saves > (1.0 + gap) * (without.lower_bound + close_ends_);
}

bool PlanRun::is_tight(const Pose& pose, Direction direction, double angle) const {
  return std::ranges::all_of(std::array{Side::kLeft, Side::kRight}, [&](Side side) {
    const double radius = map_.radii.front().of(side);
    const TurningBody body{turn_circle(pose, radius, side).center, radius, side, map_.body};
    const Side towards = direction == Direction::kFromStart ? side : opposite(side);
    return map_.queries.sweep->reach(body, pose.heading, towards, workspace_.headings) < angle;
  });
}

void PlanRun::raise_lower_bound() {
  if (std::exchange(is_bound_raised_, true) || !query_.maps.point_distance) return;
  const Stopwatch bounding;
  const PlanRequest& request = query_.request;
  distance_ = (*query_.maps.point_distance)(request.start.position(), request.goal.position(), *map_.queries.visibility,
                                            workspace_.point, query_.clock);
  result_.lower_bound = travel_time_lower_bound(request.start, request.goal, distance_, map_.vehicle, request.reverse,
                                                query_.ends(), map_.speed_zones.get());
  result_.statistics.lower_bound_seconds = bounding.seconds();
}

double PlanRun::cost_of(const Path& path) {
  PathCosts with_cusps = costs();
  with_cusps.cusp_cost = query_.request.cusp_cost;
  return path_cost(path, map_.vehicle, with_cusps, workspace_.profile);
}

double PlanRun::travel_time(const Path& path) {
  return arcway::internal::travel_time(path, map_.vehicle, query_.ends(), workspace_.profile, map_.speed_zones.get());
}

RefineQuery PlanRun::refine_query(const Path& path, const Vehicle& vehicle, double trials) const {
  RefineOptions refinement = query_.options.refinement;
  refinement.max_trials = static_cast<std::uint32_t>(
      std::min(trials * refinement.max_trials, 1.0 * std::numeric_limits<std::uint32_t>::max()));
  return {.path = path,
          .start = query_.request.start,
          .goal = query_.request.goal,
          .vehicle = vehicle,
          .sweep = *map_.queries.sweep,
          .options = refinement,
          .clock = search_options_.clock,
          .world = &map_.world,
          .outlines = map_.outlines.get(),
          .ends = query_.ends(),
          .lower_bound = least_cost(),
          .speed_zones = map_.speed_zones.get(),
          .clearance_cost = map_.clearance_cost.get(),
          .sweep_backwards = query_.maps.in(Gear::kReverse).queries.sweep.get()};
}

void PlanRun::refine(const Path& path, double trials, RefineMode mode) {
  const Stopwatch refining;
  RefinedPath& refined = workspace_.refined;
  RefineQuery query = refine_query(path, map_.vehicle, trials);
  query.at_length = mode == RefineMode::kAtLength;
  if (query.options.max_trials == 0) {
    refined.path = path;
    return;
  }
  if (mode == RefineMode::kBothGears) {
    refined = refine_reversing_path(query, gear_changes_);
  } else {
    workspace_.refiner.refine(query, refined);
  }
  count(refined, refining.seconds());
}

void PlanRun::count(const RefinedPath& refined, double seconds) {
  PlanStatistics& s = result_.statistics;
  result_.interrupted = result_.interrupted || refined.interrupted;
  s.refine_trials += refined.trials;
  s.refine_improvements += refined.improvements;
  s.straights_checked += refined.straights_checked;
  s.turns_checked += refined.turns_checked;
  s.refine_seconds += seconds;
}

PlanWorkspace& PlanRun::workspace_within() {
  if (!workspace_.within) workspace_.within = std::make_unique<PlanWorkspace>();
  return *workspace_.within;
}

void PlanRun::follow_within(PlanRun& run) {
  run.follow(rows_);
  result_.statistics += run.result_.statistics;
  result_.interrupted = result_.interrupted || run.result_.interrupted;
}

const RefinedWay* PlanRun::refined_before(std::uint64_t way, double unrefined) const {
  const auto& ways = workspace_.ways;
  const auto known = std::ranges::find_if(
      ways, [&](const RefinedWay& w) { return w.way == way && unrefined > (1.0 - kMuchFaster) * w.unrefined; });
  return known != ways.end() ? &*known : nullptr;
}

PlanRun::Times PlanRun::keep(Path&& path, const Way& way, double trials, RefineMode mode) {
  PlanStatistics& s = result_.statistics;
  const double time = travel_time(path);
  if (time == kInfinity) return {kInfinity, kInfinity};
  const double unrefined = time + clearance_cost(path);
  workspace_.unrefined_costs.push_back(unrefined);
  if (const RefinedWay* known = refined_before(way.number, unrefined)) {
    workspace_.find.search.reuse(std::move(path));
    return {unrefined, known->cost};
  }
  if (!found_) first_expanded_ = s.nodes_expanded - soon_expanded_;
  note_first(path, time);
  is_forward_found_ = is_forward_found_ || mode != RefineMode::kBothGears;
  refine(path, trials, mode);
  workspace_.find.search.reuse(std::move(path));
  if (soon_) workspace_.find.search.reuse(*std::exchange(soon_, std::nullopt));
  const double cost = cost_of(workspace_.refined.path);
  if (way.number != 0 && are_turns_optimized_) workspace_.ways.push_back({way.number, unrefined, cost});
  if (cost < best_cost_) {
    // What was refined at length need not be refined again.
    if (!is_refined_at_length_ && best_cost_ > (1.0 + kSameCost) * cost)
      keep_second(workspace_.best, best_cost_, best_unrefined_);
    std::swap(workspace_.best, workspace_.refined.path);
    best_cost_ = cost;
    best_unrefined_ = {time, unrefined};
    best_way_ = way;
    is_refined_at_length_ = false;
    s.unrefined_travel_time = time;
    found_ = true;
  } else {
    if (!avoided_.empty()) avoided_.push_back(workspace_.refined.path);
    if (cost < second_cost_ && cost > (1.0 + kSameCost) * best_cost_)
      keep_second(workspace_.refined.path, cost, {time, unrefined});
  }
  return {unrefined, cost};
}

bool PlanRun::is_driven_forwards(const Path& path) {
  return std::ranges::all_of(path, [](const PathSegment& s) { return s.gear == Gear::kForward; });
}

void PlanRun::keep_second(Path& path, double cost, const Unrefined& unrefined) {
  if (!is_driven_forwards(path)) return;
  std::swap(workspace_.second, path);
  second_cost_ = cost;
  second_unrefined_ = unrefined;
}

void PlanRun::keep_forwards(On on, FoundPath&& found, double trials) {
  if (!found.search.path) return;
  const PlanMaps& maps = maps_on(on);
  const Roadmap& map = forward_search(on).used_narrow_places() ? maps.narrow->map() : maps.plain;
  const Times times = keep(std::move(*found.search.path), found.search.way, trials, RefineMode::kForwards);
  if (times.cost == kInfinity) return;
  maps_ = &maps;
  fastest_ = {times, &map, 0, found.search.first_circle, found.search.last_circle};
}

void PlanRun::note_first(const Path& path, double time) {
  if (scope_ != Scope::kWhole || std::exchange(is_first_noted_, true)) return;
  result_.statistics.first_path_seconds = total_.seconds();
  result_.statistics.first_travel_time = time;
  result_.first_path = path;
}

PlanRun::Times PlanRun::keep_shortened(Path&& path, std::uint32_t shortenings, double trials) {
  if (refines()) {
    const std::size_t most = std::size_t{shortenings} * query_.options.refinement.max_trials;
    path = shorten_path(std::move(path), map_.vehicle, *map_.queries.sweep, most, search_options_.clock, costs());
  }
  return keep_beside_roadmap(std::move(path), trials);
}

PlanRun::Times PlanRun::keep_beside_roadmap(Path&& path, double trials) {
  const bool is_first = !is_forward_found_;
  const Times times = keep(std::move(path), {}, trials, RefineMode::kForwards);
  if (times.cost < kInfinity && (is_first || times.cost < fastest_.times.cost)) {
    maps_ = &query_.maps.all;
    fastest_ = {times, &maps_->plain, 0, kNone, kNone};
  }
  return times;
}

void PlanRun::keep_all() {
  if (soon_) keep(*std::exchange(soon_, std::nullopt), {}, 0.0, RefineMode::kForwards);
  keep_in_both_gears();
}

void PlanRun::keep_in_both_gears() {
  if (!reversing_ || !reversing_->path() || std::exchange(kept_, reversing_->found()) == reversing_->found()) return;
  keep_from_both_gears(*reversing_->path());
}

void PlanRun::keep_from_both_gears(const Path& path) {
  if (cost_of(path) > (1.0 + kWorthBothGears) * best_cost_) return;
  keep(Path(path), {}, kBothGearsTrials, RefineMode::kBothGears);
}

}  // namespace arcway::internal

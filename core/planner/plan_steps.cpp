// The steps of PlanRun: what each row of the strategy does.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/infinity.h"
#include "core/collision/path_cost.h"
#include "core/gaps/enclosure.h"
#include "core/motion/speed_profile.h"
#include "core/motion/travel_time_lower_bound.h"
#include "core/planner/plan_run.h"
#include "core/planner/strategy.h"
#include "core/refine/shorten_path.h"
#include "core/search/one_way_routes.h"

namespace arcway::internal {

namespace {

// A rectangle in the checked body: it can drive wherever the body can. Nothing if none is known.
std::optional<Footprint> rectangle_in_body(const Roadmap& map) {
  const BodyShape* shape = map.vehicle.shape();
  if (shape == nullptr) return map.body;
  const Box& core = shape->core();
  if (core.empty()) return std::nullopt;
  return Footprint{core.max.x(), -core.min.x(), core.max.y(), -core.min.y()};
}

}  // namespace

const PlanMaps& PlanRun::maps_on(On on) const { return on == On::kTightest ? *query_.maps.tightest : query_.maps.all; }

ForwardSearch& PlanRun::forward_search(On on) {
  std::optional<ForwardSearch>& search = on == On::kTightest ? forward_tightest_ : forward_all_radii_;
  if (!search) {
    const PlanMaps& maps = maps_on(on);
    search.emplace(maps.plain, maps.narrow ? &*maps.narrow : nullptr,
                   ForwardSearch::Query{query_.request.start, query_.request.goal, query_.options.maneuver_poses},
                   search_options_, workspace_.find);
  }
  return *search;
}

void PlanRun::take(const JoinBySingleArcs& step, double trials) {
  const double haste = search_options_.suboptimality;
  const bool is_first = !found_;
  keep_forwards(step.on,
                search([&] { return forward_search(step.on).join_by_single_arcs(end_radii(step.end_radii), haste); }),
                trials);
  is_easy_ = is_easy_ || (is_first && found_ && step.end_radii < kEveryRadius);
}

void PlanRun::take(const FindSoon& step, double) {
  FoundPath found = search(
      [&] { return forward_search(On::kTightest).join_by_single_arcs(end_radii(step.end_radii), step.suboptimality); });
  soon_expanded_ = found.search.counts.nodes_expanded;
  if (!found.search.path) return;
  const double unrefined = travel_time(*found.search.path);
  if (unrefined == kInfinity) return;
  soon_ = std::move(found.search.path);
  note_first(*soon_, unrefined);
}

void PlanRun::take(const JoinByNarrowPlaces& step, double trials) {
  keep_forwards(step.on, search([&] { return forward_search(step.on).join_by_narrow_places(); }), trials);
}

void PlanRun::take(const JoinByManeuvers& step, double trials) {
  keep_forwards(step.on, search([&] { return forward_search(step.on).join_by_maneuvers(step.effort); }), trials);
}

void PlanRun::take(const JoinByManeuversAndNarrowPlaces& step, double trials) {
  keep_forwards(
      step.on, search([&] { return forward_search(step.on).join_by_maneuvers_and_narrow_places(step.poses); }), trials);
}

void PlanRun::take(const ProveBottleneck&, double) {
  result_.bottleneck = query_.maps.bottleneck(query_.request.start, query_.request.goal, query_.clock);
  has_proof_ = result_.bottleneck && result_.bottleneck->too_narrow();
  if (has_proof_) why_.obstruction = Obstruction::kBottleneck;
}

void PlanRun::take(const ProveDeadEnd& step, double) {
  const std::optional<Footprint> inscribed = rectangle_in_body(map_);
  if (!inscribed) return;
  const ForwardBody body{*inscribed, map_.vehicle.min_turning_radius(), *map_.queries.sweep, *map_.outlines};
  why_.dead_end = find_dead_end(query_.request.start, query_.request.goal, body, step.effort, query_.clock);
  has_proof_ = why_.dead_end.has_value();
}

void PlanRun::take(const ProveEnclosure& step, double) {
  const std::optional<Footprint> inscribed = rectangle_in_body(map_);
  if (!inscribed) return;
  why_.enclosure = find_enclosure(query_.request.start, query_.request.goal, {*inscribed, *map_.queries.sweep},
                                  step.boxes, query_.clock);
  has_proof_ = why_.enclosure.has_value();
}

void PlanRun::take(const GrowTrees& step, double trials) { grow(step, trials); }

std::optional<double> PlanRun::grow(const GrowTrees& step, double trials) {
  if (are_trees_vain_ || (step.only_in_the_open && surroundings_ != Surroundings::kOpen)) return std::nullopt;
  const PlanMaps& maps = query_.maps.all;
  const Roadmap& map = maps.narrow ? maps.narrow->map(query_.clock) : maps.plain;
  const TreeLimits limits{.poses = static_cast<std::size_t>(step.share * static_cast<double>(tree_poses_)),
                          .passes = step.passes,
                          .effort = tree_effort_,
                          .surroundings_effort = step.explores_surroundings ? &kSurroundingsEffort : nullptr,
                          .dead_end_passes = kDeadEndPasses,
                          .avoided = avoided_};
  TreesEnd end;
  FoundPath grown = search([&] {
    return search_trees({map, query_.request.start, query_.request.goal, limits}, search_options_,
                        workspace_.find.search, end);
  });
  result_.statistics.tree_poses += end.poses;
  if (step.explores_surroundings) surroundings_ = end.surroundings;
  why_.trees = end;
  if (!grown.search.path) return std::nullopt;
  return keep_shortened(std::move(*grown.search.path), step.shortenings, trials).cost;
}

bool PlanRun::holds(WhenSlim when) const {
  const bool is_closed = surroundings_ == Surroundings::kClosed;
  return when == WhenSlim::kUnlessClosed ? !is_closed : is_closed || is_path_refused_;
}

const Roadmap* PlanRun::slim_map(std::size_t body) const {
  return !has_path() || is_worth_memory() ? query_.maps.slim(body, query_.clock) : nullptr;
}

void PlanRun::take(const GrowSlimTrees& step, double trials) { grow(step, trials); }

std::optional<double> PlanRun::grow(const GrowSlimTrees& step, double trials) {
  const StopClock& clock = query_.clock;
  if (are_trees_vain_ || !holds(step.when)) return std::nullopt;
  const Roadmap* slim = slim_map(step.body);
  if (!slim) return std::nullopt;
  const Pose& goal = query_.request.goal;
  const PushSpace space = push_space();
  const auto widened = [&](const Path& path) -> std::optional<Path> {
    if (path.empty()) return std::nullopt;
    const Path shorter = shorten_path(path, slim->vehicle, *map_.queries.sweep, step.shortening, clock, costs());
    auto free = push_free(shorter, goal, space, clock);
    if (free || length_of(shorter) == length_of(path)) return free;
    return push_free(path, goal, space, clock);
  };
  const TreeLimits limits{.poses = tree_poses_,
                          .passes = step.passes,
                          .effort = kTreeEffort,
                          // Where the real body gets out, a slimmer one does.
                          .surroundings_effort = surroundings_ == Surroundings::kOpen ? nullptr : &kSurroundingsEffort,
                          .dead_end_passes = kDeadEndPasses,
                          .accept = widened,
                          .avoided = avoided_};
  TreesEnd end;
  FoundPath grown = search([&] {
    return search_trees({*slim, query_.request.start, goal, limits}, search_options_, workspace_.find.search, end);
  });
  result_.statistics.tree_poses += end.poses;
  const bool is_hopeless = end.surroundings != Surroundings::kOpen || end.ran_dry;
  is_path_refused_ = end.refused > 0;
  are_trees_vain_ = !is_path_refused_ && is_hopeless;
  is_narrow_ = is_narrow_ || (!has_path() && grown.search.path);
  if (!grown.search.path) return std::nullopt;
  if (cost_of(*grown.search.path) > (1.0 + step.slower) * best_cost_) return kInfinity;
  return keep_shortened(std::move(*grown.search.path), step.shortenings, trials).cost;
}

void PlanRun::take(const RaiseLowerBound&, double) { raise_lower_bound(); }

const PlanRun::WithoutZones& PlanRun::without_zones() {
  if (without_zones_) return *without_zones_;
  const PlanRequest& request = query_.request;
  Roadmap map = *fastest_.map;
  map.speed_zones = nullptr;
  SearchOptions options = search_options_;
  options.suboptimality += kHasteWithoutZones;
  options.faster_than = fastest_.times.unrefined;
  options.end_radii = end_radii(kEndRadii);
  const FoundPath found = search([&] {
    return find_path_with_maneuvers(map, {request.start, request.goal, 0}, options, workspace_.find_without_zones);
  });
  double saves = 0.0;
  if (const auto& path = found.search.path)
    saves = fastest_.times.unrefined -
            path_cost(*path, map.vehicle, {query_.ends(), nullptr, map.clearance_cost.get()}, workspace_.profile);
  return without_zones_.emplace(WithoutZones{
      travel_time_lower_bound(request.start, request.goal, distance_, map.vehicle, request.reverse, query_.ends()),
      std::max(0.0, saves)});
}

namespace {

// A lower bound on the time of a path that stops at each place of a route [s].
double time_with_stops(std::span<const Vec2> places, const Vehicle& vehicle, const EndSpeeds& ends) {
  double time = 0.0;
  for (std::size_t i = 1; i < places.size(); ++i)
    time += relaxed_segment_time((places[i] - places[i - 1]).norm(), i == 1 ? ends.start : 0.0, vehicle.max_speed(),
                                 i + 1 == places.size() ? ends.goal : 0.0, vehicle.max_acceleration());
  return time;
}

// From start to goal over places that are passed in the middle of turns.
std::vector<Pose> poses_over(std::span<const Vec2> places, const PlanRequest& request) {
  std::vector<Pose> poses{request.start};
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    const Vec2 along = (places[i] - places[i - 1]).normalized() + (places[i + 1] - places[i]).normalized();
    poses.push_back({places[i].x(), places[i].y(), std::atan2(along.y(), along.x())});
  }
  poses.push_back(request.goal);
  return poses;
}

}  // namespace

void PlanRun::take(const FollowZoneRoutes& step, double trials) {
  const Vec2 start = query_.request.start.position(), goal = query_.request.goal.position();
  for (const double slower : step.slower) {
    const auto route = query_.maps.zone_routes->find(start, goal, slower, query_.clock);
    if (!route) continue;
    // A route without bends is in the graph.
    if (route->places.size() == 2 || route->time > (1.0 - step.least_gain) * best_cost_) continue;
    const double most = (1.0 + step.unrefined) * best_cost_;
    if (time_with_stops(route->places, map_.vehicle, query_.ends()) > most) continue;
    const std::vector<Pose> poses = poses_over(route->places, query_.request);
    Path path;
    if (drive_over(poses, path) + 1 < poses.size() || travel_time(path) > most) continue;
    keep(std::move(path), {}, trials, RefineMode::kForwards);
  }
}

std::size_t PlanRun::drive_over(std::span<const Pose> poses, Path& path) {
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    SearchOptions leg = search_options_;
    leg.ends = {i == 0 ? query_.ends().start : 0.0, i + 2 == poses.size() ? query_.ends().goal : 0.0};
    leg.end_radii = end_radii(kEndRadii);
    const FoundPath found = search([&] {
      return find_path_with_maneuvers(map_, {poses[i], poses[i + 1], 0}, leg, workspace_.find);
    });
    if (!found.search.path) return i;
    path.insert(path.end(), found.search.path->begin(), found.search.path->end());
  }
  return poses.size() - 1;
}

void PlanRun::take(const FollowOneWayRoutes& step, double trials) {
  OneWayRoutes routes(map_, query_.request.start, query_.request.goal);
  for (std::uint32_t i = 0; i < step.most; ++i) {
    const auto poses = routes.find(query_.clock);
    if (!poses) return;
    Path path;
    const std::size_t legs = drive_over(*poses, path);
    if (legs + 1 == poses->size()) {
      keep_shortened(std::move(path), step.shortenings, trials);
      return;
    }
    routes.leave_out(legs);
  }
}

void PlanRun::take(const TryManeuvers& step, double trials) {
  const std::uint32_t poses = std::min(step.poses, query_.options.maneuver_poses);
  if (poses > 1) try_faster(*fastest_.map, poses, step.least_gain, trials);
}

void PlanRun::take(const TryNarrowPlaces& step, double trials) {
  if (maps_->narrow && fastest_.map == &maps_->plain)
    try_faster(maps_->narrow->map(query_.clock), 0, step.least_gain, trials);
}

void PlanRun::try_faster(const Roadmap& map, std::size_t poses, double least_gain, double trials) {
  SearchOptions faster = search_options_;
  faster.least_gain = least_gain * fastest_.times.unrefined;
  faster.faster_than = fastest_.times.unrefined - faster.least_gain;
  faster.warm_start = true;
  faster.end_radii = end_radii(kEndRadii);
  FoundPath turning = search([&] {
    return find_path_with_maneuvers(map, {query_.request.start, query_.request.goal, poses}, faster, workspace_.find);
  });
  if (!turning.search.path) return;
  const Times times = keep(std::move(*turning.search.path), turning.search.way, trials, RefineMode::kForwards);
  if (times.cost >= fastest_.times.cost) return;
  fastest_ = {times, &map, poses, turning.search.first_circle, turning.search.last_circle};
}

void PlanRun::take(const TryOtherLastCircle& step, double trials) {
  if (fastest_.last_circle == kNone) return;
  SearchOptions other = search_options_;
  other.faster_than = (1.0 + step.slower) * fastest_.times.unrefined;
  other.not_last = fastest_.last_circle;
  try_other_route(*fastest_.map, fastest_.poses, other, trials);
}

void PlanRun::take(const TryOtherFirstCircle& step, double trials) {
  if (fastest_.last_circle == kNone) return;
  SearchOptions other = search_options_;
  other.faster_than = (1.0 + step.slower) * fastest_.times.unrefined;
  other.not_first = fastest_.first_circle;
  try_other_route(*fastest_.map, fastest_.poses, other, trials);
}

void PlanRun::take(const TryOtherTurns& step, double trials) {
  const Roadmap& map = step.factor > 1.0 ? maps_->faster_turns : maps_->slower_turns;
  try_other_route(map, fastest_.poses, search_options_, trials);
}

void PlanRun::take(const TryOtherRadii& step, double trials) {
  const Roadmap* map = query_.maps.other.find({step.radii, step.factor});
  if (map == nullptr) return;
  SearchOptions other = search_options_;
  other.faster_than = (1.0 + step.slower) * best_cost_;
  try_other_route(*map, 0, other, trials);
}

void PlanRun::take(const TryOtherSides& step, double trials) {
  const Roadmap* map = query_.maps.other.find({step.radii, step.factor});
  if (map == nullptr) return;
  SearchOptions other = search_options_;
  std::uint64_t way = 0;  // whose turns are left out, up to `turn`
  std::size_t turn = 0;
  for (std::uint32_t searches = 0; searches < step.most; ++searches) {
    if (std::exchange(way, best_way_.number) != best_way_.number) turn = 0;
    if (turn >= best_way_.count) return;
    other.not_around = best_way_.turns[turn++];
    other.faster_than = (1.0 + step.slower) * best_cost_;
    try_other_route(*map, 0, other, trials);
  }
}

void PlanRun::try_other_route(const Roadmap& map, std::size_t poses, SearchOptions options, double trials) {
  options.most_expanded = first_expanded_ / 4 + kMoreExpanded;
  options.end_radii = end_radii(kEndRadii);
  FoundPath other = search([&] {
    return find_path_with_maneuvers(map, {query_.request.start, query_.request.goal, poses}, options, workspace_.find);
  });
  if (!other.search.path) return;
  // Paths of one cost to the last bit are one path.
  const auto& known = workspace_.unrefined_costs;
  const double unrefined = travel_time(*other.search.path) + clearance_cost(*other.search.path);
  if (std::ranges::find(known, unrefined) == known.end()) {
    keep(std::move(*other.search.path), other.search.way, trials, RefineMode::kForwards);
  } else {
    workspace_.find.search.reuse(std::move(*other.search.path));
  }
}

void PlanRun::take(const RefineBest& step, double trials) {
  if (best_cost_ > worth_length_ || std::exchange(is_refined_at_length_, true)) return;
  const bool are_close = std::exchange(second_cost_, kInfinity) <= (1.0 + step.close) * best_cost_;
  const bool is_far = refines() && scope_ == Scope::kWhole && has_gap(best_cost_, step.fewer_arcs_gap, true);
  if (is_far) drive_in_fewer_arcs(trials);
  refine_at_length(workspace_.best, best_unrefined_, trials);
  if (are_close) refine_at_length(workspace_.second, second_unrefined_, trials);
}

void PlanRun::refine_at_length(const Path& path, const Unrefined& unrefined, double trials) {
  refine(path, trials, RefineMode::kAtLength);
  const double cost = cost_of(workspace_.refined.path);
  if (cost >= best_cost_) return;
  std::swap(workspace_.best, workspace_.refined.path);
  best_cost_ = cost;
  best_unrefined_ = unrefined;
  result_.statistics.unrefined_travel_time = unrefined.time;
}

void PlanRun::take(const JoinArcs&, double trials) { drive_in_fewer_arcs(trials); }

void PlanRun::drive_in_fewer_arcs(double trials) {
  if (!is_driven_forwards(best())) return;
  const Path& fewer = workspace_.joiner.join(best(), {map_.vehicle, *map_.queries.sweep, query_.clock, costs()});
  if (fewer.size() >= best().size()) return;
  refine(fewer, 1.0, RefineMode::kForwards);
  std::swap(workspace_.fewer, workspace_.refined.path);
  refine_at_length(workspace_.fewer, best_unrefined_, trials);
}

ReversingSearch& PlanRun::reversing_search() {
  const double unrefined = found_ ? best_unrefined_.cost : best_cost_;
  if (reversing_) {
    reversing_->cut_off(unrefined);
  } else {
    reversing_.emplace(
        map_, query_.maps.in(Gear::kReverse),
        ReversingQuery{query_.request.start, query_.request.goal, distance_, unrefined, gear_changes_.most},
        search_options_, workspace_.find.search);
  }
  return *reversing_;
}

void PlanRun::take(const JoinBackwards&, double) {
  search([&] { return reversing_search().join_backwards(); });
}

void PlanRun::take(const JoinBetweenGears& step, double) {
  ReversingSearch& reversing = reversing_search();
  const bool are_beside_trees = !is_forward_found_ && reversing.path() && grown_ == reversing.found();
  const bool are_few = step.few && (are_beside_trees || map_.world.vertices().size() > step.few->vertices);
  search([&] { return reversing.join_between(are_few ? step.few->attachments : step.attachments); });
}

template <class Grow>
void PlanRun::grow_in_both_gears(const Grow& grow) {
  const std::size_t before = reversing_search().found();
  search(grow);
  if (reversing_->found() > before) grown_ = reversing_->found();
}

void PlanRun::take(const GrowGearTrees& step, double) {
  grow_in_both_gears([&] { return reversing_search().grow_gear_trees(step.poses); });
  only_narrow_gears_ = false;
}

void PlanRun::take(const GrowNarrowGearTrees& step, double) {
  search([&] { return reversing_search().grow_narrow_gear_trees(step.poses); });
  only_narrow_gears_ = is_narrowest_ = reversing_->path().has_value();
  is_narrow_ = is_narrow_ || only_narrow_gears_;
}

std::optional<Path> PlanRun::pushed_free(const Path& path, const Pose& goal, const Vehicle& slim, double trials) {
  const PushSpace space = push_space();
  if (refines()) {
    const Stopwatch refining;
    RefineQuery query = refine_query(path, slim, trials);
    query.start = path.front().start;
    query.goal = goal;
    query.ends = {};
    const RefinedPath refined = refine_reversing_path(query, gear_changes_);
    count(refined, refining.seconds());
    if (auto free = push_free(refined.path, goal, space, query_.clock)) return free;
  }
  return push_free(path, goal, space, query_.clock);
}

void PlanRun::take(const RefineBothGears&, double) { keep_in_both_gears(); }

void PlanRun::take(const GrowSlimGearTrees& step, double trials) {
  if (step.again ? !(are_slim_gears_grown_ && is_narrow_) : are_slim_gears_grown_) return;
  are_slim_gears_grown_ = true;
  is_narrow_ = is_narrow_ || !has_path();
  const ReversingSearch& reversing = reversing_search();
  const std::optional<Path> before = reversing.path();
  const double cost = reversing.cost();
  const double wanted = step.again ? std::min(best_cost_, cost) : cost;
  grow_slim_gear_trees(step, trials, (1.0 + step.slower) * wanted);
  // Refined, it may be the cheaper one.
  if (before && reversing.cost() > (1.0 - kMuchCheaper) * cost) keep_from_both_gears(*before);
}

void PlanRun::grow_slim_gear_trees(const GrowSlimGearTrees& step, double trials, double most) {
  for (std::size_t body = 0; body < kSlimBodies.size(); ++body) {
    const Roadmap* slim = slim_map(body);
    if (!slim) return;
    bool is_refused = false;
    const auto widened = [&](const Path& path, const Pose& goal) {
      std::optional<Path> free = pushed_free(path, goal, slim->vehicle, trials);
      is_refused = !free;
      return free;
    };
    grow_in_both_gears([&] {
      return reversing_search().grow_slim_gear_trees({*slim, step.poses, step.rest_weight, most}, widened);
    });
    if (!is_refused) return;
  }
}

}  // namespace arcway::internal

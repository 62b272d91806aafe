#include "arcway/alternatives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "arcway/angle.h"
#include "arcway/stop_clock.h"
#include "core/base/infinity.h"
#include "core/collision/memoized_sweep.h"
#include "core/collision/one_way_sweep.h"
#include "core/collision/walled_sweep.h"
#include "core/geometry/distance.h"
#include "core/geometry/predicates.h"
#include "core/model/outlines.h"
#include "core/refine/refine_path.h"
#include "core/tasks/plan_cost.h"
#include "core/zones/one_way_zones.h"

namespace arcway {

using namespace internal;

namespace {

constexpr double kPieceTurn = 1.5;     // largest turn of the pieces of arcs [rad], less than half a circle
constexpr std::size_t kMostGaps = 10;  // number of gaps of a path that are blocked, the narrowest first
constexpr std::size_t kSamplesPerSegment = 8;
// Suboptimality of the searches that compare routes: their paths are refined, and planned again at length. Of 192
// alternatives in twelve clutters, 28 cost more by 0.05 %, 21 cost less, and the mean costs 0.05 % more than without,
// for a fifth less time.
constexpr double kHasty = 0.2;

// A gap that a path passes: the nearest obstacles on both of its sides.
struct PassedGap {
  ObstacleId left, right;  // kNone: nothing on that side
  double width;
  std::array<LineSegment, 2> walls;  // from the path to either side
};

// The obstacle point nearest to a point on one side of a line through it.
struct Nearest {
  double distance = kInfinity;
  Vec2 point{0.0, 0.0};
  ObstacleId region = kNone;
};

Nearest nearest_on_side(const World& world, const Vec2& from, const Vec2& normal) {
  Nearest nearest;
  for (VertexId e = 0; e < world.edges().size(); ++e) {
    LineSegment edge = world.edges()[e];
    const double a = normal.dot(edge.a - from);
    const double b = normal.dot(edge.b - from);
    if (a <= 0.0 && b <= 0.0) continue;
    if (a < 0.0) edge.a += a / (a - b) * (edge.b - edge.a);
    if (b < 0.0) edge.b += b / (b - a) * (edge.a - edge.b);
    const Vec2 point = closest_point(from, edge);
    const double distance = (point - from).norm();
    if (distance < nearest.distance) nearest = {distance, point, world.obstacle_of(e)};
  }
  if (nearest.region != kNone) return nearest;
  const Box& box = world.box();
  const double far = box.empty() ? 0.0 : 4.0 * (box.max - box.min).norm() + (from - box.min).norm();
  return {far, from + far * normal, kNone};
}

// The gaps of a path; none if the clock is over before they are found.
std::vector<PassedGap> gaps_of(const PlanResult& plan, const Planner& planner, const StopClock& clock) {
  const World& world = planner.world();
  const Footprint body = planner.vehicle().footprint(planner.vehicle().safety_margin());
  const std::array<SweptRectangle, 2> ends = {swept_rectangle(plan.start, 0.0, body),
                                              swept_rectangle(plan.goal, 0.0, body)};
  std::vector<PassedGap> gaps;
  for (const TimedSegment& timed : plan.segments) {
    const PathSegment& s = timed.segment;
    for (std::size_t i = 1; i <= kSamplesPerSegment; ++i) {
      if (clock.is_over()) return {};
      const Pose pose = s.at(s.length * (static_cast<double>(i) / kSamplesPerSegment));
      const Vec2 side = perpendicular(direction_of(pose.heading));
      const Nearest left = nearest_on_side(world, pose.position(), side);
      const Nearest right = nearest_on_side(world, pose.position(), -side);
      if (left.region == right.region) continue;
      const PassedGap gap{left.region,
                          right.region,
                          left.distance + right.distance,
                          {LineSegment{pose.position(), left.point}, LineSegment{pose.position(), right.point}}};
      const bool at_an_end = std::any_of(gap.walls.begin(), gap.walls.end(), [&](const LineSegment& wall) {
        return intersects(wall, ends[0]) || intersects(wall, ends[1]);
      });
      if (at_an_end) continue;
      const auto known = std::find_if(gaps.begin(), gaps.end(),
                                      [&](const PassedGap& p) { return p.left == gap.left && p.right == gap.right; });
      if (known == gaps.end()) {
        gaps.push_back(gap);
      } else if (gap.width < known->width) {
        *known = gap;
      }
    }
  }
  std::stable_sort(gaps.begin(), gaps.end(), [](const PassedGap& a, const PassedGap& b) { return a.width < b.width; });
  if (gaps.size() > kMostGaps) gaps.resize(kMostGaps);
  return gaps;
}

// Whether a point lies between an arc of less than half a circle and its chord.
bool is_cut_off(const PathSegment& arc, const Vec2& from, const Vec2& to, const Vec2& point) {
  const double side = sign_of(arc.gear) * arc.curvature;  // > 0: the arc lies to the right of its chord
  if (orientation(from, to, point) * side >= 0.0) return false;
  const Vec2 center = arc.start.position() + perpendicular(direction_of(arc.start.heading)) / arc.curvature;
  return (point - center).norm() * std::abs(arc.curvature) < 1.0;
}

// The angle by which a path turns about a point [rad]. An arc turns like its chord, but in the other direction about
// points between the two.
double turn_about(std::span<const PathSegment> path, const Vec2& point) {
  double turn = 0.0;
  for (const PathSegment& s : path) {
    const auto pieces =
        static_cast<std::size_t>(std::max(1.0, std::ceil(s.length * std::abs(s.curvature) / kPieceTurn)));
    Vec2 from = s.start.position();
    for (std::size_t i = 1; i <= pieces; ++i) {
      const Vec2 to = s.at(s.length * (static_cast<double>(i) / static_cast<double>(pieces))).position();
      const Vec2 a = from - point, b = to - point;
      turn += std::atan2(cross(a, b), a.dot(b));
      if (!s.is_line() && is_cut_off(s, from, to, point)) turn += std::copysign(kTwoPi, sign_of(s.gear) * s.curvature);
      from = to;
    }
  }
  return turn;
}

// The angle by which a path turns about each obstacle, at a corner of it [rad]. Nothing if the clock is over before.
std::optional<std::vector<double>> turns_of(std::span<const PathSegment> path, const World& world,
                                            const StopClock& clock) {
  std::vector<double> turns;
  turns.reserve(world.obstacle_count());
  for (ObstacleId o = 0; o < world.obstacle_count(); ++o) {
    if (clock.is_over()) return std::nullopt;
    turns.push_back(turn_about(path, world.vertex(world.vertices_of(o).first)));
  }
  return turns;
}

// Whether two paths pass every obstacle on the same side, told by their turns.
bool are_same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) { return std::abs(x - y) <= kPi; });
}

class AlternativeSearch {
 public:
  AlternativeSearch(const Planner& planner, const PlanRequest& request, const PlanLimits& limits)
      : planner_(planner),
        request_(request),
        limits_(limits),
        clock_(limits.time, limits.stop),
        remembered_(std::make_shared<MemoizedSweep>(planner.queries().sweep)) {}

  std::vector<PlanResult> run(std::size_t count) {
    const PlanResult fastest = planner_.plan(request_, limits_);
    if (count > 1 && fastest.solved()) choose_quick_options(fastest);
    std::optional<Route> first = route_of(fastest, {});
    if (!first) return {fastest};
    taken_.push_back(std::move(*first));
    while (taken_.back().plan.solved() && taken_.size() < count && !interrupted()) {
      branch(taken_.back());
      if (!take_next()) break;
    }
    std::vector<PlanResult> plans;
    for (Route& route : taken_) plans.push_back(std::move(route.plan));
    std::stable_sort(plans.begin(), plans.end(),
                     [&](const PlanResult& a, const PlanResult& b) { return cost_of(a) < cost_of(b); });
    return plans;
  }

 private:
  struct Route {
    PlanResult plan;
    double cost;                     // that the plan has, or will have once it is refined
    std::vector<double> turns;       // about the obstacles
    std::vector<LineSegment> walls;  // it was planned with
  };

  [[nodiscard]] PlanLimits rest() const {
    PlanLimits rest = limits_;
    rest.time = clock_.seconds_left();
    return rest;
  }
  [[nodiscard]] bool interrupted() const { return clock_.is_over(); }
  [[nodiscard]] double cost_of(const PlanResult& plan) const { return internal::cost_of(plan, request_.cusp_cost); }

  // The route of a plan; nothing if the clock is over before it can be told from others.
  [[nodiscard]] std::optional<Route> route_of(PlanResult plan, std::vector<LineSegment> walls) const {
    std::optional<std::vector<double>> turns = turns_of(plan.path(), planner_.world(), clock_);
    if (!turns) return std::nullopt;
    const double cost = cost_of(plan);
    return Route{std::move(plan), cost, std::move(*turns), std::move(walls)};
  }

  // Chooses the options of the plans that compare routes: one search and refinement. They leave out reversing,
  // maneuvers and added circles where the first plan did without.
  void choose_quick_options(const PlanResult& first) {
    const auto is_backward = [](const TimedSegment& s) { return s.segment.gear == Gear::kReverse; };
    quick_request_.reverse = std::any_of(first.segments.begin(), first.segments.end(), is_backward);
    quick_ = planner_.options();
    quick_.refinement.max_trials = 0;
    quick_.point_robot_lower_bound = false;
    quick_.suboptimality = std::max(kHasty, quick_.suboptimality.value_or(0.0));
    PlannerOptions single_arcs = quick_;
    single_arcs.maneuver_poses = 0;
    single_arcs.gap_circles = false;
    if (plan_with({}, single_arcs, quick_request_).solved()) quick_ = single_arcs;
  }

  // Adds the routes that avoid one of the gaps of a route.
  void branch(const Route& route) {
    const std::vector<LineSegment> walls = route.walls;
    for (const PassedGap& gap : gaps_of(route.plan, planner_, clock_)) {
      if (interrupted()) return;
      std::vector<LineSegment> more = walls;
      more.insert(more.end(), gap.walls.begin(), gap.walls.end());
      PlanResult plan = plan_with(more, quick_, quick_request_);
      if (!plan.solved()) continue;
      std::optional<Route> other = route_of(std::move(plan), std::move(more));
      if (!other || !is_new(*other, taken_) || !is_new(*other, open_)) continue;
      other->cost = std::min(other->cost, refined_cost(*other));
      open_.push_back(std::move(*other));
    }
  }

  // The cost of a quick plan's path after refinement. A path with gear changes is taken as it is.
  [[nodiscard]] double refined_cost(const Route& route) {
    if (quick_request_.reverse) return route.cost;
    if (!outlines_) outlines_.emplace(planner_.world());
    const auto sweep = obeying(std::make_shared<const WalledSweep>(remembered_, route.walls), one_way_zones_);
    const Path path = route.plan.path();
    const RefinedPath refined = refine_path({.path = path,
                                             .start = request_.start,
                                             .goal = request_.goal,
                                             .vehicle = planner_.vehicle(),
                                             .sweep = *sweep,
                                             .options = planner_.options().refinement,
                                             .clock = clock_,
                                             .world = &planner_.world(),
                                             .outlines = &*outlines_,
                                             .ends = {request_.start_speed, request_.goal_speed}});
    return refined.travel_time + clearance_cost(planner_, refined.path);
  }

  // Plans the cheapest of the open routes with all options, and takes it. False if there is none.
  bool take_next() {
    while (!open_.empty()) {
      const auto best = std::ranges::min_element(open_, {}, &Route::cost);
      Route route = std::move(*best);
      open_.erase(best);
      PlanResult better = plan_with(route.walls, planner_.options(), request_);
      if (better.solved() && cost_of(better) < cost_of(route.plan)) {
        std::optional<Route> other = route_of(std::move(better), route.walls);
        if (other) route = std::move(*other);
      }
      if (!is_new(route, taken_)) continue;
      taken_.push_back(std::move(route));
      return true;
    }
    return false;
  }

  [[nodiscard]] PlanResult plan_with(const std::vector<LineSegment>& walls, PlannerOptions options,
                                     const PlanRequest& request) const {
    QuerySet queries = planner_.queries();
    queries.sweep = std::make_shared<WalledSweep>(remembered_, walls);
    options.graph_mode = GraphMode::kLazy;
    const SerialExecutor serial;
    try {
      const StoppableExecutor executor(serial, clock_);
      const World& world = planner_.world();
      const Planner walled(world, planner_.vehicle(), backend_of(world, queries, planner_.visibility_rows(), executor),
                           options);
      PlanLimits limits = rest();
      // Most of these plans have no path. In eight worlds driven/... where trees found the first route and no other was
      // found without, 4,000 poses a plan and 32,000 in all found none. They took four to ten times as long.
      limits.tree_poses = 0;
      return walled.plan(request, limits);
    } catch (const Canceled&) {
      return {};
    }
  }

  static bool is_new(const Route& route, const std::vector<Route>& known) {
    return std::ranges::none_of(known, [&](const Route& other) { return are_same(other.turns, route.turns); });
  }

  const Planner& planner_;
  const PlanRequest& request_;
  const PlanLimits& limits_;
  StopClock clock_;
  std::shared_ptr<const SweepQuery> remembered_;  // of the world without walls
  std::shared_ptr<const OneWayZones> one_way_zones_ = OneWayZones::of(planner_.world());
  std::optional<Outlines> outlines_;  // once a path is refined
  PlannerOptions quick_;
  PlanRequest quick_request_ = request_;
  std::vector<Route> taken_, open_;
};

}  // namespace

std::vector<PlanResult> plan_alternatives(const Planner& planner, const PlanRequest& request, std::size_t count,
                                          const PlanLimits& limits) {
  if (count == 0) throw std::invalid_argument("alternatives: at least one must be asked for");
  return AlternativeSearch(planner, request, limits).run(count);
}

bool same_route(std::span<const PathSegment> a, std::span<const PathSegment> b, const World& world) {
  const StopClock never;
  return are_same(*turns_of(a, world, never), *turns_of(b, world, never));
}

}  // namespace arcway

#include "arcway/tour.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "arcway/angle.h"
#include "core/base/infinity.h"
#include "core/base/stopwatch.h"
#include "core/collision/path_cost.h"
#include "core/model/pose_text.h"
#include "core/motion/speed_profile.h"
#include "core/motion/travel_time_lower_bound.h"
#include "core/planner/no_path.h"
#include "core/planner/planner_inputs.h"
#include "core/tasks/plan_cost.h"
#include "core/zones/speed_zones.h"

namespace arcway {

using namespace internal;

namespace {

constexpr int kHeadings = 24;         // number of headings tried where the heading is open
constexpr double kFinestStep = 2e-3;  // smallest step of an open heading [rad]
constexpr double kLeastGain = 1e-6;   // share of the cost that another heading must save
// Poses of trees for one leg, and for all legs to a place, in those of one plan. Trees grow if a place has a choice of
// poses and no leg was found without. Most poses have no path, so that many legs are tried with few poses each.
constexpr double kTreesOfALeg = 0.5, kTreesOfAPlace = 2.0;

// A pose at a place, and the best tour that ends there.
struct Stop {
  Pose pose;
  std::size_t place;        // among those of its stage
  double cost = kInfinity;  // cost of the tour that ends here at rest [s]
  std::size_t from = 0;     // stop of the stage before
  PlanResult leg = {};      // from there
  Path path = {};           // from the start
};
using Stage = std::vector<Stop>;

class TourPlanner {
 public:
  TourPlanner(const Planner& planner, const TourRequest& request, const PlanLimits& limits)
      : planner_(planner), request_(request), limits_(limits) {}

  Tour run() {
    Tour tour = best_in_time();
    tour.plan.start = request_.start;
    tour.plan.interrupted = interrupted_;
    statistics_.unrefined_travel_time = tour.plan.statistics.unrefined_travel_time;
    statistics_.total_seconds = watch_.seconds();
    tour.plan.statistics = statistics_;
    return tour;
  }

 private:
  Tour best_in_time() {
    if (!may_be_cut() || !has_choices()) return best_tour();
    Tour first = first_tour();
    if (interrupted_) return first;
    Tour best = best_tour();
    const auto cost = [this](const Tour& tour) { return cost_of(tour.plan, request_.cusp_cost); };
    return interrupted_ && cost(first) < cost(best) ? first : best;
  }
  [[nodiscard]] bool may_be_cut() const { return limits_.time < kInfinity || limits_.stop.stop_possible(); }
  // Whether some place has several poses.
  [[nodiscard]] bool has_choices() const {
    const auto is_open = [](const Place& place) { return !place.heading.has_value(); };
    return request_.goals.size() > 1 || is_open(request_.goals.front()) ||
           std::ranges::any_of(request_.waypoints, is_open);
  }

  void begin() {
    stages_.clear();
    stages_.push_back({{request_.start, 0, 0.0}});
    failure_.reset();
    failure_stage_ = 0;
  }

  // By the first pose reached at each place: a few plans for each leg, where the best tour takes hundreds.
  Tour first_tour() {
    begin();
    for (const Place& place : request_.waypoints) {
      add_stage({&place, 1});
      if (reach_first() == nullptr) return finish(nullptr);
    }
    add_stage(request_.goals);
    return finish(reach_first());
  }

  Tour best_tour() {
    begin();
    for (const Place& place : request_.waypoints) {
      add_stage({&place, 1});
      reach_all();
      if (!any_reached() && reach_by_trees() == nullptr) return finish(nullptr);
    }
    add_stage(request_.goals);
    Stop* best = reach_one();
    if (best == nullptr) best = reach_by_trees();
    if (best != nullptr && !request_.goals[best->place].heading) turn_goal(*best);
    return finish(best);
  }

  void add_stage(std::span<const Place> places) {
    Stage stage;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Vec2& p = places[i].position;
      if (places[i].heading) {
        stage.push_back({{p.x(), p.y(), *places[i].heading}, i});
        continue;
      }
      const Vec2 ahead = p - stages_.back().front().pose.position();
      const double straight = ahead.isZero(0.0) ? 0.0 : std::atan2(ahead.y(), ahead.x());
      for (int k = 0; k < kHeadings; ++k)
        stage.push_back({{p.x(), p.y(), wrap_signed(straight + kTwoPi * k / kHeadings)}, i});
    }
    stages_.push_back(std::move(stage));
    undecided_.clear();
  }

  PlanResult plan_leg(const Pose& from, const Pose& to, std::uint32_t tree_poses) {
    PlanLimits rest = limits_;
    rest.time -= watch_.seconds();
    rest.tree_poses = tree_poses;
    PlanResult leg = planner_.plan({.start = from,
                                    .goal = to,
                                    .reverse = request_.reverse,
                                    .cusp_cost = request_.cusp_cost,
                                    .max_gear_changes = request_.max_gear_changes},
                                   rest);
    statistics_ += leg.statistics;
    interrupted_ = interrupted_ || leg.interrupted;
    return leg;
  }

  // Whether the current leg has several poses to begin or to end at.
  [[nodiscard]] bool has_choice() const { return stages_.back().size() > 1 || stages_[stages_.size() - 2].size() > 1; }

  [[nodiscard]] double leg_lower_bound(const Pose& from, const Pose& to) const {
    return travel_time_lower_bound(from, to, (to.position() - from.position()).norm(), planner_.vehicle(),
                                   request_.reverse);
  }
  // Upper bound on the extra time of a stop there over driving on [s]; 0 at the start.
  [[nodiscard]] double cost_of_a_stop(std::size_t stage) const {
    return stage == 0 ? 0.0 : planner_.vehicle().top_speed() / planner_.vehicle().max_acceleration();
  }

  // Finds the best tour to a stop of the last stage, if it costs less than `cutoff`.
  void reach(Stop& stop, double cutoff) {
    const Stage& before = stages_[stages_.size() - 2];
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < before.size(); ++i)
      if (before[i].cost < kInfinity)
        order.emplace_back(
            before[i].cost - cost_of_a_stop(stages_.size() - 2) + leg_lower_bound(before[i].pose, stop.pose), i);
    std::sort(order.begin(), order.end());
    for (const auto& [least, i] : order) {
      // Infinite where the planner refuses a pose, and says why.
      if (least >= std::min(cutoff, stop.cost) && least < kInfinity) return;
      const Certainty certainty = reach_from(i, stop, has_choice() ? 0 : limits_.tree_poses);
      if (has_choice() && certainty == Certainty::kGaveUp) undecided_.push_back({least, i, &stop});
    }
  }

  // Plans a leg from a stop of the stage before, and keeps it if that makes the tour to the stop cheaper.
  // @return the certainty of the leg, with a path or without.
  Certainty reach_from(std::size_t from, Stop& stop, std::uint32_t tree_poses) {
    const Stop& before = stages_[stages_.size() - 2][from];
    PlanResult leg = plan_leg(before.pose, stop.pose, tree_poses);
    const Certainty certainty = leg.certainty;
    if (!leg.solved()) {
      // An interrupted leg might have had a path.
      if (!failure_ || failure_stage_ != stages_.size() || (leg.interrupted && !failure_->interrupted))
        failure_ = as_requested(std::move(leg), before, stop);
      failure_stage_ = stages_.size();
      return certainty;
    }
    Path path = before.path;
    const Path on = leg.path();
    path.insert(path.end(), on.begin(), on.end());
    const double cost = path_cost(path, planner_.vehicle(), {.zones = zones_.get(), .cusp_cost = request_.cusp_cost}) +
                        clearance_cost(planner_, path);
    if (cost >= stop.cost) return certainty;
    stop.cost = cost;
    stop.from = from;
    stop.leg = std::move(leg);
    stop.path = std::move(path);
    return certainty;
  }

  // Grows trees where no stop of the last stage was reached, nearest legs first. Returns the first stop reached; null
  // if none is.
  Stop* reach_by_trees() {
    std::ranges::stable_sort(undecided_, {}, &Undecided::least);
    const auto share = [&](double part) { return static_cast<std::uint64_t>(part * limits_.tree_poses); };
    const std::uint64_t most = statistics_.tree_poses + share(kTreesOfAPlace);
    for (const Undecided& leg : undecided_) {
      if (statistics_.tree_poses >= most || interrupted_) break;
      reach_from(leg.from, *leg.stop, static_cast<std::uint32_t>(share(kTreesOfALeg)));
      if (leg.stop->cost < kInfinity) return leg.stop;
    }
    return nullptr;
  }

  // A leg without a path, with places named as the request has them: the planner knows poses only.
  [[nodiscard]] PlanResult as_requested(PlanResult leg, const Stop& from, const Stop& to) const {
    const auto rename = [&](const std::string& name, const std::string& place) {
      const std::size_t at = leg.reason.find(name);
      if (at != std::string::npos) leg.reason.replace(at, name.size(), place);
    };
    rename("the start " + shortest_text(leg.start), name_of(from, stages_.size() - 2));
    rename("the goal " + shortest_text(leg.goal), name_of(to, stages_.size() - 1));
    if (is_waypoint_stage(stages_.size() - 2) && leg.status == PlanStatus::kStartBlocked)
      leg.status = PlanStatus::kWaypointBlocked;
    if (is_waypoint_stage(stages_.size() - 1)) {
      if (leg.status == PlanStatus::kGoalInCollision) leg.status = PlanStatus::kWaypointInCollision;
      if (leg.status == PlanStatus::kGoalOutsideBounds) leg.status = PlanStatus::kWaypointOutsideBounds;
      if (leg.status == PlanStatus::kGoalBlocked) leg.status = PlanStatus::kWaypointBlocked;
      leg.goal = first_goal();
    }
    // Another pose may have a path.
    if (has_choice() && leg.status != PlanStatus::kStartInCollision && leg.status != PlanStatus::kStartOutsideBounds)
      leg.certainty = Certainty::kGaveUp;
    return leg;
  }
  [[nodiscard]] bool is_waypoint_stage(std::size_t stage) const {
    return stage > 0 && stage <= request_.waypoints.size();
  }
  [[nodiscard]] Pose first_goal() const {
    const Place& goal = request_.goals.front();
    return {goal.position.x(), goal.position.y(), goal.heading.value_or(0.0)};
  }
  [[nodiscard]] std::string name_of(const Stop& stop, std::size_t stage) const {
    if (stage == 0) return "the start " + shortest_text(stop.pose);
    const bool is_waypoint = is_waypoint_stage(stage);
    const Place& place = is_waypoint ? request_.waypoints[stage - 1] : request_.goals[stop.place];
    return (is_waypoint ? "the waypoint " : "the goal ") +
           (place.heading ? shortest_text(stop.pose) : shortest_text(place.position));
  }

  void reach_all() {
    for (Stop& stop : stages_.back()) reach(stop, kInfinity);
  }
  [[nodiscard]] bool any_reached() const {
    return std::any_of(stages_.back().begin(), stages_.back().end(), [](const Stop& s) { return s.cost < kInfinity; });
  }

  // The first stop of the last stage that is reached, those with the least lower bounds first; null if none is. Of the
  // stage before, one stop was reached.
  Stop* reach_first() {
    const Stage& before = stages_[stages_.size() - 2];
    const Stop& from = *std::ranges::min_element(before, {}, &Stop::cost);
    std::vector<std::pair<double, Stop*>> order;
    for (Stop& stop : stages_.back()) order.emplace_back(leg_lower_bound(from.pose, stop.pose), &stop);
    std::ranges::stable_sort(order, {}, &std::pair<double, Stop*>::first);
    for (const auto& next : order) {
      reach(*next.second, kInfinity);
      if (next.second->cost < kInfinity) return next.second;
      if (interrupted_) break;
    }
    return nullptr;
  }

  // The cheapest stop of the last stage; null if there is none.
  Stop* reach_one() {
    Stop* best = nullptr;
    for (Stop& stop : stages_.back()) {
      reach(stop, best != nullptr ? best->cost : kInfinity);
      if (stop.cost < (best != nullptr ? best->cost : kInfinity)) best = &stop;
    }
    return best;
  }

  // Improves the open heading of the goal.
  void turn_goal(Stop& best) {
    const auto improve = [&](double heading) {
      Stop other{{best.pose.x, best.pose.y, wrap_signed(heading)}, best.place};
      reach(other, best.cost);
      if (!(other.cost < (1.0 - kLeastGain) * best.cost)) return false;
      best = std::move(other);
      return true;
    };
    for (double step = 0.5 * kTwoPi / kHeadings; step >= kFinestStep;) {
      const double heading = best.pose.heading;
      const bool better = improve(heading_of_last_line(best)) || improve(heading + step) || improve(heading - step);
      if (!better) step *= 0.5;
    }
  }

  // The heading of the last line of a tour if it led to the goal without a turn.
  [[nodiscard]] static double heading_of_last_line(const Stop& stop) {
    const std::vector<TimedSegment>& segments = stop.leg.segments;
    for (std::size_t i = segments.size(); i-- > 0;) {
      const PathSegment& s = segments[i].segment;
      if (!s.is_line()) continue;
      const Vec2 ahead = sign_of(s.gear) * (stop.pose.position() - s.start.position());
      return std::atan2(ahead.y(), ahead.x());
    }
    return stop.pose.heading;
  }

  Tour finish(const Stop* last) {
    Tour tour;
    PlanResult& plan = tour.plan;
    if (last == nullptr) {
      plan = std::move(failure_.value());
      // The time limit of a leg was what the legs before had left.
      if (plan.status == PlanStatus::kTimeLimit) plan.reason = time_limit_reason(limits_);
      if (!request_.waypoints.empty())
        plan.reason = "leg " + std::to_string(stages_.size() - 1) + " of " +
                      std::to_string(request_.waypoints.size() + 1) + ": " + plan.reason;
    } else {
      tour.goal = last->place;
      join(legs_to(*last), tour);
    }
    return tour;
  }

  [[nodiscard]] std::vector<const PlanResult*> legs_to(const Stop& last) const {
    std::vector<const PlanResult*> legs;
    const Stop* stop = &last;
    for (std::size_t stage = stages_.size() - 1; stage > 0; --stage) {
      legs.insert(legs.begin(), &stop->leg);
      stop = &stages_[stage - 1][stop->from];
    }
    return legs;
  }

  void join(const std::vector<const PlanResult*>& legs, Tour& tour) const {
    PlanResult& plan = tour.plan;
    plan.status = PlanStatus::kSolved;
    plan.goal = legs.back()->goal;
    plan.scene = legs.back()->scene;
    plan.min_clearance = kInfinity;
    for (const PlanResult* leg : legs) {
      if (leg != legs.front()) tour.passed.push_back(plan.segments.size());
      plan.clearance_is_lower_bound = plan.clearance_is_lower_bound || leg->clearance_is_lower_bound;
      if (leg->min_clearance < plan.min_clearance) {
        plan.min_clearance = leg->min_clearance;
        plan.clearance_segment = leg->clearance_segment;
        plan.clearance_index = plan.segments.size() + leg->clearance_index;
      }
      plan.segments.insert(plan.segments.end(), leg->segments.begin(), leg->segments.end());
      plan.length += leg->length;
      plan.statistics.unrefined_travel_time += leg->statistics.unrefined_travel_time;
    }
    const Path path = plan.path();
    const SpeedProfile profile = speed_profile(path, planner_.vehicle(), {}, zones_.get());
    for (std::size_t i = 0; i < path.size(); ++i)
      plan.segments[i] = {path[i], profile.speeds[i], profile.speeds[i + 1], profile.durations[i]};
    plan.travel_time = profile.total_time;
    plan.close_driving = planner_.close_driving(path);
    plan.close_in_zones = planner_.close_in_zones(path);
    const bool one_plan = legs.size() == 1 && request_.goals.size() == 1 && request_.goals[0].heading;
    if (one_plan) {
      plan.lower_bound = legs.front()->lower_bound;
    } else {
      plan.lower_bound = straight_line_lower_bound();
    }
  }

  // The lower bound of straight lines over all places to the nearest goal, from rest to rest. A goal inside an obstacle
  // cannot be reached, unless the body lies beside the reference point.
  [[nodiscard]] double straight_line_lower_bound() const {
    Vec2 at = request_.start.position();
    double length = 0.0;
    for (const Place& place : request_.waypoints) {
      length += (place.position - at).norm();
      at = place.position;
    }
    const Vehicle& vehicle = planner_.vehicle();
    const bool covers_reference = vehicle.body().covers_reference();
    double nearest = kInfinity;
    for (const Place& goal : request_.goals)
      if (!covers_reference || planner_.queries().distance->containing(goal.position) == kNone)
        nearest = std::min(nearest, (goal.position - at).norm());
    if (!(length + nearest > 0.0)) return 0.0;
    const double top_speed = request_.reverse ? vehicle.top_speed() : vehicle.max_speed();
    return (1.0 - 1e-12) * segment_time(length + nearest, 0.0, top_speed, 0.0, vehicle.max_acceleration());
  }

  // A leg to the last stage that was planned without trees, not found, and not proved impossible.
  struct Undecided {
    double least;      // lower bound on the cost of the tour over it [s]
    std::size_t from;  // stop of the stage before
    Stop* stop;
  };

  const Planner& planner_;
  std::shared_ptr<const SpeedZones> zones_ = SpeedZones::of(planner_.world());
  const TourRequest& request_;
  const PlanLimits& limits_;
  Stopwatch watch_;
  std::vector<Stage> stages_;
  std::vector<Undecided> undecided_;
  PlanStatistics statistics_;
  bool interrupted_ = false;
  std::optional<PlanResult> failure_;  // the first of its stage, or the first one interrupted
  std::size_t failure_stage_ = 0;
};

void require_places(const std::string& name, std::span<const Place> places, const Vehicle& vehicle) {
  for (std::size_t i = 0; i < places.size(); ++i)
    require_pose(places.size() == 1 ? name : name + " " + std::to_string(i + 1),
                 {places[i].position.x(), places[i].position.y(), places[i].heading.value_or(0.0)}, vehicle);
}

}  // namespace

Tour plan_tour(const Planner& planner, const TourRequest& request, const PlanLimits& limits) {
  if (request.goals.empty()) throw std::invalid_argument("tour: no goal");
  require_places("waypoint", request.waypoints, planner.vehicle());
  require_places("goal", request.goals, planner.vehicle());
  return TourPlanner(planner, request, limits).run();
}

std::string to_string(const Tour& tour) {
  if (!tour.plan.solved()) return to_string(tour.plan);
  const std::size_t waypoints = tour.passed.size();
  return to_string(tour.plan) + ", to goal " + std::to_string(tour.goal) + " over " + std::to_string(waypoints) +
         (waypoints == 1 ? " waypoint" : " waypoints");
}

}  // namespace arcway

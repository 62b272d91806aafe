#include "core/search/one_way_routes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <tuple>
#include <variant>

#include "arcway/angle.h"
#include "core/model/world_checks.h"
#include "core/zones/one_way_zones.h"

namespace arcway::internal {

namespace {

constexpr std::size_t kMostEdgesWithPlaces = 60, kMostEdges = 1000;  // of all zones; a line is compared with each
constexpr std::array kPlaces{0.25, 0.5, 0.75};                       // on an edge, as shares of its length
constexpr std::array kShares{0.0, -0.9, 0.9};  // directions of crossings, in tolerances from the zone's heading
constexpr double kFirstMove = 0.125;           // of a place, as a share of the distance from start to goal
constexpr int kHalvings = 8;                   // of moves
constexpr int kMovesOfAStep = 8;               // one after another
constexpr std::uint32_t kStartPlace = 0, kGoalPlace = 1;

template <class Visit>
void visit_edges(const Ring& ring, std::size_t every, Visit&& visit) {
  for (std::size_t i = 0; i < ring.size(); i += every) visit(ring[i], ring[(i + 1) % ring.size()]);
}

Pose pose_along(const Vec2& from, const Vec2& direction) {
  return {from.x(), from.y(), std::atan2(direction.y(), direction.x())};
}

// How far a ray from a place on the border of a zone leads inside it; nothing if it does not.
std::optional<double> length_inside(const Zone& zone, const Vec2& place, const Vec2& direction) {
  std::vector<double> crossings;
  const auto add = [&](const Vec2& a, const Vec2& b) {
    const Vec2 edge = b - a;
    const double across = cross(direction, edge);
    if (across == 0.0) return;
    const double on_edge = cross(a - place, direction) / across, along = cross(a - place, edge) / across;
    if (on_edge >= 0.0 && on_edge <= 1.0 && along > OneWayZones::kBorder) crossings.push_back(along);
  };
  visit_edges(zone.area.outer, 1, add);
  for (const Ring& hole : zone.area.holes) visit_edges(hole, 1, add);
  if (crossings.size() % 2 == 0) return std::nullopt;
  return std::ranges::min(crossings);
}

}  // namespace

OneWayRoutes::OneWayRoutes(const Roadmap& map, const Pose& start, const Pose& goal)
    : map_(map), start_(start), goal_(goal), places_{start.position(), goal.position()} {
  left_out_.insert({kStartPlace, kGoalPlace});
  std::size_t edges = 0;
  for (const std::uint32_t z : map.one_way_zones->zones()) edges += vertex_count_of({&map.world.zones()[z].area, 1});
  if (edges > kMostEdges) return;
  for (const std::uint32_t z : map.one_way_zones->zones())
    add_places(map.world.zones()[z], 1 + edges / kMostEdgesWithPlaces);
}

void OneWayRoutes::add_places(const Zone& zone, std::size_t every) {
  const auto add = [&](const Vec2& a, const Vec2& b) {
    for (const double share : kPlaces) add_crossings(zone, a + share * (b - a));
  };
  visit_edges(zone.area.outer, every, add);
  for (const Ring& hole : zone.area.holes) visit_edges(hole, every, add);
  add_corners(zone.area.outer, every);
}

void OneWayRoutes::add_corners(const Ring& ring, std::size_t every) {
  const double radius = map_.vehicle.min_turning_radius();
  for (std::size_t i = 0; i < ring.size(); i += every) {
    const Vec2 before = (ring[i] - ring[(i + ring.size() - 1) % ring.size()]).normalized();
    const Vec2 after = (ring[(i + 1) % ring.size()] - ring[i]).normalized();
    const Vec2 out = before - after;
    if (!out.isZero(0.0)) places_.push_back(ring[i] + radius * out.normalized());
  }
}

void OneWayRoutes::add_crossings(const Zone& zone, const Vec2& place) {
  places_.push_back(place);
  const auto& rule = std::get<OneWay>(zone.rule);
  for (const double share : kShares) {
    if (share != 0.0 && rule.tolerance == 0.0) continue;
    const Vec2 direction = direction_of(rule.heading + share * rule.tolerance);
    for (const Vec2& d : {direction, Vec2(-direction)})
      if (const auto length = length_inside(zone, place, d)) places_.emplace_back(place + *length * d);
  }
}

bool OneWayRoutes::is_allowed(const Vec2& from, const Vec2& to) const {
  const Vec2 d = to - from;
  return map_.one_way_zones->allows_line(pose_along(from, d), d.norm(), Gear::kForward);
}

std::optional<std::vector<Pose>> OneWayRoutes::find(const StopClock& clock) {
  // A line to a place: by the estimate of the route over it, and its length up to there.
  using Entry = std::tuple<double, double, std::uint32_t, std::uint32_t>;
  const auto n = static_cast<std::uint32_t>(places_.size());
  const double turn = map_.vehicle.min_turning_radius();
  std::vector<std::uint32_t> before(n, kStartPlace);
  std::vector<bool> done(n, false);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  open.push({0.0, 0.0, kStartPlace, kStartPlace});
  while (!done[kGoalPlace]) {
    if (open.empty() || clock.is_over()) return std::nullopt;
    const auto [estimate, length, from, here] = open.top();
    open.pop();
    // Most lines are never come to: zones are asked about the others alone.
    if (done[here] || (here != kStartPlace && !is_allowed(places_[from], places_[here]))) continue;
    done[here] = true;
    before[here] = from;
    for (std::uint32_t to = 0; to < n; ++to) {
      if (done[to] || left_out_.contains({here, to})) continue;
      const double there = length + (places_[to] - places_[here]).norm() + turn;
      open.push({there + (places_[kGoalPlace] - places_[to]).norm(), there, here, to});
    }
  }
  route_ = {kGoalPlace};
  while (route_.back() != kStartPlace) route_.push_back(before[route_.back()]);
  std::ranges::reverse(route_);
  std::vector<Vec2> route;
  for (const std::uint32_t place : route_) route.push_back(places_[place]);
  shorten(route, clock);
  return poses_over(route);
}

void OneWayRoutes::shorten(std::vector<Vec2>& route, const StopClock& clock) const {
  double step = kFirstMove * (places_[kGoalPlace] - places_[kStartPlace]).norm();
  for (int halving = 0; halving < kHalvings; ++halving, step *= 0.5)
    for (std::size_t count : {std::size_t{2}, std::size_t{1}})
      for (std::size_t i = 1; i + count < route.size(); ++i)
        for (const Vec2& by : {Vec2(step, 0.0), Vec2(-step, 0.0), Vec2(0.0, step), Vec2(0.0, -step)})
          for (int again = 0; again < kMovesOfAStep && !clock.is_over() && move(route, i, count, by);) ++again;
}

bool OneWayRoutes::move(std::vector<Vec2>& route, std::size_t i, std::size_t count, const Vec2& by) const {
  const std::size_t last = i + count - 1;
  const Vec2 &before = route[i - 1], &behind = route[last + 1], first_moved = route[i] + by,
             last_moved = route[last] + by;
  const double length = (route[i] - before).norm() + (behind - route[last]).norm();
  if ((first_moved - before).norm() + (behind - last_moved).norm() >= length) return false;
  const auto may_drive = [&](const Vec2& from, const Vec2& to) {
    return is_allowed(from, to) && map_.queries.visibility->visible({from, to});
  };
  if (!may_drive(before, first_moved) || !may_drive(last_moved, behind)) return false;
  if (count > 1 && !may_drive(first_moved, last_moved)) return false;
  for (std::size_t k = i; k <= last; ++k) route[k] += by;
  return true;
}

std::vector<Pose> OneWayRoutes::poses_over(const std::vector<Vec2>& route) const {
  std::vector<Pose> poses{start_};
  for (std::size_t i = 1; i + 1 < route.size(); ++i) {
    const Vec2 in = (route[i] - route[i - 1]).normalized(), out = (route[i + 1] - route[i]).normalized();
    // Zones limit a line that may not be driven the other way round.
    const bool is_in_limited = !is_allowed(route[i], route[i - 1]);
    const bool is_out_limited = !is_allowed(route[i + 1], route[i]);
    const Vec2 along = is_in_limited == is_out_limited ? Vec2(in + out) : is_in_limited ? in : out;
    poses.push_back(pose_along(route[i], along));
  }
  poses.push_back(goal_);
  return poses;
}

void OneWayRoutes::leave_out(std::size_t line) { left_out_.insert({route_[line], route_[line + 1]}); }

}  // namespace arcway::internal

#include "core/search/zone_routes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>

#include "arcway/angle.h"
#include "arcway/executor.h"
#include "core/base/infinity.h"
#include "core/zones/one_way_zones.h"
#include "core/zones/speed_zones.h"

namespace arcway::internal {

namespace {

constexpr double kRouteNodes = 8000.0;                 // nodes of the grid, about
constexpr double kGridBorder = 0.25;                   // border around map and zones, as a share of their extent
constexpr double kRowDistance = 0.866025403784438647;  // of neighboring rows, in steps of the grid
constexpr double kDescentStep = 0.5;                   // in steps of the grid
constexpr double kDescentEnd = 1.5;                    // distance from the goal, in steps of the grid
constexpr double kLongestDescent = 16.0;               // in half the border of the grid

// A place is left out if that costs no more than this share of the time between its neighbors. At first that is
// rounding, in the end what matters little.
constexpr double kSavesTime = 1e-9, kMattersLittle = 5e-4;
constexpr int kTriedDirections = 8;  // of motions at a place
constexpr int kRouteRounds = 3;      // of moves of all places
constexpr int kRouteHalvings = 6;    // of the length of a move, from a step of the grid on

}  // namespace

Vec2 ZoneRoutes::Grid::place(std::int64_t column, std::int64_t row) const {
  return corner + step * Vec2(static_cast<double>(column) + 0.5 * static_cast<double>(row % 2),
                              kRowDistance * static_cast<double>(row));
}

// Times from all nodes to one place.
class ZoneRoutes::Search {
 public:
  Search(const Grid& grid, double slower, double top_speed)
      : grid_(grid),
        slower_(slower),
        top_speed_(top_speed),
        times_(grid.speeds.size(), kInfinity),
        done_(grid.speeds.size(), false) {}

  // Until the nodes around `start` have their times; false if the clock is over before.
  bool spread(const Vec2& goal, const Vec2& start, const StopClock& clock) {
    goal_ = goal;
    for (const std::int64_t node : around(goal))
      if (is_open(node)) reach(node, (place(node) - goal).norm() * slowness(node));
    const std::array<std::int64_t, 3> last = around(start);
    StopTicker ticker(clock);
    while (!open_.empty()) {
      if (ticker.is_over()) return false;
      const auto [time, node] = open_.top();
      open_.pop();
      if (done_[index(node)]) continue;
      done_[index(node)] = true;
      for (int k = 0; k < 6; ++k) update(neighbor(node, k), node, k);
      if (std::ranges::all_of(last, [&](std::int64_t n) { return !is_open(n) || done_[index(n)]; })) break;
    }
    return true;
  }

  // The steepest descent from a place to the goal. Nothing if it ends before.
  [[nodiscard]] std::optional<std::vector<Vec2>> descend(const Vec2& from) const {
    std::vector<Vec2> places{from};
    double time = kInfinity;
    const auto most = static_cast<std::size_t>(kLongestDescent * static_cast<double>(grid_.columns + grid_.rows));
    while ((places.back() - goal_).norm() > kDescentEnd * grid_.step) {
      const Vec2 next = next_place(places.back(), time);
      const double there = time_at(next);
      if (!(there < time) || places.size() > most) return std::nullopt;
      time = there;
      places.push_back(next);
    }
    places.push_back(goal_);
    return places;
  }

 private:
  using Entry = std::pair<double, std::int64_t>;

  static std::size_t index(std::int64_t node) { return static_cast<std::size_t>(node); }
  [[nodiscard]] bool is_open(std::int64_t node) const { return node >= 0 && grid_.speeds[index(node)] > 0.0; }
  [[nodiscard]] double slowness(std::int64_t node) const {
    const double speed = grid_.speeds[index(node)];
    return speed < top_speed_ ? slower_ / speed : 1.0 / speed;
  }
  [[nodiscard]] Vec2 place(std::int64_t node) const { return grid_.place(node % grid_.columns, node / grid_.columns); }
  [[nodiscard]] std::int64_t node_at(std::int64_t column, std::int64_t row) const {
    return column < 0 || row < 0 || column >= grid_.columns || row >= grid_.rows ? -1 : row * grid_.columns + column;
  }
  // The neighbors counter-clockwise, from the one to the right on; -1 outside the grid.
  [[nodiscard]] std::int64_t neighbor(std::int64_t node, int k) const {
    const std::int64_t row = node / grid_.columns, column = node % grid_.columns, left = column + row % 2 - 1;
    const std::array<std::array<std::int64_t, 2>, 6> all{{{column + 1, row},
                                                          {left + 1, row + 1},
                                                          {left, row + 1},
                                                          {column - 1, row},
                                                          {left, row - 1},
                                                          {left + 1, row - 1}}};
    const auto& [c, r] = all[static_cast<std::size_t>(k)];
    return node_at(c, r);
  }
  // The corners of the triangle that has a place; -1 outside the grid.
  [[nodiscard]] std::array<std::int64_t, 3> around(const Vec2& p) const {
    const Vec2 q = (p - grid_.corner) / grid_.step;
    const auto row = static_cast<std::int64_t>(std::floor(q.y() / kRowDistance));
    const double up = q.y() / kRowDistance - static_cast<double>(row);
    const double shift = row % 2 == 0 ? 0.0 : 0.5;
    // Along the row below, and from the lower left to the upper right.
    const double along = q.x() - shift - 0.5 * up;
    const auto column = static_cast<std::int64_t>(std::floor(along));
    const std::int64_t upper = column + (row % 2 == 0 ? 0 : 1);
    if (along - static_cast<double>(column) + up <= 1.0)
      return {node_at(column, row), node_at(column + 1, row), node_at(upper, row + 1)};
    return {node_at(column + 1, row), node_at(upper + 1, row + 1), node_at(upper, row + 1)};
  }

  void reach(std::int64_t node, double time) {
    if (time >= times_[index(node)]) return;
    times_[index(node)] = time;
    open_.push({time, node});
  }

  // The time of a node from a neighbor that is done, its k-th one seen from there, and from the corners that both have.
  void update(std::int64_t node, std::int64_t from, int k) {
    if (!is_open(node) || done_[index(node)]) return;
    const double time = times_[index(from)], own = 0.5 * (slowness(node) + slowness(from));
    double best = time + own * grid_.step;
    for (const int beside : {(k + 1) % 6, (k + 5) % 6}) {
      const std::int64_t other = neighbor(from, beside);
      if (!is_open(other) || !done_[index(other)]) continue;
      const double across = grid_.step * (slowness(node) + slowness(from) + slowness(other)) / 3.0;
      const double rise = times_[index(other)] - time;
      // A front that comes from between the two; see the times of a plane wave at the corners of a triangle.
      if (std::abs(rise) <= 0.5 * across)
        best = std::min(best, time + 0.5 * (rise + std::sqrt(3.0 * (across * across - rise * rise))));
    }
    reach(node, best);
  }

  [[nodiscard]] double time_of(std::int64_t node) const { return node < 0 ? kInfinity : times_[index(node)]; }

  // By the plane through the times of the corners around; infinity where one is blocked.
  [[nodiscard]] double time_at(const Vec2& p) const {
    const auto corners = around(p);
    if (std::ranges::any_of(corners, [&](std::int64_t n) { return time_of(n) == kInfinity; })) return nearest_time(p);
    return time_of(corners[0]) + gradient(corners).dot(p - place(corners[0]));
  }
  [[nodiscard]] double nearest_time(const Vec2& p) const {
    for (const std::int64_t n : around(p))
      if (n >= 0 && (place(n) - p).norm() < 1e-6 * grid_.step) return time_of(n);
    return kInfinity;
  }
  [[nodiscard]] Vec2 gradient(const std::array<std::int64_t, 3>& corners) const {
    const Vec2 a = place(corners[1]) - place(corners[0]), b = place(corners[2]) - place(corners[0]);
    const double at = time_of(corners[1]) - time_of(corners[0]), bt = time_of(corners[2]) - time_of(corners[0]);
    return Vec2(at * b.y() - bt * a.y(), bt * a.x() - at * b.x()) / cross(a, b);
  }

  // Down the plane around a place, or to the lowest node near by where that leads nowhere.
  [[nodiscard]] Vec2 next_place(const Vec2& p, double time) const {
    const auto corners = around(p);
    if (std::ranges::none_of(corners, [&](std::int64_t n) { return time_of(n) == kInfinity; })) {
      const Vec2 next = p - kDescentStep * grid_.step * gradient(corners).normalized();
      if (time_at(next) < std::min(time, time_at(p))) return next;
    }
    std::int64_t lowest = -1;
    for (const std::int64_t corner : corners) {
      if (corner < 0) continue;
      for (int k = -1; k < 6; ++k) {
        const std::int64_t node = k < 0 ? corner : neighbor(corner, k);
        if (time_of(node) < time_of(lowest)) lowest = node;
      }
    }
    return lowest < 0 ? p : place(lowest);
  }

  const Grid& grid_;
  double slower_, top_speed_;
  Vec2 goal_{0.0, 0.0};
  std::vector<double> times_;  // by node [s]
  std::vector<bool> done_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

namespace {

// Whether F may drive any way at a place. What a zone forbids shows in one of some directions, if not in all.
bool is_any_way_allowed(const OneWayZones& zones, const Vec2& p) {
  for (int i = 0; i < kTriedDirections; ++i)
    if (zones.zone_against({p.x(), p.y(), kTwoPi * i / kTriedDirections}, Gear::kForward) != kNone) return false;
  return true;
}

}  // namespace

ZoneRoutes::Grid ZoneRoutes::make_grid(const StopClock& clock) const {
  Box box;
  for (const Zone& zone : map_.world.zones())
    for (const Vec2& p : zone.area.outer) box.extend(p);
  for (const Vec2& p : map_.world.vertices()) box.extend(p);
  box = box.grown(kGridBorder * (box.max - box.min).maxCoeff());
  const Vec2 extent = box.max - box.min;
  Grid grid;
  grid.corner = box.min;
  grid.step = std::sqrt(extent.x() * extent.y() / (kRowDistance * kRouteNodes));
  grid.columns = static_cast<std::int64_t>(extent.x() / grid.step) + 2;
  grid.rows = static_cast<std::int64_t>(extent.y() / (kRowDistance * grid.step)) + 2;
  const double narrow = 0.5 * map_.body.width(), top = map_.vehicle.max_speed();
  StopTicker ticker(clock);
  for (std::int64_t row = 0; row < grid.rows; ++row)
    for (std::int64_t column = 0; column < grid.columns; ++column) {
      end_if_over(ticker);
      const Vec2 p = grid.place(column, row);
      const bool is_blocked = map_.queries.distance->containing(p) != kNone ||
                              map_.queries.distance->closest(p).distance < narrow ||
                              (map_.one_way_zones && !is_any_way_allowed(*map_.one_way_zones, p));
      grid.speeds.push_back(is_blocked ? 0.0 : std::min(top, map_.speed_zones->cap_at(p)));
    }
  return grid;
}

double ZoneRoutes::time_between(const Vec2& from, const Vec2& to, std::vector<SpeedZones::Stretch>& parts) const {
  const Vec2 d = to - from;
  if (d.isZero(0.0)) return 0.0;
  if (!map_.queries.visibility->visible({from, to})) return kInfinity;
  const PathSegment line{{from.x(), from.y(), std::atan2(d.y(), d.x())}, d.norm(), 0.0};
  if (map_.one_way_zones && !map_.one_way_zones->allows_line(line.start, line.length, Gear::kForward)) return kInfinity;
  map_.speed_zones->cut(line, parts);
  double time = 0.0;
  for (const SpeedZones::Stretch& part : parts) time += part.length / std::min(map_.vehicle.max_speed(), part.cap);
  return time;
}

namespace {

// The sum of the times from a place over another one to a third.
template <class Time>
double time_over(const Vec2& from, const Vec2& over, const Vec2& to, Time&& time) {
  return time(from, over) + time(over, to);
}

// Leaves out the place that costs least, again and again.
// @param cost  largest cost of a place, as a share of the time between its neighbors.
template <class Time>
void leave_out(std::vector<Vec2>& places, double cost, Time&& time, const StopClock& clock) {
  const auto cost_of = [&](std::size_t i) {
    return time(places[i - 1], places[i + 1]) - (1.0 + cost) * time_over(places[i - 1], places[i], places[i + 1], time);
  };
  std::vector<double> costs(places.size(), kInfinity);
  for (std::size_t i = 1; i + 1 < places.size() && !clock.is_over(); ++i) costs[i] = cost_of(i);
  while (!clock.is_over()) {
    const auto cheapest = std::ranges::min_element(costs);
    if (!(*cheapest <= 0.0)) return;
    const auto i = cheapest - costs.begin();
    places.erase(places.begin() + i);
    costs.erase(cheapest);
    for (const auto k : {i - 1, i})
      if (k > 0 && static_cast<std::size_t>(k) + 1 < places.size())
        costs[static_cast<std::size_t>(k)] = cost_of(static_cast<std::size_t>(k));
  }
}

// Moves each place between its neighbors as long as that saves time.
template <class Time>
void move(std::vector<Vec2>& places, double step, Time&& time, const StopClock& clock) {
  for (std::size_t i = 1; i + 1 < places.size() && !clock.is_over(); ++i) {
    double best = time_over(places[i - 1], places[i], places[i + 1], time);
    double length = step;
    for (int halving = 0; halving < kRouteHalvings; ++halving, length *= 0.5)
      for (const Vec2& by : {Vec2(length, 0.0), Vec2(-length, 0.0), Vec2(0.0, length), Vec2(0.0, -length)}) {
        const Vec2 there = places[i] + by;
        const double moved = time_over(places[i - 1], there, places[i + 1], time);
        if (moved >= best) continue;
        best = moved;
        places[i] = there;
      }
  }
}

}  // namespace

ZoneRoutes::Route ZoneRoutes::shortest_over(std::vector<Vec2> places, double step, const StopClock& clock) const {
  std::vector<SpeedZones::Stretch> parts;
  const auto time = [&](const Vec2& from, const Vec2& to) { return time_between(from, to, parts); };
  for (int round = 0; round < kRouteRounds && !clock.is_over(); ++round) {
    leave_out(places, kSavesTime, time, clock);
    move(places, step, time, clock);
  }
  leave_out(places, kMattersLittle, time, clock);
  Route route{std::move(places), 0.0};
  for (std::size_t i = 0; i + 1 < route.places.size(); ++i) route.time += time(route.places[i], route.places[i + 1]);
  return route;
}

std::optional<ZoneRoutes::Route> ZoneRoutes::find(const Vec2& start, const Vec2& goal, double slower,
                                                  const StopClock& clock) const {
  const Grid* grid = grid_.get(clock, [&] { return make_grid(clock); });
  if (grid == nullptr) return std::nullopt;
  // Outside of the grid there is neither an obstacle nor a zone.
  const Vec2 last = grid->corner + grid->step * Vec2(static_cast<double>(grid->columns) - 1.5,
                                                     kRowDistance * (static_cast<double>(grid->rows) - 1.0));
  const auto inside = [&](const Vec2& p) -> Vec2 {
    const Vec2 margin = Vec2::Constant(grid->step);
    return p.cwiseMax(grid->corner + margin).cwiseMin(last - margin);
  };
  Search search(*grid, slower, map_.vehicle.max_speed());
  if (!search.spread(inside(goal), inside(start), clock)) return std::nullopt;
  std::optional<std::vector<Vec2>> places = search.descend(inside(start));
  if (!places) return std::nullopt;
  places->front() = start;
  places->back() = goal;
  Route route = shortest_over(*std::move(places), grid->step, clock);
  if (route.time == kInfinity) return std::nullopt;
  return route;
}

}  // namespace arcway::internal

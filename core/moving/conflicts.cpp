#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "arcway/moving_obstacle.h"
#include "core/base/shortest_text.h"
#include "core/geometry/distance.h"
#include "core/moving/blocked_places.h"

namespace arcway {

using namespace internal;
namespace {

constexpr double kContact = 1e-9;  // of the body's reach: travel below which an interval is not halved again

// The contacts of a trajectory's body with one obstacle.
class Contacts {
 public:
  Contacts(const Trajectory& trajectory, const MovingObstacle& obstacle)
      : trajectory_(trajectory), obstacle_(obstacle), reach_(trajectory.vehicle().footprint().farthest()) {}

  // The first or the last contact in a stretch of time on one segment.
  [[nodiscard]] std::optional<double> first(const TimeInterval& times, double curvature) const {
    return find(times, curvature, true);
  }
  [[nodiscard]] std::optional<double> last(const TimeInterval& times, double curvature) const {
    return find(times, curvature, false);
  }

 private:
  // NOLINTNEXTLINE(misc-no-recursion): some tens deep.
  [[nodiscard]] std::optional<double> find(const TimeInterval& times, double curvature, bool first) const {
    const double middle = std::midpoint(times.begin, times.end);
    const double at = trajectory_.at(middle).distance;
    const double driven = std::max(at - trajectory_.at(times.begin).distance, trajectory_.at(times.end).distance - at);
    const double travel =
        driven * (1.0 + std::abs(curvature) * reach_) + (times.end - middle) * obstacle_.velocity.norm();
    const double gap = gap_at(middle);
    if (gap > travel) return std::nullopt;
    const bool is_halved = middle > times.begin && middle < times.end;
    if (travel <= kContact * reach_ || !is_halved) return middle;
    const TimeInterval halves[] = {{times.begin, middle}, {middle, times.end}};
    if (const auto found = find(halves[first ? 0 : 1], curvature, first)) return found;
    return find(halves[first ? 1 : 0], curvature, first);
  }

  [[nodiscard]] double gap_at(double time) const {
    Ring there = obstacle_.outline;
    for (Vec2& p : there) p += time * obstacle_.velocity;
    double least = INFINITY;
    for (Ring& part : trajectory_.vehicle().outline(trajectory_.at(time).pose))
      least = std::min(least, distance(Polygon{std::move(part), {}}, Polygon{there, {}}));
    return least;
  }

  const Trajectory& trajectory_;
  const MovingObstacle& obstacle_;
  double reach_;
};

}  // namespace

std::vector<Conflict> conflicts(const Trajectory& trajectory, std::span<const MovingObstacle> obstacles) {
  check_moving(obstacles);
  std::vector<Conflict> found;
  double begun = 0.0;
  const std::span<const TimedSegment> segments = trajectory.segments();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const double ended = std::min(begun + segments[i].duration, trajectory.duration());
    for (std::size_t k = 0; k < obstacles.size(); ++k) {
      const TimeInterval times{std::max(begun, obstacles[k].from), std::min(ended, obstacles[k].until)};
      if (times.begin > times.end) continue;
      const Contacts contacts(trajectory, obstacles[k]);
      const double curvature = segments[i].segment.curvature;
      const auto first = contacts.first(times, curvature);
      if (!first) continue;
      const double last = contacts.last({*first, times.end}, curvature).value_or(*first);
      found.push_back({k, i, *first, last, trajectory.at(*first).distance});
    }
    begun = ended;
  }
  return found;
}

std::string to_string(const Conflict& conflict) {
  return "moving obstacle " + std::to_string(conflict.obstacle) + " in segment " + std::to_string(conflict.segment) +
         " from " + rounded_text(conflict.begin) + " to " + rounded_text(conflict.end) + " s, after " +
         rounded_text(conflict.distance) + " m";
}

}  // namespace arcway

// Plans among speed limits against a dense search: Dijkstra over cells of position, heading and speed, which knows
// nothing of circles, routes and refinement.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/planner.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "tests/support/boxes.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

constexpr double kSide = 32.0;  // of the field [m]

// A square field without obstacles, and the limit on the speed at each of its places.
struct Field {
  std::vector<Zone> zones;

  [[nodiscard]] World world() const { return World({}, test::box_ring(0.0, 0.0, kSide, kSide)).with_zones(zones); }
  // Zones are convex here, counter-clockwise.
  [[nodiscard]] double cap(const Vec2& p) const {
    double lowest = INFINITY;
    for (const Zone& zone : zones) {
      const Ring& ring = zone.area.outer;
      bool inside = true;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 along = ring[(i + 1) % ring.size()] - ring[i], to = p - ring[i];
        inside = inside && along.x() * to.y() - along.y() * to.x() >= 0.0;
      }
      if (inside) lowest = std::min(lowest, std::get<SpeedLimit>(zone.rule).max_speed);
    }
    return lowest;
  }
};

// The least time over cells from rest to rest. Each motion is a line or an arc of one length with constant
// acceleration.
class DenseSearch {
 public:
  DenseSearch(const Field& field, const Vehicle& vehicle) : field_(field), vehicle_(vehicle) {
    for (const double share : {0.0, 0.25, 0.5, 1.0})
      for (const double sign : {1.0, -1.0})
        if (share > 0.0 || sign > 0.0) curvatures_.push_back(sign * share / vehicle.min_turning_radius());
  }

  double time(const Pose& start, const Pose& goal) {
    std::vector<float> best(kCells * kCells * kHeadings * kSpeeds, INFINITY);
    const auto later = [](const State& a, const State& b) { return a.time > b.time; };
    std::priority_queue<State, std::vector<State>, decltype(later)> open(later);
    open.push({start, 0.0, 0.0});
    double least = INFINITY;
    while (!open.empty() && open.top().time < least) {
      const State at = open.top();
      open.pop();
      if (at.time > 0.0 && at.time > static_cast<double>(best[cell_of(at)]) * (1.0 + 1e-6)) continue;
      least = std::min(least, at.time + time_to_stop(at, goal));
      for (const double curvature : curvatures_)
        for (const State& next : motions(at, curvature)) {
          const std::size_t cell = cell_of(next);
          if (static_cast<float>(next.time) >= best[cell]) continue;
          best[cell] = static_cast<float>(next.time);
          open.push(next);
        }
    }
    return least;
  }

 private:
  static constexpr std::size_t kCells = 64, kHeadings = 60, kSpeeds = 10;
  static constexpr double kMotion = 0.7;  // length [m]
  struct State {
    Pose pose;
    double speed, time;
  };

  [[nodiscard]] std::size_t cell_of(const State& s) const {
    const auto part = [](double share, std::size_t count) {
      return std::min(count - 1, static_cast<std::size_t>(share * static_cast<double>(count)));
    };
    const double turned = wrap_positive(s.pose.heading + kPi / kHeadings) / kTwoPi;
    return ((part(s.pose.y / kSide, kCells) * kCells + part(s.pose.x / kSide, kCells)) * kHeadings +
            part(turned, kHeadings)) *
               kSpeeds +
           part(s.speed / vehicle_.max_speed(), kSpeeds);
  }

  // The time to stop at the goal from a state that lies on a line to it, but for the size of cells; else infinity.
  [[nodiscard]] double time_to_stop(const State& s, const Pose& goal) const {
    const Vec2 to = goal.position() - s.pose.position(), ahead(std::cos(goal.heading), std::sin(goal.heading));
    const double along = std::max(0.0, ahead.dot(to)), beside = std::abs(ahead.x() * to.y() - ahead.y() * to.x());
    const double a = vehicle_.max_acceleration(), v = s.speed, braking = v * v / (2.0 * a);
    if (to.norm() > 1.2 || beside > 0.25 || std::abs(wrap_signed(goal.heading - s.pose.heading)) > 0.1) return INFINITY;
    if (braking > along + 0.35) return INFINITY;
    const double cap = std::min(vehicle_.max_speed(), field_.cap(goal.position()));
    const double peak = std::max(v, std::min(cap, std::sqrt(a * along + 0.5 * v * v)));
    const double ramps = (2.0 * peak * peak - v * v) / (2.0 * a);
    return (2.0 * peak - v) / a + std::max(0.0, along - ramps) / std::max(peak, 0.1);
  }

  [[nodiscard]] std::vector<State> motions(const State& s, double curvature) const {
    const double limit = curvature == 0.0 ? vehicle_.max_speed() : vehicle_.turn_speed(1.0 / std::abs(curvature));
    const PathSegment segment{s.pose, kMotion, curvature};
    const Pose end = segment.end();
    if (std::min(end.x, end.y) < 1.0 || std::max(end.x, end.y) > kSide - 1.0) return {};
    const double cap = std::min(limit, field_.cap(segment.at(0.5 * kMotion).position()));
    const double cap_behind = std::min(cap, field_.cap(end.position())),
                 change = 2.0 * vehicle_.max_acceleration() * kMotion;
    const double slowest = std::sqrt(std::max(0.0, s.speed * s.speed - change));
    const double fastest = std::min(cap_behind, std::sqrt(s.speed * s.speed + change));
    if (s.speed > cap + 1e-9 || slowest > fastest) return {};
    std::vector<State> all;
    for (const double speed :
         {fastest, std::min(s.speed, fastest), slowest, std::clamp(0.5 * fastest, slowest, fastest)})
      if (speed > 0.05) all.push_back({end, speed, s.time + 2.0 * kMotion / (s.speed + speed)});
    return all;
  }

  const Field& field_;
  const Vehicle& vehicle_;
  std::vector<double> curvatures_;
};

TEST(ZoneLoss, PlansAreNotSlowerThanADenseSearch) {
  // Wide turns at speed need finer headings than cells have.
  VehicleParameters slower;
  slower.turn_speed = ConstantTurnSpeed{2.0};
  slower.max_speed = 4.0;
  slower.max_acceleration = 2.0;
  const std::array vehicles{Vehicle(), Vehicle(slower)};
  test::RandomInputs random(5);
  int crossed = 0;
  for (int i = 0; i < 6; ++i) {
    const Vehicle& vehicle = vehicles[static_cast<std::size_t>(i % 2)];
    Field field;
    for (int zone = 0; zone < 2; ++zone)
      field.zones.push_back({Polygon::regular({random.uniform(10.0, 22.0), random.uniform(10.0, 22.0)},
                                              random.uniform(4.0, 8.0), 5, random.uniform(0.0, kTwoPi)),
                             SpeedLimit{random.uniform(0.2, 0.6) * vehicle.max_speed()}});
    const Pose start{3.0, random.uniform(8.0, 24.0), random.uniform(-0.7, 0.7)};
    const Pose goal{29.0, random.uniform(8.0, 24.0), random.uniform(-0.7, 0.7)};
    const PlanResult plan = Planner(field.world(), vehicle).plan(start, goal);
    ASSERT_TRUE(plan.solved()) << i;
    const double dense = DenseSearch(field, vehicle).time(start, goal);
    EXPECT_LE(plan.travel_time, 1.015 * dense) << i;
    EXPECT_GE(plan.travel_time, 0.85 * dense) << i;  // else the dense search is none
    crossed += plan.travel_time > 1.05 * Planner(World({}), vehicle).plan(start, goal).travel_time ? 1 : 0;
  }
  EXPECT_GT(crossed, 1);  // zones that make no difference test nothing
}

}  // namespace
}  // namespace arcway::internal

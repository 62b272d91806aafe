#include "arcway/moving_obstacle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "arcway/angle.h"
#include "arcway/planner.h"
#include "arcway/validation.h"
#include "core/geometry/distance.h"
#include "tests/support/boxes.h"
#include "tests/support/random_bodies.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

const World& open_world() {
  static const World world{std::vector<Polygon>{}};
  return world;
}

Vehicle slow_robot() {
  return Vehicle({.max_speed = 2.0, .turn_speed = ConstantTurnSpeed{1.0}, .max_acceleration = 1.0});
}

PathSegment line(double length) { return {{0.0, 0.0, 0.0}, length, 0.0}; }

// Crosses the x axis between 4 and 5 m.
MovingObstacle crossing(double speed) {
  return {.outline = test::box_ring(4.0, -3.0, 5.0, -2.0), .velocity = {0.0, speed}};
}

Ring moved(Ring ring, const Vec2& by) {
  for (Vec2& p : ring) p += by;
  return ring;
}

// Distance of the bare body at a time from an obstacle, by no code that is tested.
double gap(const Trajectory& trajectory, const MovingObstacle& obstacle, double time) {
  if (time < obstacle.from || time > obstacle.until) return INFINITY;
  const World world({{moved(obstacle.outline, time * obstacle.velocity), {}}});
  const test::PlacedBody body(trajectory.vehicle().outline(), trajectory.at(time).pose);
  return body.is_swallowed_by(world) ? 0.0 : static_cast<double>(body.distance_to(world));
}

std::string refusal_of(const MovingObstacle& obstacle, double horizon = 10.0) {
  try {
    (void)blocked_times(line(10.0), Vehicle(), obstacle, horizon);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

// A motion in the open, and obstacles that cross it.
struct Crossing {
  Trajectory trajectory;
  std::vector<MovingObstacle> obstacles;
};

Crossing random_crossing(test::RandomInputs& random, std::size_t count) {
  VehicleParameters parameters = slow_robot().parameters();
  parameters.min_turning_radius = random.uniform(0.8, 2.0);
  if (random.unit() < 0.5) parameters.footprint = test::random_footprint(random);
  const Vehicle vehicle(parameters);
  const Planner planner(open_world(), vehicle);
  const Pose goal{random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(-kPi, kPi)};
  const Trajectory trajectory = planner.plan(Pose{0.0, 0.0, random.uniform(-kPi, kPi)}, goal).trajectory();
  std::vector<MovingObstacle> obstacles;
  for (std::size_t i = 0; i < count; ++i) {
    // Through a place of the path, near the time at which the vehicle is there.
    const double time = random.uniform(0.0, trajectory.duration());
    const Vec2 velocity = random.uniform(0.5, 2.0) * direction_of(random.uniform(-kPi, kPi));
    const Vec2 middle = trajectory.at(time).pose.position() - (time + random.uniform(-2.0, 2.0)) * velocity;
    Ring ring = test::random_star(random, middle, 0.2, 1.0, 6);
    if (random.unit() < 0.5) ring = test::reversed(ring);
    obstacles.push_back({ring, velocity});
    if (random.unit() < 0.3) obstacles.back().until = random.uniform(0.1, trajectory.duration());
  }
  return {trajectory, obstacles};
}

TEST(BlockedTimes, OfALineAreExact) {
  const std::vector<TimeInterval> times = blocked_times(line(10.0), Vehicle(), crossing(0.5), 60.0);
  ASSERT_EQ(times.size(), 1u);
  EXPECT_NEAR(times[0].begin, (2.0 - 0.4005) / 0.5, 1e-12);
  EXPECT_NEAR(times[0].end, (3.0 + 0.4005) / 0.5, 1e-12);
  EXPECT_TRUE(blocked_times(line(2.0), Vehicle(), crossing(0.5), 60.0).empty()) << "2 m + 1.4 m are before 4 m";
  EXPECT_EQ(blocked_times(line(10.0), Vehicle(), crossing(0.5), 5.0)[0].end, 5.0) << "the horizon";
  MovingObstacle late = crossing(0.5);
  late.from = 4.0, late.until = 5.0;
  EXPECT_EQ(blocked_times(line(10.0), Vehicle(), late, 60.0)[0].begin, 4.0);
  EXPECT_EQ(blocked_times(line(10.0), Vehicle(), late, 60.0)[0].end, 5.0);
}

TEST(BlockedTimes, AreThoseAtWhichTheBodyOnTheSegmentIsTouched) {
  test::RandomInputs random(1);
  std::size_t touched = 0, narrow = 0;
  for (int k = 0; k < 30; ++k) {
    const Vehicle vehicle = test::random_body_vehicle(random);
    const double curvature = k % 3 == 0 ? 0.0 : random.uniform(-0.8, 0.8);
    const PathSegment segment{{0.0, 0.0, random.uniform(-kPi, kPi)},
                              random.uniform(0.5, 3.0),
                              curvature,
                              k % 2 == 0 ? Gear::kForward : Gear::kReverse};
    const Vec2 at = segment.at(0.5 * segment.length).position();
    const Vec2 velocity = direction_of(random.uniform(-kPi, kPi));
    const MovingObstacle obstacle{test::random_star(random, at - 5.0 * velocity, 0.1, 0.8, 7), velocity};
    const std::vector<TimeInterval> times = blocked_times(segment, vehicle, obstacle, 10.0);
    for (int i = 0; i < 100; ++i) {
      const double time = 0.1 * i;
      const World world({{moved(obstacle.outline, time * velocity), {}}});
      double least = INFINITY;
      for (int j = 0; j <= 30; ++j) {
        const test::PlacedBody body(vehicle.outline(), segment.at(segment.length * j / 30.0));
        least = std::min(least, body.is_swallowed_by(world) ? 0.0 : static_cast<double>(body.distance_to(world)));
      }
      const bool is_blocked =
          std::ranges::any_of(times, [&](const TimeInterval& t) { return t.begin <= time && time <= t.end; });
      if (least == 0.0) {
        EXPECT_TRUE(is_blocked) << k << " at " << time;
        ++touched;
      }
      if (is_blocked && least > 0.0) ++narrow;
      // Samples of the motion are up to 10 cm and 0.08 rad apart.
      if (is_blocked) {
        EXPECT_LT(least, 0.15) << k << " at " << time;
      }
    }
  }
  EXPECT_GT(touched, 300u);
  EXPECT_LT(narrow, touched / 5);
}

TEST(Conflicts, AreWhenAndWhereTheBodyIsTouched) {
  const Trajectory trajectory(std::vector<PathSegment>{line(10.0)}, slow_robot());
  // It reaches 4 m with its front after 2.6 m: 2 s to 2 m/s along 2 m, and 0.6 m at that.
  EXPECT_TRUE(conflicts(trajectory, std::vector{crossing(0.25)}).empty()) << "comes after the vehicle";
  const std::vector<Conflict> found = conflicts(trajectory, std::vector{crossing(0.25), crossing(0.8)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].obstacle, 1u);
  EXPECT_EQ(found[0].segment, 0u);
  EXPECT_NEAR(found[0].begin, 2.3, 1e-7);
  EXPECT_NEAR(found[0].distance, 2.6, 1e-7);
  EXPECT_NEAR(found[0].end, 3.55, 1e-7) << "its rear is at 5 m after 5.1 m of way";
  EXPECT_EQ(to_string(Conflict{2, 3, 1.25, 1.5, 4.25}),
            "moving obstacle 2 in segment 3 from 1.25 to 1.5 s, after 4.25 m");
}

TEST(Conflicts, AreThoseOfDenseSamples) {
  test::RandomInputs random(2);
  std::size_t touched = 0, free = 0;
  for (int k = 0; k < 40; ++k) {
    const auto [trajectory, obstacles] = random_crossing(random, 2);
    const std::vector<Conflict> found = conflicts(trajectory, obstacles);
    for (std::size_t o = 0; o < obstacles.size(); ++o) {
      double first = INFINITY;
      for (const Conflict& c : found) {
        if (c.obstacle != o) continue;
        first = std::min(first, c.begin);
        EXPECT_LT(gap(trajectory, obstacles[o], c.begin), 1e-7);
        EXPECT_LT(gap(trajectory, obstacles[o], c.end), 1e-7);
      }
      first == INFINITY ? ++free : ++touched;
      constexpr int kSteps = 400;
      for (int i = 0; i <= kSteps; ++i) {
        const double time = std::min(trajectory.duration(), trajectory.duration() * i / kSteps);
        if (time < first - 1e-7) {
          EXPECT_GT(gap(trajectory, obstacles[o], time), 0.0) << k << " at " << time;
        }
      }
    }
  }
  EXPECT_GT(touched, 20u);
  EXPECT_GT(free, 10u);
}

TEST(Evade, KeepsAMotionThatIsFree) {
  const Trajectory trajectory(std::vector<PathSegment>{line(10.0)}, slow_robot());
  const Evasion evasion = evade(trajectory, std::vector{crossing(0.25)});
  EXPECT_TRUE(evasion.found);
  EXPECT_EQ(evasion.travel_time, trajectory.duration());
  EXPECT_EQ(evasion.waiting, 0.0);
  EXPECT_EQ(evasion.segments.size(), 1u);
}

// A place that is passed with 1 m to brake before it and as much behind it: to wait there is best, and the wait ends
// so that the body arrives when the obstacle is gone.
TEST(Evade, WaitsBeforeWhatCrosses) {
  const Trajectory trajectory(std::vector<PathSegment>{line(10.0)}, slow_robot());
  const MovingObstacle obstacle = crossing(0.8);  // blocks 4 to 5 m from 2 to 4.25 s
  const Evasion evasion = evade(trajectory, std::vector{obstacle});
  ASSERT_TRUE(evasion.found) << evasion.reason;
  const Trajectory evading(evasion.segments, slow_robot());
  EXPECT_TRUE(conflicts(evading, std::vector{obstacle}).empty());
  EXPECT_DOUBLE_EQ(evading.duration(), evasion.travel_time);
  EXPECT_GT(evasion.travel_time, trajectory.duration());
  // To start later by the time until the obstacle is gone is always possible.
  EXPECT_LT(evasion.travel_time, trajectory.duration() + (3.0 + 0.4005) / 0.8 - 2.3 + 1e-3);
}

TEST(Evade, MotionsAreValidAndFree) {
  test::RandomInputs random(3);
  std::size_t evaded = 0, kept = 0, waited = 0, slowed = 0, missed = 0;
  for (int k = 0; k < 60; ++k) {
    const auto [trajectory, obstacles] = random_crossing(random, 1 + k % 3);
    const Evasion evasion = evade(trajectory, obstacles);
    if (!evasion.found) {
      EXPECT_FALSE(evasion.reason.empty());

      ++missed;
      continue;
    }
    const Vehicle& vehicle = trajectory.vehicle();
    const Trajectory evading(evasion.segments, vehicle);
    EXPECT_TRUE(conflicts(evading, obstacles).empty()) << k;
    EXPECT_NEAR(evading.duration(), evasion.travel_time, 1e-9);
    EXPECT_NEAR(evading.length(), trajectory.length(), 1e-9);
    EXPECT_GE(evasion.travel_time, trajectory.duration() * (1.0 - 1e-12));
    const TimedPath path = timed_path_of(evasion.segments);
    const ValidationReport report = validate(open_world(), vehicle, trajectory.at(0.0).pose,
                                             trajectory.at(trajectory.duration()).pose, path, {.moving = obstacles});
    EXPECT_TRUE(report.valid()) << to_string(report);
    const bool is_free = conflicts(trajectory, obstacles).empty();
    is_free ? ++kept : ++evaded;
    waited += evasion.waiting > 0.0;
    slowed += evasion.travel_time > trajectory.duration() + evasion.waiting + 1e-6;
  }
  EXPECT_GT(evaded, 10u);
  EXPECT_GT(kept, 2u);
  EXPECT_GT(waited, 4u);
  EXPECT_GT(slowed, 1u);
  EXPECT_LT(missed, 40u) << "obstacles begin on the path, too";
}

// Whether a motion that begins later touches nothing, nor at its goal until the horizon, by some millimeters.
bool is_clear_if_late(const Crossing& crossing, double delay, double horizon) {
  const auto& [trajectory, obstacles] = crossing;
  for (double t = 0.0; t <= horizon; t += 0.05) {
    const double driven = std::clamp(t - delay, 0.0, trajectory.duration());
    for (const MovingObstacle& o : obstacles) {
      if (t < o.from || t > o.until) continue;
      const MovingObstacle there{.outline = moved(o.outline, t * o.velocity)};
      if (gap(trajectory, there, driven) < 0.1) return false;
    }
  }
  return true;
}

TEST(Evade, IsNoSlowerThanADelay) {
  test::RandomInputs random(4);
  constexpr double kHorizon = 20.0;
  std::size_t delayed = 0;
  for (int k = 0; k < 30; ++k) {
    const Crossing crossing = random_crossing(random, 1);
    double delay = 0.0;
    while (delay < 10.0 && !is_clear_if_late(crossing, delay, kHorizon)) delay += 0.25;
    if (delay >= 10.0) continue;
    const Evasion evasion = evade(crossing.trajectory, crossing.obstacles, {.horizon = kHorizon});
    ASSERT_TRUE(evasion.found) << k << ": " << evasion.reason;
    EXPECT_LE(evasion.travel_time, crossing.trajectory.duration() + delay + 1e-9) << k;
    delayed += delay > 0.0;
  }
  EXPECT_GT(delayed, 8u);
}

TEST(Evade, SaysWhyThereIsNoMotion) {
  const Trajectory trajectory(std::vector<PathSegment>{line(10.0)}, slow_robot());
  const MovingObstacle at_goal{.outline = test::box_ring(10.0, -1.0, 12.0, 1.0)};
  EXPECT_EQ(evade(trajectory, std::vector{at_goal}).reason, "a moving obstacle is at the goal at the horizon of 60 s");
  const MovingObstacle at_start{.outline = test::box_ring(-1.0, -1.0, 1.0, 1.0)};
  EXPECT_EQ(evade(trajectory, std::vector{at_start}).reason,
            "a moving obstacle touches the body, grown by half of the safety margin, at the start");
  const MovingObstacle between{.outline = test::box_ring(4.0, -1.0, 5.0, 1.0)};
  EXPECT_EQ(evade(trajectory, std::vector{between}, {.horizon = 20.0}).reason,
            "no motion with stops at 2 places and with 4 speeds is free of moving obstacles until the horizon of 20 s; "
            "a later horizon or another path may help");
}

TEST(MovingObstacles, AreCheckedWithTheirIndex) {
  EXPECT_EQ(refusal_of({.outline = {{0, 0}, {1, 0}}}), "moving obstacle 0: it has 2 vertices, must have >= 3");
  EXPECT_EQ(refusal_of({.outline = {{0, 0}, {2, 2}, {2, 0}, {0, 2}}}),
            "moving obstacle 0: its outline crosses or touches itself, or has no area; give a simple polygon");
  EXPECT_EQ(refusal_of({.outline = {{0, 0}, {1, 0}, {1, NAN}}}), "moving obstacle 0: vertex 2 is not finite");
  MovingObstacle obstacle = crossing(1.0);
  obstacle.velocity.x() = INFINITY;
  EXPECT_EQ(refusal_of(obstacle), "moving obstacle 0: a velocity is not finite");
  obstacle = crossing(1.0);
  obstacle.from = 3.0, obstacle.until = 2.0;
  EXPECT_EQ(refusal_of(obstacle), "moving obstacle 0: until is 2 s, must be > from, 3");
  EXPECT_EQ(refusal_of(crossing(1.0), INFINITY), "moving obstacles: horizon is inf s, must be finite and > 0");
  EXPECT_EQ(refusal_of(crossing(1.0)), "accepted");
}

}  // namespace
}  // namespace arcway::internal

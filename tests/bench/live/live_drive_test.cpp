#include "bench/live/live_drive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "arcway/datasets/clutter.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/planner.h"
#include "arcway/validation.h"
#include "bench/live/live_planner.h"

namespace arcway::internal::bench {
namespace {

constexpr std::size_t kCycles = 400;

World world() { return random_world({.obstacles = 12, .vertices = 6, .fill = 0.1, .seed = 4}); }
Vehicle vehicle() { return Vehicle({.max_speed = 3.0, .max_acceleration = 1.0}); }

struct Driven {
  std::vector<LiveCycle> cycles;
  std::size_t moved = 0, vanished = 0, came_back = 0, goals = 0;
};

// Drives, and checks what a change may do: the map is that of the obstacles, and none is so near that the vehicle could
// not stop.
Driven drive(LivePlanner& planner, std::uint64_t seed) {
  const std::vector<PlanRequest> requests =
      random_queries(world(), make_reference_queries(world()), vehicle(), {.count = 4, .seed = 3});
  std::vector<Pose> goals;
  goals.reserve(requests.size());
  for (const PlanRequest& request : requests) goals.push_back(request.goal);
  const Trajectory first = Planner(world(), vehicle()).plan(requests.front()).trajectory();
  LiveDrive live(planner, first, goals, {.rate = 5.0, .within = std::numeric_limits<double>::infinity(), .seed = seed});
  Driven driven;
  const auto all = [&] {
    const auto now = live.obstacles().obstacles();
    return std::vector(now.begin(), now.end());
  };
  for (std::size_t i = 0; i < kCycles; ++i) {
    const std::vector<WalkingObstacles::Obstacle> before = all();
    driven.cycles.push_back(live.next_cycle());
    const std::vector<WalkingObstacles::Obstacle> after = all();
    std::size_t there = 0, changed = 0;
    for (std::size_t o = 0; o < after.size(); ++o) {
      there += after[o].is_there;
      if (after[o].is_there) {
        EXPECT_NE(planner.world().obstacle_with(after[o].key), kNone);
      }
      const bool vanished = before[o].is_there && !after[o].is_there, back = !before[o].is_there && after[o].is_there;
      const bool moved = before[o].is_there && after[o].is_there && before[o].polygon.outer != after[o].polygon.outer;
      driven.vanished += vanished;
      driven.came_back += back;
      driven.moved += moved;
      changed += vanished || back || moved;
      if (!moved && !back) continue;
      const double braking = 0.5 * 3.0 * 3.0 / 1.0;
      for (const Vec2& p : after[o].polygon.outer)
        EXPECT_GT((p - driven.cycles.back().now.pose.position()).norm(), braking);
    }
    EXPECT_LE(changed, 1U);
    const LiveCycle& cycle = driven.cycles.back();
    if (!cycle.next.segments.empty()) {
      EXPECT_TRUE(validate(planner.world(), vehicle(), cycle.now.pose, cycle.next.segments.back().segment.end(),
                           timed_path_of(cycle.next.segments), {.start_speed = cycle.now.signed_speed()})
                      .valid());
    }
    EXPECT_EQ(planner.world().obstacle_count(), there);
  }
  driven.goals = live.goals_reached();
  return driven;
}

TEST(LiveDrive, MovesObstaclesAndGivesValidMotions) {
  ChangedPlanner planner(Planner(world(), vehicle(), {.refinement = {.max_trials = 50}}));
  const Driven driven = drive(planner, 7);
  EXPECT_GT(driven.moved, kCycles / 3);
  EXPECT_GT(driven.vanished, 0U);
  EXPECT_GT(driven.came_back, 0U);
  EXPECT_GT(driven.goals, 0U);
  const auto to_goal = std::ranges::count_if(driven.cycles, &LiveCycle::leads_to_goal);
  EXPECT_GT(static_cast<std::size_t>(to_goal), kCycles / 2);
  for (const LiveCycle& cycle : driven.cycles) EXPECT_NE(cycle.next.motion, NextMotion::kNoMotion);
}

TEST(LiveDrive, IsTheSameWithPlannersMadeAnew) {
  const PlannerOptions options{.refinement = {.max_trials = 50}};
  ChangedPlanner changed(Planner(world(), vehicle(), reference_backend(world()), options));
  RebuiltPlanner rebuilt(Planner(world(), vehicle(), reference_backend(world()), options), reference_backend, options);
  const Driven one = drive(changed, 8), other = drive(rebuilt, 8);
  for (std::size_t i = 0; i < kCycles; ++i) {
    EXPECT_EQ(one.cycles[i].next.motion, other.cycles[i].next.motion) << i;
    EXPECT_EQ(one.cycles[i].next.travel_time, other.cycles[i].next.travel_time) << i;
  }
}

}  // namespace
}  // namespace arcway::internal::bench

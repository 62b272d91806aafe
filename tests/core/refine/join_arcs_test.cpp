#include "core/refine/join_arcs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "arcway/query_set.h"
#include "arcway/world.h"
#include "core/motion/speed_profile.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

// A turn to the left in many short arcs of slightly different radii.
Path many_arcs(double radius, int arcs) {
  Path path{{{0.0, 0.0, 0.0}, 3.0, 0.0}};
  for (int i = 0; i < arcs; ++i) path.push_back({path.back().end(), 0.1 * radius, (1.0 + 0.01 * (i % 3)) / radius});
  path.push_back({path.back().end(), 3.0, 0.0});
  return path;
}

double joined_time(const Path& path, const Vehicle& vehicle) { return speed_profile(path, vehicle).total_time; }

const Vehicle kJoinedVehicle;

Path joined(const Path& path, const World& world, const StopClock& clock = {}) {
  return ArcJoiner().join(path, {kJoinedVehicle, *make_reference_queries(world).sweep, clock});
}

const Path kManyArcs = many_arcs(3.0 * kJoinedVehicle.min_turning_radius(), 15);

World world_with_post(const Vec2& corner) {
  return World({{{corner, corner + Vec2(0.1, -0.1), corner + Vec2(-0.1, -0.1)}, {}}});
}

TEST(JoinArcs, LeavesFewArcsOfMany) {
  const World world = world_with_post({0.0, 50.0});
  const Path few = joined(kManyArcs, world);
  EXPECT_LE(few.size(), 4U);
  EXPECT_LE(joined_time(few, kJoinedVehicle), 1.001 * joined_time(kManyArcs, kJoinedVehicle));
  test::expect_valid(world, kJoinedVehicle, kManyArcs.front().start, kManyArcs.back().end(), few);
}

// A post stands next to the body in the middle of the turn, on its outside.
TEST(JoinArcs, StaysFree) {
  const Pose middle = kManyArcs[8].start;
  const Footprint body = kJoinedVehicle.footprint();
  const Vec2 ahead(std::cos(middle.heading), std::sin(middle.heading)), right(ahead.y(), -ahead.x());
  const double beside = std::hypot(3.0 * kJoinedVehicle.min_turning_radius() + body.right, body.front) -
                        3.0 * kJoinedVehicle.min_turning_radius() + 0.03;
  const World world = world_with_post(middle.position() + beside * right);
  test::expect_valid(world, kJoinedVehicle, kManyArcs.front().start, kManyArcs.back().end(), kManyArcs);
  const Path few = joined(kManyArcs, world);
  EXPECT_LT(few.size(), kManyArcs.size());
  test::expect_valid(world, kJoinedVehicle, kManyArcs.front().start, kManyArcs.back().end(), few);
}

TEST(JoinArcs, CanBeStopped) {
  EXPECT_EQ(joined(kManyArcs, world_with_post({0.0, 50.0}), StopClock(0.0)).size(), kManyArcs.size());
}

TEST(JoinArcs, LeavesShortPathsAsTheyAre) {
  const World world = world_with_post({0.0, 50.0});
  EXPECT_TRUE(joined({}, world).empty());
  EXPECT_EQ(joined(many_arcs(5.0, 0), world).size(), 2U);
}

}  // namespace
}  // namespace arcway::internal

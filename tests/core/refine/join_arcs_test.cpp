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
const Path kManyArcs = many_arcs(3.0 * kJoinedVehicle.min_turning_radius(), 15);

World world_with_post(const Vec2& corner) {
  return World({{{corner, corner + Vec2(0.1, -0.1), corner + Vec2(-0.1, -0.1)}, {}}});
}

TEST(JoinArcs, LeavesFewArcsOfMany) {
  const World world = world_with_post({0.0, 50.0});
  const Path joined = join_arcs(kManyArcs, kJoinedVehicle, *make_reference_queries(world).sweep, {});
  EXPECT_LE(joined.size(), 4U);
  EXPECT_LE(joined_time(joined, kJoinedVehicle), 1.001 * joined_time(kManyArcs, kJoinedVehicle));
  test::expect_valid(world, kJoinedVehicle, kManyArcs.front().start, kManyArcs.back().end(), joined);
}

// A post stands next to the body in the middle of the turn, on its outside.
TEST(JoinArcs, StaysFree) {
  const Pose middle = kManyArcs[8].start;
  const Footprint body = kJoinedVehicle.footprint();
  const Vec2 ahead(std::cos(middle.heading), std::sin(middle.heading)), right(ahead.y(), -ahead.x());
  const double beside = std::hypot(3.0 * kJoinedVehicle.min_turning_radius() + body.right, body.front) -
                        3.0 * kJoinedVehicle.min_turning_radius() + 0.03;
  const World world = world_with_post(middle.position() + beside * right);
  const QuerySet queries = make_reference_queries(world);
  test::expect_valid(world, kJoinedVehicle, kManyArcs.front().start, kManyArcs.back().end(), kManyArcs);
  const Path joined = join_arcs(kManyArcs, kJoinedVehicle, *queries.sweep, {});
  EXPECT_LT(joined.size(), kManyArcs.size());
  test::expect_valid(world, kJoinedVehicle, kManyArcs.front().start, kManyArcs.back().end(), joined);
}

TEST(JoinArcs, CanBeStopped) {
  const World world = world_with_post({0.0, 50.0});
  const QuerySet queries = make_reference_queries(world);
  EXPECT_EQ(join_arcs(kManyArcs, kJoinedVehicle, *queries.sweep, StopClock(0.0)).size(), kManyArcs.size());
}

TEST(JoinArcs, LeavesShortPathsAsTheyAre) {
  const World world = world_with_post({0.0, 50.0});
  const QuerySet queries = make_reference_queries(world);
  EXPECT_TRUE(join_arcs({}, kJoinedVehicle, *queries.sweep, {}).empty());
  EXPECT_EQ(join_arcs(many_arcs(5.0, 0), kJoinedVehicle, *queries.sweep, {}).size(), 2U);
}

}  // namespace
}  // namespace arcway::internal

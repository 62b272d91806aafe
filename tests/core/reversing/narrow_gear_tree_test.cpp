#include "core/reversing/narrow_gear_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "arcway/angle.h"
#include "arcway/query_set.h"
#include "core/motion/clearance.h"
#include "core/motion/speed_profile.h"
#include "core/reversing/narrow_gear_search.h"
#include "tests/support/boxes.h"
#include "tests/support/lazy_maps.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

using test::box;

constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

// A delivery robot that turns on 0.6 m in front of a recess that is as deep as its body and little longer.
VehicleParameters robot() {
  return {.length = 1.5,
          .width = 0.8,
          .wheelbase = 1.0,
          .max_steering_angle = 1.0,
          .max_speed = 2.0,
          .turn_speed = ConstantTurnSpeed{1.0},
          .max_acceleration = 1.0,
          .safety_margin = 0.001};
}

// Rear axle 0.25 m ahead of the tail: the recess is from -0.25 - slack to 1.25 + slack.
std::vector<Polygon> recess(double slack) {
  return {box(-4.0, -1.2, -0.25 - slack, 0.4), box(1.25 + slack, -1.2, 5.0, 0.4), box(-4.0, -1.2, 5.0, -0.42),
          box(-4.0, 1.9, 5.0, 2.9)};
}

TEST(NarrowGearTree, WaysAreJoinedFreeAndCounted) {
  const World world(recess(0.2));
  const Vehicle vehicle(robot());
  const Roadmap map = test::lazy_map(world, vehicle);
  NarrowGearTree tree(map, vehicle, {0.0, 0.0, 0.0}, {0.5, kNoLimit, 1.0}, [](const Pose&) { return 0.0; });
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(tree.expand());
  std::size_t most_cusps = 0;
  for (std::uint32_t node = 1; node < tree.size(); node += 3) {
    const Path path = tree.path_from_root(node);
    for (std::size_t i = 1; i < path.size(); ++i) {
      EXPECT_EQ(path[i].start.position(), path[i - 1].end().position());
      EXPECT_EQ(path[i].start.heading, path[i - 1].end().heading);
    }
    for (const PathSegment& s : path) EXPECT_GT(clearance_along(s, vehicle.footprint(), world).distance, 0.0);
    EXPECT_EQ(tree[node].cusps, cusps_of(path));
    EXPECT_EQ(cusps_of(tree.path_to_root(node)), cusps_of(path));
    most_cusps = std::max<std::size_t>(most_cusps, tree[node].cusps);
  }
  EXPECT_GT(most_cusps, 1u);
}

TEST(NarrowGearTree, KnowsHowFarItsLastPoseLeads) {
  const World world(recess(0.2));
  const Vehicle vehicle(robot());
  const Roadmap map = test::lazy_map(world, vehicle);
  NarrowGearTree tree(map, vehicle, {0.0, 0.0, 0.0}, {0.5, kNoLimit, 1.0}, [](const Pose&) { return 0.0; });
  int free = 0, blocked = 0;
  for (int i = 0; i < 200; ++i) {
    const auto node = tree.expand();
    ASSERT_TRUE(node);
    for (const double curvature : {-1.0, 0.0, 1.0})
      for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
        const PathSegment motion{tree[*node].pose, 0.3, curvature / vehicle.min_turning_radius(), gear};
        const bool room = tree.has_room(motion);
        EXPECT_EQ(room, clearance_along(motion, map.body, world).distance > 0.0);
        ++(room ? free : blocked);
      }
  }
  EXPECT_GT(free, 30);
  EXPECT_GT(blocked, 50);
}

TEST(NarrowGearTree, KeepsToTheLimitOfCusps) {
  const World world(recess(0.2));
  const Vehicle vehicle(robot());
  const Roadmap map = test::lazy_map(world, vehicle);
  for (const std::size_t most : {0u, 1u, 2u}) {
    NarrowGearTree tree(map, vehicle, {0.0, 0.0, 0.0}, {0.5, most, 1.0}, [](const Pose&) { return 0.0; });
    for (int i = 0; i < 200 && tree.expand(); ++i)
      ;
    std::size_t found = 0;
    for (std::uint32_t node = 0; node < tree.size(); ++node) found = std::max<std::size_t>(found, tree[node].cusps);
    EXPECT_EQ(found, most);
  }
}

TEST(NarrowGearTree, EndsWhereNothingMoves) {
  const Vehicle vehicle(robot());
  const Roadmap map = test::lazy_map(World(recess(0.0006)), vehicle);  // half of the margin and a little
  NarrowGearTree tree(map, vehicle, {0.0, 0.0, 0.0}, {0.5, kNoLimit, 1.0}, [](const Pose&) { return 0.0; });
  EXPECT_EQ(tree.expand(), NarrowGearTree::kRoot);
  EXPECT_EQ(tree.expand(), std::nullopt);
}

TEST(NarrowGearSearch, KeepsItsLimits) {
  const World world(recess(0.3));
  const Vehicle vehicle(robot());
  const Roadmap map = test::lazy_map(world, vehicle);
  const Pose start{0.0, 0.0, 0.0}, goal{-1.5, 1.1, 0.0};
  const GearSearchResult all = search_narrow_gears(map, start, goal, {});
  ASSERT_TRUE(all.path);
  EXPECT_EQ(search_narrow_gears(map, start, goal, {}).cost, all.cost);
  EXPECT_LE(search_narrow_gears(map, start, goal, {.max_poses = 10}).poses, 10u);
  const std::size_t cusps = cusps_of(*all.path);
  for (const std::size_t most : {std::size_t{0}, cusps - 1}) {
    const GearSearchResult few = search_narrow_gears(map, start, goal, {.max_poses = 2000, .max_cusps = most});
    if (few.path) {
      EXPECT_LE(cusps_of(*few.path), most);
    }
  }
  const GearSearchResult cheap = search_narrow_gears(map, start, goal, {.max_poses = 2000, .cutoff = 0.9 * all.cost});
  if (cheap.path) {
    EXPECT_LT(cheap.cost, 0.9 * all.cost);
  }
  const GearSearchResult stopped = search_narrow_gears(map, start, goal, {.clock = StopClock(0.0)});
  EXPECT_TRUE(stopped.interrupted);
  EXPECT_FALSE(stopped.path);
}

}  // namespace
}  // namespace arcway::internal

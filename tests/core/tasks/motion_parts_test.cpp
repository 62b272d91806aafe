#include "core/tasks/motion_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "arcway/planner.h"
#include "tests/support/boxes.h"

namespace arcway::internal::motion_parts_test {
namespace {

Vehicle robot() {
  return Vehicle({.max_speed = 3.0, .turn_speed = LateralAccelerationLimit{1.5}, .max_acceleration = 1.0});
}

// A drive around an obstacle, with turns.
Trajectory drive() {
  const World world(std::vector<Polygon>{test::box(10, -4, 14, 3)});
  return Planner(world, robot()).plan(Pose{0.0, 0.0, 0.0}, Pose{30.0, 2.0, 1.0}).trajectory();
}

TEST(MotionParts, AreTheMotionTogether) {
  const Trajectory motion = drive();
  ASSERT_GT(motion.segments().size(), 3U);
  for (double share = 0.0; share <= 1.0; share += 0.01) {
    const TrajectoryState there = motion.at(share * motion.duration());
    std::vector<TimedSegment> parts = begin_of(motion, there);
    const std::vector<TimedSegment> rest = rest_of(motion, there);
    EXPECT_NEAR(time_of(parts), there.time, 1e-9);
    EXPECT_NEAR(time_of(rest), motion.duration() - there.time, 1e-9);
    if (!parts.empty()) {
      EXPECT_NEAR(parts.back().speed_out, there.speed, 1e-9);
      EXPECT_NEAR((parts.back().segment.end().position() - there.pose.position()).norm(), 0.0, 1e-9);
    }
    parts.insert(parts.end(), rest.begin(), rest.end());
    const Trajectory whole(parts, robot());
    for (double t = 0.0; t < 1.0; t += 0.05) {
      const TrajectoryState one = whole.at(t * motion.duration() * (1.0 - 1e-9)), other = motion.at(one.time);
      EXPECT_NEAR(one.distance, other.distance, 1e-6);
      EXPECT_NEAR(one.speed, other.speed, 1e-6);
    }
  }
}

// A motion may accelerate a little more than the vehicle: see Trajectory. Parts of it still begin and end as fast as it
// is there, also where it has hardly begun to move.
TEST(MotionParts, BeginAndEndWithItsSpeed) {
  constexpr double kMore = 1.0 + 5e-7;  // of the speeds that the vehicle can reach
  constexpr double kLength = 1.4;
  const double top = kMore * std::sqrt(2.0 * kLength), time = 2.0 * kLength / top;
  const std::vector<TimedSegment> claimed{{{{0.0, 0.0, 0.0}, kLength, 0.0}, 0.0, top, time},
                                          {{{kLength, 0.0, 0.0}, kLength, 0.0}, top, 0.0, time}};
  const Trajectory motion(claimed, robot());
  for (const double share : {0.01, 0.06, 0.3, 0.5, 0.7, 0.94, 0.99}) {
    const TrajectoryState there = motion.at(share * motion.duration());
    const std::vector<TimedSegment> rest = rest_of(motion, there), begin = begin_of(motion, there);
    EXPECT_NEAR(rest.front().speed_in, there.speed, 1e-6 * there.speed) << share;
    EXPECT_NEAR(begin.back().speed_out, there.speed, 1e-6 * there.speed) << share;
    EXPECT_NO_THROW(Trajectory(rest, robot()));
    EXPECT_NO_THROW(Trajectory(begin, robot()));
  }
}

TEST(MotionParts, AreDrivenSlowerUntilTheyCatchUp) {
  const Trajectory motion = drive();
  const TrajectoryState there = motion.at(0.3 * motion.duration());
  const std::vector<TimedSegment> rest = rest_of(motion, there);
  double slower = time_of(rest);
  for (const double share : {1.0, 0.9, 0.5, 0.1, 0.0}) {
    const std::vector<TimedSegment> begun = begun_at(share * there.speed, rest, robot());
    EXPECT_EQ(begun.front().speed_in, share * rest.front().speed_in);
    EXPECT_GE(time_of(begun), slower - 1e-9);
    slower = time_of(begun);
    EXPECT_NO_THROW(Trajectory(begun, robot()));
    for (std::size_t i = 0; i < rest.size(); ++i) EXPECT_LE(begun[i].speed_out, rest[i].speed_out);
    EXPECT_EQ(begun.back().speed_out, 0.0);
  }
}

}  // namespace
}  // namespace arcway::internal::motion_parts_test

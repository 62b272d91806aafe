#include "core/collision/one_way_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "arcway/angle.h"
#include "arcway/query_set.h"
#include "core/collision/motion_free.h"
#include "tests/support/boxes.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal::one_way_sweep_test {
namespace {

using test::box;

const Body kBody{1.4, 0.1, 0.4, 0.4};

// A map with zones that are driven towards +x and towards +y.
World zoned_world() {
  return World({box(-1, -1, 1, 1), box(4, 4, 5, 6)})
      .with_zones({{box(2, -6, 6, 3), OneWay{0.0, 0.5}}, {box(-6, 2, 3, 6), OneWay{0.5 * kPi, 0.3}}});
}

// Whether a motion is against no zone, by how far it leads.
bool obeys(const OneWayZones& zones, const PathSegment& motion) {
  return zones.allowed_length(motion, motion.gear) == motion.length;
}

PathSegment random_motion(test::RandomInputs& random) {
  const Vec2 at = random.point(-7, 7);
  return {{at.x(), at.y(), random.uniform(-kPi, kPi)},
          random.uniform(0.1, 6.0),
          random.integer(0, 1) == 0 ? 0.0 : random.uniform(-0.7, 0.7),
          random.integer(0, 1) == 0 ? Gear::kForward : Gear::kReverse};
}

TEST(OneWaySweep, MotionsAreFreeThatMeetNoObstacleAndObeyTheZones) {
  test::RandomInputs random(3);
  const World world = zoned_world();
  const auto obstacles = make_reference_queries(world).sweep;
  const auto zones = OneWayZones::of(world);
  const auto sweep = obeying(obstacles, zones), backwards = obeying(obstacles, zones, Gear::kReverse);
  int refused = 0, free = 0;
  for (int i = 0; i < 3000; ++i) {
    const PathSegment motion = random_motion(random);
    const bool hits_nothing = motion_free(*obstacles, kBody, {&motion, 1});
    const bool is_free = motion_free(*sweep, kBody, {&motion, 1});
    EXPECT_EQ(is_free, hits_nothing && obeys(*zones, motion)) << i;
    // Over the same poses, in the other gear.
    const PathSegment back = motion.reversed();
    EXPECT_EQ(motion_free(*sweep, kBody, {&back, 1}), hits_nothing && obeys(*zones, back)) << i;
    if (motion.gear == Gear::kForward) {
      EXPECT_EQ(motion_free(*backwards, kBody, {&motion, 1}), motion_free(*sweep, kBody, {&back, 1})) << i;
    }
    ++(is_free ? free : refused);
  }
  EXPECT_GT(free, 300);
  EXPECT_GT(refused, 300);
}

TEST(OneWaySweep, ReachesAndArcsHaveTheBitsOfFreeHeadings) {
  test::RandomInputs random(8);
  const World world = zoned_world();
  const auto obstacles = make_reference_queries(world).sweep;
  const auto sweep = obeying(obstacles, OneWayZones::of(world));
  HeadingSet memory;
  int changed = 0;
  for (int i = 0; i < 1000; ++i) {
    const Side side = i % 2 == 0 ? Side::kLeft : Side::kRight;
    const TurningBody body{random.point(-9, 9), random.uniform(0.5, 5.0), side, kBody};
    const HeadingSet free = sweep->free_headings(body), before = obstacles->free_headings(body);
    const bool is_same = std::ranges::equal(free.intervals(), before.intervals(), [](const auto& a, const auto& b) {
      return a.low == b.low && a.high == b.high;
    });
    changed += is_same ? 0 : 1;
    for (int k = 0; k < 10; ++k) {
      const double heading = random.uniform(0, kTwoPi), angle = random.uniform(0, 3);
      EXPECT_EQ(sweep->reach(body, heading, Side::kLeft, memory), free.reach(heading, Side::kLeft));
      EXPECT_EQ(sweep->arc_free(body, heading, angle, memory), free.reach(heading, side) >= angle);
      // Ends of what is left are those of before, to a unit in the last place.
      EXPECT_LE(free.reach(heading, Side::kRight), before.reach(heading, Side::kRight) + 1e-14);
    }
  }
  EXPECT_GT(changed, 200);
}

TEST(OneWaySweep, BatchesAnswerAsSingleQuestionsDo) {
  test::RandomInputs random(9);
  const World world = zoned_world();
  const auto sweep = obeying(make_reference_queries(world).sweep, OneWayZones::of(world));
  std::vector<StraightBody> bodies;
  for (int i = 0; i < 300; ++i) {
    const Vec2 at = random.point(-7, 7);
    bodies.push_back({{at.x(), at.y(), random.uniform(-kPi, kPi)}, random.uniform(0, 4), kBody});
  }
  std::vector<std::uint8_t> free(bodies.size());
  sweep->straight_free(bodies, free);
  for (std::size_t i = 0; i < bodies.size(); ++i) EXPECT_EQ(free[i] != 0, sweep->straight_free(bodies[i])) << i;
  EXPECT_GT(std::ranges::count(free, 1), 30);
}

TEST(OneWaySweep, BodiesThatStandAndAreasHaveNoDirection) {
  const World world = zoned_world();
  const auto sweep = obeying(make_reference_queries(world).sweep, OneWayZones::of(world));
  const Pose against{4, 0, kPi};
  EXPECT_TRUE(sweep->straight_free({against, 0.0, kBody}));
  EXPECT_FALSE(sweep->straight_free({against, 0.5, kBody}));
  EXPECT_TRUE(sweep->straight_free({against, 0.5, kBody, Gear::kReverse}));
  EXPECT_TRUE(sweep->straight_free(swept_rectangle(against, 0.5, kBody)));
}

TEST(OneWaySweep, IsTheQueryItselfWithoutZones) {
  const auto sweep = make_reference_queries(World({})).sweep;
  EXPECT_EQ(obeying(sweep, nullptr), sweep);
}

}  // namespace
}  // namespace arcway::internal::one_way_sweep_test

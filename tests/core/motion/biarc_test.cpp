#include "core/motion/biarc.h"

#include <gtest/gtest.h>

#include <cmath>

#include "arcway/angle.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

TEST(Biarc, JoinsPosesWithoutAKink) {
  test::RandomInputs random(1);
  int found = 0;
  for (int i = 0; i < 2000; ++i) {
    const Pose start{random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0), random.uniform(-kPi, kPi)};
    const Pose goal{random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0), random.uniform(-kPi, kPi)};
    const double radius = random.uniform(0.1, 2.0);
    const auto arcs = biarc(start, goal, random.uniform(0.2, 5.0), radius);
    if (!arcs) continue;
    ++found;
    for (const PathSegment& arc : *arcs) {
      EXPECT_GT(arc.length, 0.0);
      EXPECT_LE(std::abs(arc.curvature) * radius, 1.0);
    }
    const Pose middle = (*arcs)[0].end(), end = (*arcs)[1].end();
    EXPECT_LT((middle.position() - (*arcs)[1].start.position()).norm(), 1e-12 + 1e-12 * (*arcs)[0].length);
    EXPECT_EQ(middle.heading, (*arcs)[1].start.heading);
    EXPECT_LT((end.position() - goal.position()).norm(), 1e-9);
    EXPECT_LT(std::abs(wrap_signed(end.heading - goal.heading)), 1e-9);
  }
  EXPECT_GT(found, 500);
}

TEST(Biarc, IsALineWhereThePosesLieOnOne) {
  const auto line = biarc({1.0, 2.0, 0.0}, {4.0, 2.0, 0.0}, 1.0, 0.5);
  ASSERT_TRUE(line);
  EXPECT_EQ((*line)[0].curvature, 0.0);
  EXPECT_EQ((*line)[1].curvature, 0.0);
  EXPECT_DOUBLE_EQ((*line)[0].length + (*line)[1].length, 3.0);
}

TEST(Biarc, IsNoneBehindOrTooTight) {
  EXPECT_FALSE(biarc({0.0, 0.0, 0.0}, {-3.0, 0.0, 0.0}, 1.0, 0.5));
  EXPECT_FALSE(biarc({0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, 1.0, 5.0));
  EXPECT_FALSE(biarc({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1.0, 0.5));
  EXPECT_FALSE(biarc({0.0, 0.0, 0.0}, {5.0, 0.0, kPi}, 1.0, 0.5));
}

}  // namespace
}  // namespace arcway::internal

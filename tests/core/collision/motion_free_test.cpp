#include "core/collision/motion_free.h"

#include <gtest/gtest.h>

#include "arcway/query_set.h"
#include "core/motion/clearance.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

const Footprint kDrivenBody{1.4, 0.1, 0.4, 0.4};

Polygon square(const Vec2& low, double size) {
  return {{low, low + Vec2(size, 0.0), low + Vec2(size, size), low + Vec2(0.0, size)}, {}};
}

TEST(MotionFree, SaysWhatTheClearanceSaysInBothGears) {
  test::RandomInputs random(4);
  int free = 0, blocked = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<Polygon> obstacles;
    for (int i = 0; i < 4; ++i) obstacles.push_back(square(random.point(-7.0, 7.0), random.uniform(0.1, 1.5)));
    const World world(obstacles);
    const QuerySet queries = make_reference_queries(world);
    Path path;
    for (int i = 0; i < 4; ++i) {
      path.push_back({path.empty() ? Pose{0.0, 0.0, 0.3} : path.back().end(), random.uniform(0.0, 3.0),
                      i % 2 == 0 ? 0.0 : random.uniform(-0.7, 0.7),
                      random.integer(0, 1) == 0 ? Gear::kForward : Gear::kReverse});
    }
    // A body that starts in free space and touches no edge on its way stays there.
    if (queries.distance->containing(Vec2(0.0, 0.0)) != kNone) continue;
    bool keeps_away = true;
    for (const PathSegment& s : path) keeps_away = keeps_away && clearance_along(s, kDrivenBody, world).distance > 0.0;
    EXPECT_EQ(motion_free(*queries.sweep, kDrivenBody, path), keeps_away) << "round " << round;
    EXPECT_EQ(motion_free(*queries.sweep, kDrivenBody, reversed(path)), keeps_away) << "round " << round;
    ++(keeps_away ? free : blocked);
  }
  EXPECT_GT(free, 30);
  EXPECT_GT(blocked, 30);
}

}  // namespace
}  // namespace arcway::internal

#include "core/planner/collision.h"

#include <gtest/gtest.h>

#include <cmath>

#include "arcway/angle.h"
#include "tests/support/boxes.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

using test::box;

// A rigid motion of pose and obstacles.
struct Motion {
  double angle;
  Vec2 shift;
  Vec2 operator()(const Vec2& p) const {
    return shift + p.x() * direction_of(angle) + p.y() * perpendicular(direction_of(angle));
  }
  Pose operator()(const Pose& pose) const {
    const Vec2 p = (*this)(pose.position());
    return {p.x(), p.y(), pose.heading + angle};
  }
  Polygon operator()(Polygon polygon) const {
    for (Vec2& p : polygon.outer) p = (*this)(p);
    return polygon;
  }
};

TEST(Collision, NamesTheObstacleThatTheBodyMeetsNotTheNearestToItsReference) {
  const Footprint body{.front = 10, .rear = 1, .left = 1, .right = 1};
  for (const Motion& motion : {Motion{0, {0, 0}}, Motion{0.7, {1e6, -1e6}}, Motion{-2.1, {3, 4}}}) {
    // Obstacle 0 is beside the reference point, obstacle 1 is before the nose, and is met by it.
    const World world({motion(box(-1, 1.5, 0, 3)), motion(box(9, -3, 20, 3))});
    const QuerySet queries = make_reference_queries(world);
    const auto contact = contact_of(world, Outlines(world), *queries.distance, body, motion(Pose{0, 0, 0}));
    ASSERT_TRUE(contact);
    EXPECT_EQ(contact->region, 1u);
    EXPECT_LT((contact->point - motion(Vec2(9, 0))).norm(), 1e-8);
  }
}

TEST(Collision, ASwallowedBodyMeetsWhatSwallowsIt) {
  const World world({box(0, 0, 100, 100)}, box(-50, -50, 200, 200).outer);
  const QuerySet queries = make_reference_queries(world);
  const Footprint body{.front = 2, .rear = 1, .left = 1, .right = 1};
  EXPECT_EQ(contact_of(world, Outlines(world), *queries.distance, body, {50, 50, 1})->region, 0u);
  EXPECT_EQ(contact_of(world, Outlines(world), *queries.distance, body, {-60, 0, 1})->region, 1u);
  EXPECT_FALSE(contact_of(world, Outlines(world), *queries.distance, body, {-20, 0, 1}));
}

TEST(Collision, TheFreePoseIsFreeAndNear) {
  const Footprint body{.front = 3, .rear = 1, .left = 1, .right = 1};
  test::RandomInputs random(3);
  for (int round = 0; round < 50; ++round) {
    const Motion motion{random.uniform(-3, 3), {random.uniform(-1e6, 1e6), random.uniform(-1e6, 1e6)}};
    const double depth = random.uniform(0.1, 2.0);  // of the nose in the wall
    const World world({motion(box(3 - depth, -20, 30, 20))});
    const QuerySet queries = make_reference_queries(world);
    const auto free = nearest_free_pose(*queries.sweep, body, motion(Pose{0, 0, 0}));
    ASSERT_TRUE(free);
    EXPECT_TRUE(queries.sweep->straight_free(swept_rectangle(free->pose, 0.0, body)));
    EXPECT_NEAR(free->distance, depth, 1e-3);  // straight back, which is less than to turn
    EXPECT_EQ(free->travel, free->distance);
  }
}

TEST(Collision, TurnsWhereThatIsLessThanToMove) {
  // Between walls beside it, a tail that is turned by 15 degrees: turned back it fits.
  const World world({box(-50, 1.5, 50, 9), box(-50, -9, 50, -1.5)});
  const QuerySet queries = make_reference_queries(world);
  const Footprint body{.front = 3, .rear = 3, .left = 1, .right = 1};
  const auto free = nearest_free_pose(*queries.sweep, body, {0, 0, kPi / 12});
  ASSERT_TRUE(free);
  EXPECT_EQ(free->distance, 0.0);
  EXPECT_NEAR(free->pose.heading, 0.0, 1e-12);
  EXPECT_NEAR(free->travel, std::hypot(3, 1) * kPi / 12, 1e-12);
}

TEST(Collision, SaysWhereNothingIsFreeNearBy) {
  const World world({box(0, 0, 100, 100)});
  const QuerySet queries = make_reference_queries(world);
  const Footprint body{.front = 2, .rear = 1, .left = 2, .right = 2};  // of diagonal 5
  EXPECT_EQ(collision_text(world, Outlines(world), queries, body, {50, 50, 1}),
            "collides with obstacle 0 at (50.27, 50.421); no free pose was found within 10 m");
}

}  // namespace
}  // namespace arcway::internal

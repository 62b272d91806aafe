#include "bench/peers/exact_motion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "arcway/datasets/catalog.h"
#include "arcway/datasets/random_queries.h"
#include "core/motion/clearance.h"

namespace arcway::internal::peers {
namespace {

TEST(ExactMotion, IsFreeExactlyIfTheBodyKeepsAway) {
  const World world = catalog_world("clutter/star/n30/m8/f30/s3");
  const QuerySet queries = make_reference_queries(world);
  const Vehicle vehicle;
  const Footprint body = checked_body(vehicle);
  int free = 0, blocked = 0;
  for (const PlanRequest& query : random_queries(world, queries, vehicle, {.count = 200, .min_distance = 0.0})) {
    // Both ends are free, so that a body that touches no edge on the way is in no obstacle either.
    const Path path = shortest_dubins_path(query.start, query.goal, vehicle.min_turning_radius());
    const bool keeps_away =
        std::ranges::all_of(path, [&](const PathSegment& s) { return clearance_along(s, body, world).distance > 0.0; });
    EXPECT_EQ(motion_free(*queries.sweep, body, path), keeps_away);
    ++(keeps_away ? free : blocked);
  }
  EXPECT_GT(free, 5);
  EXPECT_GT(blocked, 50);
}

TEST(ExactMotion, ShortestWordEndsAtTheGoal) {
  const Path path = shortest_dubins_path({0, 0, 0}, {3, 1, 2}, 1.3);
  ASSERT_FALSE(path.empty());
  EXPECT_NEAR(path.back().end().x, 3.0, 1e-12);
  EXPECT_NEAR(path.back().end().y, 1.0, 1e-12);
}

TEST(ExactMotion, TravelTimeIsFromRestToRest) {
  const Vehicle vehicle({.max_speed = 10.0, .turn_speed = ConstantTurnSpeed{8.0}, .max_acceleration = 5.0});
  const Path line{{{0, 0, 0}, 100.0, 0.0}};
  EXPECT_NEAR(travel_time(line, vehicle), 12.0, 1e-12);  // 2 s up, 80 m at 10 m/s, 2 s down
}

}  // namespace
}  // namespace arcway::internal::peers

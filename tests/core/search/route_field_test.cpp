#include "core/search/route_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <vector>

#include "arcway/angle.h"
#include "arcway/path.h"
#include "arcway/query_set.h"
#include "tests/support/boxes.h"
#include "tests/support/lazy_maps.h"

namespace arcway::internal {

using test::box_ring;

namespace {

// A wall with a gap in its middle, which ends in the open above.
RouteField field_behind_a_wall(double gap, const StopClock& clock = {}, std::span<const Path> avoided = {}) {
  const World world({{box_ring(9.0, -20.0, 10.0, -0.5 * gap), {}}, {box_ring(9.0, 0.5 * gap, 10.0, 20.0), {}}},
                    box_ring(-5.0, -20.0, 30.0, 30.0));
  const Vehicle vehicle;
  const Roadmap map = test::lazy_map(world, vehicle);
  return {map, {{0.0, 0.0, 0.3}, {20.0, 0.0, 0.0}, 100'000, avoided}, clock};
}

TEST(RouteField, LeadsThroughGapsThatAreWideEnough) {
  EXPECT_NEAR(field_behind_a_wall(1.0)({0.0, 0.0, 0.0}), 20.0, 2.0);
}

TEST(RouteField, LeadsRoundGapsThatAreTooNarrow) {
  const double round = 2.0 * std::hypot(9.5, 20.0);
  EXPECT_NEAR(field_behind_a_wall(0.7)({0.0, 0.0, 0.0}), round, 0.1 * round);
}

// A vehicle that faces away from the goal has to turn around first.
TEST(RouteField, HeedsTurns) {
  RouteField field = field_behind_a_wall(1.0);
  EXPECT_NEAR(field({0.0, 0.0, kPi}), 20.0, 2.0);
  field.heed_turns(1.3, {});
  EXPECT_NEAR(field({0.0, 0.0, 0.0}), 20.0, 2.0);
  EXPECT_GT(field({0.0, 0.0, kPi}), 21.5);
}

TEST(RouteField, HeedsNoTurnsOnceTheClockIsOver) {
  RouteField field = field_behind_a_wall(1.0);
  const double before = field({0.0, 0.0, kPi});
  field.heed_turns(1.3, StopClock(0.0));
  EXPECT_EQ(field({0.0, 0.0, kPi}), before);
}

TEST(RouteField, IsTheDistanceIfTheClockIsOverAtOnce) {
  RouteField field = field_behind_a_wall(0.7, StopClock(0.0));
  EXPECT_NEAR(field({0.0, 0.0, 0.0}), 20.0, 1e-9);
  field.heed_turns(1.3);
  EXPECT_NEAR(field({0.0, 0.0, 0.0}), 20.0, 1e-9);
}

// The way through the gap is 20 m long, the one round the wall twice as much.
TEST(RouteField, KeepsOffPaths) {
  const std::vector<Path> through{{{{0.0, 0.0, 0.0}, 20.0, 0.0}}};
  const double free = field_behind_a_wall(1.0)({0.0, 0.0, 0.0});
  const double once = field_behind_a_wall(1.0, {}, through)({0.0, 0.0, 0.0});
  EXPECT_GT(once, 1.2 * free);  // it leads beside the path where there is room
  EXPECT_LT(once, 1.6 * free);
  const std::vector<Path> often(4, through.front());
  const double round = field_behind_a_wall(1.0, {}, often)({0.0, 0.0, 0.0});
  EXPECT_GT(round, 2.0 * free);
  EXPECT_LT(round, 3.5 * free);  // not through the gap, for five times as much
}

TEST(RouteField, KeepsOffPathsWhereRoutesTurn) {
  const std::vector<Path> through{{{{0.0, 0.0, 0.0}, 20.0, 0.0}}};
  RouteField free = field_behind_a_wall(1.0), once = field_behind_a_wall(1.0, {}, through);
  free.heed_turns(1.3, {});
  once.heed_turns(1.3, {});
  EXPECT_GT(once({0.0, 0.0, 0.0}), 1.3 * free({0.0, 0.0, 0.0}));
}

TEST(RouteField, EndsAtThePlace) { EXPECT_NEAR(field_behind_a_wall(1.0)({20.0, 0.0, 0.0}), 0.0, 0.5); }

}  // namespace
}  // namespace arcway::internal
